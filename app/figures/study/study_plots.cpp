// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/plot.hpp"
#include "app/figures/study/published_results.hpp"
#include "app/figures/study/study_report.hpp"
#include "core/experiment/number_text.hpp"

#include <QColor>
#include <QString>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace tp {
namespace {

const QColor blue(20, 120, 200), grey(120, 120, 130), red(214, 60, 40);
/// One a line, from the weakest to the strongest.
const std::array<QColor, 5> row_colours{QColor(200, 200, 60), QColor(230, 150, 20), QColor(30, 150, 70), blue,
                                        QColor(110, 60, 170)};

QString text_of(const std::string& text) { return QString::fromStdString(text); }

std::optional<double> number_of(const std::string& level) {
    return number_in(std::string_view(level).substr(0, level.find(' ')), -1e6, 1e6);
}

/// A level's place along an axis: its number, else its rank.
double place_of(const Factor& factor, std::size_t level) {
    return number_of(factor.levels[level]).value_or(static_cast<double>(level + 1));
}

/// "stiffness, N/mm", "shape"
QString axis_words(const Factor& factor) {
    const std::string& first = factor.levels.front();
    const std::size_t space = first.find(' ');
    const bool unit = number_of(first) && space != std::string::npos;
    return text_of(factor.name + (unit ? ", " + first.substr(space + 1) : std::string()));
}

/// A tick for each level: its number where it has one, else its name.
std::vector<std::pair<double, QString>> level_ticks(const Factor& factor) {
    std::vector<std::pair<double, QString>> ticks;
    for (std::size_t level = 0; level < factor.levels.size(); ++level) {
        const auto number = number_of(factor.levels[level]);
        ticks.emplace_back(place_of(factor, level),
                           number ? QString::number(*number, 'g', 4) : text_of(factor.levels[level]));
    }
    return ticks;
}

const QString error_bars =
    QStringLiteral("means and standard errors over participants; levels with a letter in common "
                   "do not differ (Tukey, 0.05)");

/// What was published of a level of this measure.
void add_published(PlotPanel& panel, const StudyReport& report, const StudyMeasure& measure,
                   const Factor& factor, double& low, double& high) {
    bool any = false;
    for (const PublishedResult& result : published_results())
        if (result.kind == PublishedResult::Kind::mean && result.experiment == report.experiment.name &&
            result.measure == measure.name)
            for (std::size_t level = 0; level < factor.levels.size(); ++level)
                if (factor.levels[level] == result.what) {
                    panel.dots.push_back({{place_of(factor, level), result.low}, red, true});
                    low = std::min(low, result.low);
                    high = std::max(high, result.high);
                    any = true;
                }
    if (any)
        panel.dot_names = {{QStringLiteral("here"), blue}, {QStringLiteral("published, people"), red, true}};
}

/// Round what is shown, with some room.
std::pair<double, double> bounds(double low, double high) {
    const double room = std::max(0.08 * (high - low), 1e-6 + 0.02 * std::abs(high));
    return {low - room, high + room};
}

PlotPanel over_factor(const StudyReport& report, const StudyMeasure& measure, std::size_t index) {
    const Factor& factor = measure.means.factors[index];
    PlotPanel panel;
    panel.title = text_of(measure.axis.substr(0, measure.axis.find(',')) + " by " + factor.name);
    panel.note = error_bars;
    PlotPanel::Line line{{}, blue, {}, false};
    double low = 1e300, high = -1e300, first = 1e300, last = -1e300;
    for (std::size_t level = 0; level < factor.levels.size(); ++level) {
        const LevelMean& mean = measure.levels[index].levels[level];
        const double x = place_of(factor, level), error = mean.standard_error.value_or(0.0);
        line.points.emplace_back(x, mean.mean);
        panel.lines.push_back({{}, grey, {{x, mean.mean - error}, {x, mean.mean + error}}, false});
        panel.dots.push_back({{x, mean.mean}, blue, false});
        panel.texts.push_back({{x, mean.mean + error}, text_of(mean.letters)});
        low = std::min(low, mean.mean - error);
        high = std::max(high, mean.mean + error);
        first = std::min(first, x);
        last = std::max(last, x);
    }
    if (number_of(factor.levels.front())) // between words there is nothing
        panel.lines.push_back(std::move(line));
    add_published(panel, report, measure, factor, low, high);
    const bool numbers = number_of(factor.levels.front()).has_value();
    const auto [left, right] = numbers ? bounds(first, last) : std::pair(first - 0.5, last + 0.5);
    const auto [bottom, top] = bounds(low, high + 0.15 * (high - low)); // room for the letters
    panel.x = {axis_words(factor), left, right, false, level_ticks(factor)};
    panel.y = {text_of(measure.axis), bottom, top, false};
    return panel;
}

/// Two factors with numbers, K x d: the second along the axis, a line for each level of the first.
std::optional<PlotPanel> over_two(const StudyMeasure& measure) {
    const std::vector<Factor>& factors = measure.means.factors;
    std::vector<std::size_t> numbered;
    for (std::size_t i = 0; i < factors.size() && numbered.size() < 2; ++i)
        if (number_of(factors[i].levels.front()))
            numbered.push_back(i);
    if (numbered.size() < 2 || factors[numbered[0]].levels.size() > row_colours.size())
        return std::nullopt;
    const Factor &rows = factors[numbered[0]], &columns = factors[numbered[1]];
    const std::size_t people = measure.means.participants.size();
    PlotPanel panel;
    panel.title =
        text_of(measure.axis.substr(0, measure.axis.find(',')) + " by " + rows.name + " and " + columns.name);
    panel.note = QStringLiteral("means and standard errors over participants");
    double low = 1e300, high = -1e300;
    for (std::size_t row = 0; row < rows.levels.size(); ++row) {
        PlotPanel::Line line{text_of(rows.levels[row]), row_colours[row], {}, false};
        for (std::size_t column = 0; column < columns.levels.size(); ++column) {
            double sum = 0.0, squares = 0.0;
            for (std::size_t person = 0; person < people; ++person) {
                double own = 0.0, cells = 0.0;
                for (std::size_t cell = 0; cell < measure.means.cells(); ++cell) {
                    std::size_t left = cell;
                    bool among = true;
                    for (std::size_t i = factors.size(); i-- > 0; left /= factors[i].levels.size()) {
                        const std::size_t level = left % factors[i].levels.size();
                        among = among && (i != numbered[0] || level == row) &&
                                (i != numbered[1] || level == column);
                    }
                    own += among ? measure.means.of(person)[cell] : 0.0;
                    cells += among ? 1.0 : 0.0;
                }
                sum += own / cells;
                squares += own / cells * (own / cells);
            }
            const auto count = static_cast<double>(people);
            const double mean = sum / count;
            const double variance =
                people < 2 ? 0.0 : std::max(0.0, squares - count * mean * mean) / (count - 1.0);
            const double error = std::sqrt(variance / count);
            // Beside each other, so that their bars can be told apart.
            const double x = place_of(columns, column) + 0.04 * (static_cast<double>(row) - 2.0) *
                                                             (place_of(columns, 1) - place_of(columns, 0));
            panel.lines.push_back({{}, row_colours[row], {{x, mean - error}, {x, mean + error}}, false});
            panel.dots.push_back({{x, mean}, row_colours[row], false});
            line.points.emplace_back(x, mean);
            low = std::min(low, mean - error);
            high = std::max(high, mean + error);
        }
        panel.lines.push_back(std::move(line));
    }
    const auto [left, right] = bounds(place_of(columns, 0), place_of(columns, columns.levels.size() - 1));
    const auto [bottom, top] = bounds(low, high + 0.3 * (high - low)); // room for the legend
    panel.x = {axis_words(columns), left, right, false, level_ticks(columns)};
    panel.y = {text_of(measure.axis), bottom, top, false};
    return panel;
}

/// Every published F beside ours, with the smallest and the largest over the studies.
PlotPanel beside_published(const std::vector<ComparedResult>& results, std::string_view measure) {
    PlotPanel panel;
    double low = 1e300, high = -1e300, at = 0.0;
    for (const ComparedResult& result : results) {
        if (result.published.measure != measure || result.published.kind != PublishedResult::Kind::f)
            continue;
        at += 1.0;
        const auto shown = [](double f) { return std::max(0.05, f); };
        panel.title =
            QStringLiteral("F of the ") + text_of(subject_words(result.published)).section(" by ", 0, 0);
        panel.x.names.emplace_back(at, text_of(std::string(result.published.what))
                                           .replace(QStringLiteral("stiffness"), QStringLiteral("K"))
                                           .replace(QStringLiteral("range"), QStringLiteral("d")));
        panel.lines.push_back({{}, grey, {{at, shown(result.least)}, {at, shown(result.most)}}, false});
        panel.dots.push_back({{at, shown(result.mean)}, blue, false});
        panel.dots.push_back({{at + 0.15, shown(result.published.low)}, red, true});
        low = std::min({low, shown(result.least), shown(result.published.low)});
        high = std::max({high, shown(result.most), shown(result.published.low)});
    }
    panel.note =
        QStringLiteral("bars: from the smallest to the largest of the studies; K stiffness, d range");
    panel.dot_names = {{QStringLiteral("here, mean of the studies"), blue},
                       {QStringLiteral("published, people"), red, true}};
    panel.legend_at_bottom = true;
    panel.x.low = 0.5;
    panel.x.high = at + 0.5;
    panel.y = {QStringLiteral("F"), 0.5 * low, 2.0 * high, true};
    return panel;
}

/// Every published mean beside ours.
PlotPanel means_beside_published(const std::vector<ComparedResult>& results, std::string_view measure) {
    PlotPanel panel;
    const double scale = measure == "right" ? 100.0 : 1.0;
    double high = 0.0, at = 0.0;
    for (const ComparedResult& result : results) {
        if (result.published.measure != measure || result.published.kind != PublishedResult::Kind::mean)
            continue;
        at += 1.0;
        panel.x.names.emplace_back(
            at, text_of(std::string(result.published.what.empty() ? "all" : result.published.what))
                    .replace(QStringLiteral(", "), QStringLiteral("\n")));
        panel.lines.push_back({{}, grey, {{at, scale * result.least}, {at, scale * result.most}}, false});
        panel.lines.push_back(
            {{},
             red,
             {{at + 0.2, scale * result.published.low}, {at + 0.2, scale * result.published.high}},
             false});
        panel.dots.push_back({{at, scale * result.mean}, blue, false});
        panel.dots.push_back({{at + 0.2, scale * result.published.low}, red, true});
        high = std::max({high, scale * result.most, scale * result.published.high});
    }
    panel.title = measure == "right" ? QStringLiteral("Named rightly") : QStringLiteral("Time");
    panel.note = QStringLiteral(
        "bars: from the smallest to the largest of the studies; published: a value, or from where to where");
    panel.dot_names = {{QStringLiteral("here, mean of the studies"), blue},
                       {QStringLiteral("published, people"), red, true}};
    panel.legend_at_bottom = true;
    panel.x.low = 0.5;
    panel.x.high = at + 0.5;
    panel.y = {measure == "right" ? QStringLiteral("named rightly, %") : QStringLiteral("time, s"), 0.0,
               1.1 * high, false};
    return panel;
}

/// A dot a condition: how well against how long.
PlotPanel speed_against_error(const StudyMeasure& measure, const StudyMeasure& time) {
    PlotPanel panel;
    panel.title = QStringLiteral("each condition, over participants");
    double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
    for (std::size_t cell = 0; cell < measure.means.cells(); ++cell) {
        Vec2 mean(0.0);
        for (std::size_t i = 0; i < measure.means.participants.size(); ++i)
            mean.x += measure.means.of(i)[cell] / static_cast<double>(measure.means.participants.size());
        for (std::size_t i = 0; i < time.means.participants.size(); ++i)
            mean.y += time.means.of(i)[cell] / static_cast<double>(time.means.participants.size());
        panel.dots.push_back({mean, blue, true});
        left = std::min(left, mean.x);
        right = std::max(right, mean.x);
        low = std::min(low, mean.y);
        high = std::max(high, mean.y);
    }
    std::tie(left, right) = bounds(left, right);
    std::tie(low, high) = bounds(low, high);
    panel.x = {text_of(measure.axis), left, right, false};
    panel.y = {text_of(time.axis), low, high, false};
    return panel;
}

} // namespace

