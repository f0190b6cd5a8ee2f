// SPDX-License-Identifier: Apache-2.0
#include "app/figures/study/published_results.hpp"

#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

namespace tp {
namespace {

using Kind = PublishedResult::Kind;
constexpr std::string_view tracking = "tracking", primitives = "primitives", expressions = "expressions";
constexpr std::string_view error = "error_mm", time = "time_s", right = "right";

/// Lim, Yoo and Choi (2019), Experiments I to III.
constexpr std::array results{
    PublishedResult{Kind::f, tracking, error, "stiffness", 27.65, 27.65},
    PublishedResult{Kind::f, tracking, error, "range", 41.97, 41.97},
    PublishedResult{Kind::f, tracking, error, "path", 2.59, 2.59, false},
    PublishedResult{Kind::f, tracking, error, "stiffness × range", 6.67, 6.67},
    PublishedResult{Kind::falls, tracking, error, "stiffness"},
    PublishedResult{Kind::falls, tracking, error, "range"},
    PublishedResult{Kind::saturates, tracking, error, "stiffness"},
    PublishedResult{Kind::saturates, tracking, error, "range"},
    PublishedResult{Kind::f, tracking, time, "stiffness", 30.14, 30.14},
    PublishedResult{Kind::f, tracking, time, "range", 30.0, 30.0},
    PublishedResult{Kind::f, tracking, time, "path", 43.01, 43.01},
    PublishedResult{Kind::f, tracking, time, "stiffness × range", 16.4, 16.4},
    PublishedResult{Kind::f, tracking, time, "stiffness × path", 8.7, 8.7},
    PublishedResult{Kind::f, tracking, time, "range × path", 11.06, 11.06},
    PublishedResult{Kind::f, tracking, time, "stiffness × range × path", 4.29, 4.29},
    PublishedResult{Kind::falls, tracking, time, "stiffness"},
    PublishedResult{Kind::falls, tracking, time, "range"},
    PublishedResult{Kind::saturates, tracking, time, "stiffness"},
    PublishedResult{Kind::saturates, tracking, time, "range"},
    PublishedResult{Kind::f, primitives, right, "shape", 3.74, 3.74},
    PublishedResult{Kind::f, primitives, right, "radius", 27.0, 27.0},
    PublishedResult{Kind::f, primitives, right, "shape × radius", 8.59, 8.59},
    PublishedResult{Kind::smallest, primitives, right, "20 mm"},
    PublishedResult{Kind::mean, primitives, right, "pentagon, 20 mm", 0.63, 0.63},
    PublishedResult{Kind::mean, primitives, right, "hexagon, 20 mm", 0.70, 0.70},
    PublishedResult{Kind::mean, primitives, right, "pentagon, 50 mm", 0.90, 1.0},
    PublishedResult{Kind::mean, primitives, right, "hexagon, 50 mm", 0.90, 1.0},
    PublishedResult{Kind::mean, primitives, right, "pentagon, 80 mm", 0.90, 1.0},
    PublishedResult{Kind::mean, primitives, right, "hexagon, 80 mm", 0.90, 1.0},
    PublishedResult{Kind::f, primitives, time, "shape", 16.35, 16.35},
    PublishedResult{Kind::f, primitives, time, "radius", 0.58, 0.58, false},
    PublishedResult{Kind::smallest, primitives, time, "circle"},
    PublishedResult{Kind::mean, primitives, time, "circle", 7.9, 7.9},
    PublishedResult{Kind::mean, primitives, time, "hexagon", 21.2, 21.2},
    PublishedResult{Kind::mean, expressions, right, "smiling", 0.975, 0.975},
    PublishedResult{Kind::mean, expressions, right, "surprised", 0.975, 0.975},
    PublishedResult{Kind::mean, expressions, right, "sad", 0.8, 0.8},
    PublishedResult{Kind::mean, expressions, right, "angry", 0.8, 0.8},
    PublishedResult{Kind::mean, expressions, time, "", 20.0, 30.0},
};

std::string with_digits(double value, int digits) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*f", digits, value);
    return text.data();
}

const StudyMeasure* measure_of(const StudyReport& study, std::string_view name) {
    const auto found = std::ranges::find(study.measures, name, &StudyMeasure::name);
    return found == study.measures.end() ? nullptr : &*found;
}

const WithinEffect* effect_of(const StudyMeasure& measure, std::string_view words) {
    const auto found = std::ranges::find_if(measure.anova.effects, [&](const WithinEffect& effect) {
        return words_for(effect, measure.means.factors) == words;
    });
    return found == measure.anova.effects.end() ? nullptr : &*found;
}

/// The mean over participants and over all cells whose levels are among those named, "hexagon, 20 mm"; all of them where none is.
std::optional<double> mean_of(const StudyMeasure& measure, std::string_view levels) {
    const WithinMeans& means = measure.means;
    double sum = 0.0, count = 0.0;
    for (std::size_t cell = 0; cell < means.cells(); ++cell) {
        std::string_view rest = levels;
        bool among = true;
        while (!rest.empty() && among) {
            const std::size_t comma = rest.find(", ");
            const std::string_view level = rest.substr(0, comma);
            rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 2);
            std::size_t left = cell;
            among = false;
            for (std::size_t i = means.factors.size(); i-- > 0;) {
                const std::size_t all = means.factors[i].levels.size();
                among = among || means.factors[i].levels[left % all] == level;
                left /= all;
            }
        }
        for (std::size_t i = 0; among && i < means.participants.size(); ++i) {
            sum += means.of(i)[cell];
            count += 1.0;
        }
    }
    return count == 0.0 ? std::nullopt : std::optional(sum / count);
}

