// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/plot.hpp"
#include "app/figures/study/study_report.hpp"
#include "core/experiment/number_text.hpp"

#include <QColor>
#include <QString>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace tp {
namespace {

const QColor blue(20, 120, 200), grey(120, 120, 130);

QString text_of(const std::string& text) { return QString::fromStdString(text); }

std::optional<double> number_of(const std::string& level) {
    return number_in(std::string_view(level).substr(0, level.find(' ')), -1e6, 1e6);
}

/// A level's place along an axis: its number, else its rank.
double place_of(const Factor& factor, std::size_t level) {
    return number_of(factor.levels[level]).value_or(static_cast<double>(level + 1));
}

QString axis_words(const Factor& factor) {
    const std::string& first = factor.levels.front();
    const std::size_t space = first.find(' ');
    if (space != std::string::npos)
        return text_of(factor.name + ", " + first.substr(space + 1));
    QString words = text_of(factor.name) + ":";
    for (std::size_t level = 0; level < factor.levels.size(); ++level)
        words += QString(" %1 %2").arg(level + 1).arg(text_of(factor.levels[level]));
    return words;
}

/// Round what is shown, with some room.
std::pair<double, double> bounds(double low, double high) {
    const double room = std::max(0.08 * (high - low), 1e-6 + 0.02 * std::abs(high));
    return {low - room, high + room};
}

PlotPanel over_factor(const StudyMeasure& measure, std::size_t index) {
    const Factor& factor = measure.means.factors[index];
    PlotPanel panel;
    panel.title = text_of(measure.axis.substr(0, measure.axis.find(',')) + " by " + factor.name);
    PlotPanel::Line line{{}, blue, {}, false};
    double low = 1e300, high = -1e300, first = 1e300, last = -1e300;
    for (std::size_t level = 0; level < factor.levels.size(); ++level) {
        const LevelMean& mean = measure.levels[index].levels[level];
        const double x = place_of(factor, level), error = mean.standard_error.value_or(0.0);
        line.points.emplace_back(x, mean.mean);
        panel.lines.push_back({{}, grey, {{x, mean.mean - error}, {x, mean.mean + error}}, false});
        panel.dots.push_back({{x, mean.mean}, blue, false});
        low = std::min(low, mean.mean - error);
        high = std::max(high, mean.mean + error);
        first = std::min(first, x);
        last = std::max(last, x);
    }
    if (number_of(factor.levels.front())) // between words there is nothing
        panel.lines.push_back(std::move(line));
    const auto [left, right] = bounds(first, last);
    const auto [bottom, top] = bounds(low, high);
    panel.x = {axis_words(factor), left, right, false};
    panel.y = {text_of(measure.axis), bottom, top, false};
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
            plots.back().second.push_back(over_factor(measure, factor));
    }
    std::vector<std::string> names;
    for (const auto& [name, panels] : plots) {
        if (const auto written = write_plot(folder / name, panels); !written)
            return Error{written.error()};
        names.push_back(name);
    }
    return names;
}

} // namespace tp