Result<std::vector<std::string>> plot_study(const std::filesystem::path& folder, const StudyReport& report) {
    std::vector<std::pair<std::string, std::vector<PlotPanel>>> plots;
    if (report.measures.size() == 2)
        plots.push_back({"speed", {speed_against_error(report.measures[0], report.measures[1])}});
    for (const StudyMeasure& measure : report.measures) {
        plots.push_back({measure.name, {}});
        for (std::size_t factor = 0; factor < measure.means.factors.size(); ++factor)
            plots.back().second.push_back(over_factor(report, measure, factor));
        if (auto two = over_two(measure))
            plots.back().second.push_back(std::move(*two));
    }
    std::vector<std::string> names;
    for (const auto& [name, panels] : plots) {
        if (const auto written = write_plot(folder / name, panels); !written)
            return Error{written.error()};
        names.push_back(name);
    }
    return names;
}

Result<bool> plot_published(const std::filesystem::path& folder, const std::vector<ComparedResult>& results) {
    std::vector<PlotPanel> panels;
    for (const std::string_view measure : {"error_mm", "right", "time_s"})
        for (const bool of_means : {false, true}) {
            PlotPanel panel =
                of_means ? means_beside_published(results, measure) : beside_published(results, measure);
            if (!panel.dots.empty())
                panels.push_back(std::move(panel));
        }
    if (panels.empty())
        return false;
    const auto written = write_plot(folder / "published", panels);
    return written ? Result<bool>(true) : Error{written.error()};
}

} // namespace tp