/// The levels of the factor of that name, or of that which has this level.
const Pairwise* levels_of(const StudyMeasure& measure, std::string_view factor_or_level) {
    for (std::size_t i = 0; i < measure.levels.size(); ++i)
        if (measure.means.factors[i].name == factor_or_level ||
            std::ranges::find(measure.means.factors[i].levels, factor_or_level) !=
                measure.means.factors[i].levels.end())
            return &measure.levels[i];
    return nullptr;
}

bool share_a_letter(const LevelMean& one, const LevelMean& other) {
    return std::ranges::any_of(one.letters,
                               [&](char letter) { return other.letters.find(letter) != std::string::npos; });
}

/// What one study gives for it; nothing: it says nothing.
std::optional<double> value_in(const StudyReport& study, const PublishedResult& result) {
    const StudyMeasure* const measure = measure_of(study, result.measure);
    if (measure == nullptr)
        return std::nullopt;
    if (result.kind == Kind::mean)
        return mean_of(*measure, result.what);
    if (result.kind == Kind::f) {
        const WithinEffect* const effect = effect_of(*measure, result.what);
        return effect == nullptr ? std::nullopt : effect->f;
    }
    const Pairwise* const pairwise = levels_of(*measure, result.what);
    if (pairwise == nullptr || pairwise->levels.size() < 2)
        return std::nullopt;
    const std::vector<LevelMean>& levels = pairwise->levels;
    switch (result.kind) {
    case Kind::falls:
        return levels.back().mean < levels.front().mean ? 1.0 : 0.0;
    case Kind::saturates:
        return share_a_letter(levels[levels.size() - 2], levels.back()) ? 1.0 : 0.0;
    default:
        return std::ranges::min_element(levels, {}, &LevelMean::mean)->level == result.what ? 1.0 : 0.0;
    }
}

bool is_significant(const StudyReport& study, const PublishedResult& result) {
    const StudyMeasure* const measure = measure_of(study, result.measure);
    const WithinEffect* const effect = measure == nullptr ? nullptr : effect_of(*measure, result.what);
    return effect != nullptr && effect->p_spherical.value_or(1.0) < 0.05;
}

bool alike(std::span<const StudyReport> studies, const ComparedResult& result) {
    const PublishedResult& published = result.published;
    switch (published.kind) {
    case Kind::f: {
        const auto same = std::ranges::count_if(studies, [&](const StudyReport& study) {
            return is_significant(study, published) == published.significant;
        });
        return 2 * same > std::ssize(studies);
    }
    case Kind::mean:
        if (published.measure == time)
            return result.mean >= 0.5 * published.low && result.mean <= 2.0 * published.high;
        return result.mean >= published.low - 0.1 - 1e-9 && result.mean <= published.high + 0.1 + 1e-9;
    default:
        return result.mean > 0.5;
    }
}

std::string_view kind_words(Kind kind) {
    constexpr std::array<std::string_view, 5> words{"F", "mean", "falls", "smallest", "saturates"};
    return words[static_cast<std::size_t>(kind)];
}

} // namespace

std::span<const PublishedResult> published_results() { return results; }

