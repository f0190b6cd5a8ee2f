// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/experiment.hpp"

#include <algorithm>
#include <array>

namespace tp {
namespace {

constexpr std::array<std::string_view, 2> laws{"exact", "published"};
constexpr std::array<std::string_view, 4> paths{"circle", "triangle", "curve", "line"};
constexpr std::array<std::string_view, 8> shapes{"circle",  "triangle", "square",      "pentagon",
                                                 "hexagon", "line",     "broken-line", "curve"};
constexpr std::array<std::string_view, 4> expressions{"smiling", "surprised", "sad", "angry"};

/// In the order of StudyParameter.
constexpr std::array<StudyParameterKind, study_parameter_count> kinds{
    {{"stiffness", "N/mm", 0.01, 2.0, {}},
     {"range", "mm", 0.5, 50.0, {}},
     {"law", "", 0.0, 0.0, laws},
     {"path", "", 0.0, 0.0, paths},
     {"shape", "", 0.0, 0.0, shapes},
     {"radius", "mm", 5.0, 100.0, {}},
     {"expression", "", 0.0, 0.0, expressions},
     {"face", "", 1.0, 1000.0, {}}}};

} // namespace

const StudyParameterKind& kind_of(StudyParameter parameter) {
    return kinds[static_cast<std::size_t>(parameter)];
}

std::optional<StudyParameter> parameter_named(std::string_view name) {
    const auto found = std::ranges::find(kinds, name, &StudyParameterKind::name);
    if (found == kinds.end())
        return std::nullopt;
    return static_cast<StudyParameter>(found - kinds.begin());
}

Experiment Experiment::in_training() const {
    Experiment same = *this;
    for (const StudyFactor& factor : training_factors)
        for (StudyFactor& own : same.factors)
            if (own.parameter == factor.parameter)
                own.levels = factor.levels;
    return same;
}

bool Experiment::asks(bool in_training) const {
    if (!answer || !in_training)
        return answer.has_value();
    const auto own = std::ranges::find(factors, *answer, &StudyFactor::parameter);
    const auto trained = std::ranges::find(training_factors, *answer, &StudyFactor::parameter);
    return trained == training_factors.end() ||
           std::ranges::all_of(trained->levels, [&](const std::string& level) {
               return std::ranges::find(own->levels, level) != own->levels.end();
           });
}

std::size_t Experiment::conditions() const {
    std::size_t count = 1;
    for (const StudyFactor& factor : factors)
        count *= factor.levels.size();
    return count;
}

std::vector<std::size_t> Experiment::levels_of(std::size_t condition) const {
    std::vector<std::size_t> levels(factors.size());
    for (std::size_t i = factors.size(); i-- > 0;) {
        levels[i] = condition % factors[i].levels.size();
        condition /= factors[i].levels.size();
    }
    return levels;
}

std::size_t Experiment::condition_of(const std::vector<std::size_t>& levels) const {
    std::size_t condition = 0;
    for (std::size_t i = 0; i < factors.size(); ++i)
        condition = condition * factors[i].levels.size() + levels[i];
    return condition;
}

std::string Experiment::value_of(StudyParameter parameter, std::size_t condition) const {
    const std::vector<std::size_t> levels = levels_of(condition);
    for (std::size_t i = 0; i < factors.size(); ++i)
        if (factors[i].parameter == parameter)
            return factors[i].levels[levels[i]];
    const auto set = std::ranges::find(settings, parameter, &StudyFactor::parameter);
    return set == settings.end() ? std::string() : set->levels.front();
}

std::string level_words(const StudyFactor& factor, std::size_t level) {
    const std::string_view unit = kind_of(factor.parameter).unit;
    return factor.levels[level] + (unit.empty() ? "" : " ") + std::string(unit);
}

} // namespace tp