std::vector<ComparedResult> compared_results(std::span<const StudyReport> studies) {
    std::vector<ComparedResult> compared;
    if (studies.empty())
        return compared;
    for (const PublishedResult& result : results) {
        if (result.experiment != studies.front().experiment.name)
            continue;
        ComparedResult one{result, {}};
        for (const StudyReport& study : studies)
            if (const auto value = value_in(study, result))
                one.ours.push_back(*value);
        if (one.ours.empty())
            continue;
        for (const double value : one.ours)
            one.mean += value / static_cast<double>(one.ours.size());
        one.least = *std::ranges::min_element(one.ours);
        one.most = *std::ranges::max_element(one.ours);
        one.alike = alike(studies, one);
        compared.push_back(std::move(one));
    }
    return compared;
}

std::string published_words(const PublishedResult& result) {
    const bool one = result.low == result.high;
    switch (result.kind) {
    case Kind::f:
        return "F = " + with_digits(result.low, 2) + (result.significant ? "" : ", not significant");
    case Kind::mean:
        if (result.measure == time)
            return with_digits(result.low, one ? 1 : 0) + (one ? "" : " to " + with_digits(result.high, 0)) +
                   " s";
        return (one ? "" : "at least ") + with_digits(100.0 * result.low, 1) + " %";
    case Kind::smallest:
        return std::string(result.what) + " is smallest";
    default:
        return std::string(kind_words(result.kind));
    }
}

std::string subject_words(const PublishedResult& result) {
    const std::string measure = result.measure == error  ? "error"
                                : result.measure == time ? "time"
                                                         : "named rightly";
    if (result.kind == Kind::f || result.kind == Kind::falls || result.kind == Kind::saturates)
        return measure + " by " + std::string(result.what);
    if (result.kind == Kind::smallest)
        return measure;
    return measure + (result.what.empty() ? "" : ", ") + std::string(result.what);
}

std::string our_words(const ComparedResult& result) {
    const bool share = result.published.kind == Kind::mean && result.published.measure == right;
    switch (result.published.kind) {
    case Kind::f:
    case Kind::mean: {
        const double scale = share ? 100.0 : 1.0;
        const int digits = result.published.kind == Kind::f ? 2 : 1;
        const std::string unit = share ? " %" : result.published.kind == Kind::mean ? " s" : "";
        const std::string mean = with_digits(scale * result.mean, digits) + unit;
        return result.ours.size() == 1 ? mean
                                       : mean + " (" + with_digits(scale * result.least, digits) + " to " +
                                             with_digits(scale * result.most, digits) + ")";
    }
    default:
        return "in " + with_digits(result.mean * static_cast<double>(result.ours.size()), 0) + " of " +
               std::to_string(result.ours.size());
    }
}

CsvTable published_table(std::span<const ComparedResult> compared) {
    CsvTable table({"kind", "measure", "what", "published_low", "published_high", "significant", "mean",
                    "least", "most", "studies", "alike"});
    for (const ComparedResult& result : compared) {
        const bool number = result.published.kind == Kind::f || result.published.kind == Kind::mean;
        table.add({std::string(kind_words(result.published.kind)), std::string(result.published.measure),
                   std::string(result.published.what), number ? cell(result.published.low) : "",
                   number ? cell(result.published.high) : "",
                   result.published.kind == Kind::f ? (result.published.significant ? "yes" : "no") : "",
                   cell(result.mean), cell(result.least), cell(result.most),
                   std::to_string(result.ours.size()), result.alike ? "yes" : "no"});
    }
    return table;
}

std::string write_comparison(const std::filesystem::path& folder, std::span<const StudyReport> studies) {
    const auto compared = compared_results(studies);
    if (compared.empty())
        return "Nothing was published of the experiment " +
               (studies.empty() ? std::string() : studies.front().experiment.name) + ".";
    if (const std::string reason = make_folder(folder); !reason.empty())
        return "The folder " + quoted(folder) + " cannot be made: " + reason;
    if (const auto written = published_table(compared).write(folder / "published.csv"); !written)
        return written.error();
    if (const auto drawn = plot_published(folder, compared); !drawn)
        return drawn.error();
    const std::filesystem::path page = folder / "published.html";
    const std::string reason = replace_file(page, comparison_page(studies, compared));
    return reason.empty() ? std::string() : "The page " + quoted(page) + " cannot be written: " + reason;
}

} // namespace tp
