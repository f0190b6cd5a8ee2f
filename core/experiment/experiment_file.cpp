// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/experiment_file.hpp"

#include "core/experiment/number_text.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace tp {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_word(std::string_view text) {
    return !text.empty() && text.size() <= 60 && std::ranges::all_of(text, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    });
}

/// What is wrong with a line, the end of a sentence.
using Problem = std::string;

/// Without the unit at its end; nothing where that is missing.
std::optional<std::string_view> without_unit(std::string_view text, std::string_view unit) {
    if (unit.empty())
        return text;
    if (!text.ends_with(unit))
        return std::nullopt;
    return trimmed(text.substr(0, text.size() - unit.size()));
}

Problem take_whole(std::string_view text, int least, int most, int& into) {
    const auto value = number_in(text, least, most);
    if (!value)
        return "needs a whole number from " + std::to_string(least) + " to " + std::to_string(most);
    into = *value;
    return {};
}

/// A value as it is kept: numbers in their shortest form, so that "0.10" and "0.1" are one level.
Problem take_level(const StudyParameterKind& kind, std::string_view text, std::vector<std::string>& levels) {
    std::string level;
    if (!kind.words.empty()) {
        if (std::ranges::find(kind.words, text) == kind.words.end()) {
            std::string known;
            for (const std::string_view word : kind.words)
                known += (known.empty() ? "" : ", ") + std::string(word);
            return "knows only " + known;
        }
        level = text;
    } else {
        const auto value = number_in(text, kind.least, kind.most);
        if (!value)
            return "needs numbers from " + shortest(kind.least) + " to " + shortest(kind.most);
        level = shortest(*value);
    }
    if (std::ranges::find(levels, level) != levels.end())
        return "has " + level + " twice";
    levels.push_back(std::move(level));
    return {};
}

Problem take_factor(std::string_view name, std::string_view value, StudyFactor& factor) {
    const auto parameter = parameter_named(name);
    if (!parameter)
        return "speaks of what is no parameter";
    const StudyParameterKind& kind = kind_of(*parameter);
    factor.parameter = *parameter;
    auto rest = without_unit(value, kind.unit);
    if (!rest)
        return "needs its unit at the end, " + std::string(kind.unit);
    while (true) {
        const std::size_t comma = rest->find(',');
        if (Problem problem = take_level(kind, trimmed(rest->substr(0, comma)), factor.levels);
            !problem.empty())
            return problem;
        if (comma == std::string_view::npos)
            return {};
        rest = rest->substr(comma + 1);
    }
}

Problem take_surface(std::string_view text, Experiment& experiment) {
    const auto sides = without_unit(text, "mm");
    const std::size_t by = sides ? sides->find(" x ") : std::string_view::npos;
    if (by == std::string_view::npos)
        return "needs a width and a height: 200 x 200 mm";
    const auto width = number_in(trimmed(sides->substr(0, by)), 20.0, 1000.0);
    const auto height = number_in(trimmed(sides->substr(by + 3)), 20.0, 1000.0);
    if (!width || !height)
        return "needs sides from 20 to 1000 mm";
    experiment.surface_width_mm = *width;
    experiment.surface_height_mm = *height;
    return {};
}

Problem take_seconds(std::string_view text, std::optional<double>& into) {
    const auto seconds = without_unit(text, "s");
    into = seconds ? number_in(*seconds, 1.0, 3600.0) : std::nullopt;
    return into ? "" : "needs seconds from 1 to 3600: 60 s";
}

template <typename Value>
Problem take_one(std::string_view text, Value& into, std::string_view first, Value one,
                 std::string_view second, Value other) {
    if (text != first && text != second)
        return "needs " + std::string(first) + " or " + std::string(second);
    into = text == first ? one : other;
    return {};
}

Problem take_line(std::string_view key, std::string_view value, Experiment& experiment) {
    if (key == "experiment") {
        experiment.name = value;
        return is_word(value) ? "" : "needs one word of letters, digits, - and _";
    }
    if (key == "title") {
        experiment.title = value;
        return value.empty() || value.size() > 200 ? "needs some words, at most 200 bytes" : "";
    }
    if (key == "task")
        return take_one(value, experiment.task, "follow", StudyTask::follow, "name", StudyTask::name);
    if (key == "order")
        return take_one(value, experiment.order, "random", StudyOrder::random, "latin-square",
                        StudyOrder::latin_square);
    if (key == "answer") {
        experiment.answer = parameter_named(value);
        return experiment.answer ? "" : "speaks of what is no parameter";
    }
    if (key == "repetitions")
        return take_whole(value, 1, 100, experiment.repetitions);
    if (key == "training")
        return take_whole(value, 0, 100, experiment.training);
    if (key == "break after")
        return take_whole(value, 1, 1000, experiment.trials_between_breaks);
    if (key == "longest trial")
        return take_seconds(value, experiment.longest_trial_s);
    if (key == "longest training")
        return take_seconds(value, experiment.longest_training_s);
    if (key == "surface")
        return take_surface(value, experiment);
    for (const auto& [word, factors] :
         {std::pair(std::string_view("factor "), &experiment.factors),
          std::pair(std::string_view("set "), &experiment.settings),
          std::pair(std::string_view("training "), &experiment.training_factors)})
        if (key.starts_with(word)) {
            StudyFactor factor;
            Problem problem = take_factor(trimmed(key.substr(word.size())), value, factor);
            if (problem.empty() && factors != &experiment.training_factors &&
                (factors == &experiment.settings) != (factor.levels.size() == 1))
                problem = factors == &experiment.settings ? "sets more than one value"
                                                          : "needs at least two values";
            factors->push_back(std::move(factor));
            return problem;
        }
    return "is not understood";
}

/// What is wrong with all of it together, a sentence.
std::string fault_of(const Experiment& experiment) {
    if (experiment.name.empty())
        return "The experiment has no name: a line \"experiment: NAME\" is missing.";
    if (experiment.factors.empty())
        return "The experiment varies nothing: a line \"factor …\" is missing.";
    std::set<StudyParameter> parameters;
    for (const auto* const factors : {&experiment.factors, &experiment.settings})
        for (const StudyFactor& factor : *factors)
            if (!parameters.insert(factor.parameter).second)
                return "The experiment speaks twice of " + std::string(kind_of(factor.parameter).name) + ".";
    parameters.clear();
    for (const StudyFactor& factor : experiment.training_factors) {
        const std::string name(kind_of(factor.parameter).name);
        if (!parameters.insert(factor.parameter).second)
            return "The experiment speaks twice of " + name + " in training.";
        if (std::ranges::find(experiment.factors, factor.parameter, &StudyFactor::parameter) ==
            experiment.factors.end())
            return "The " + name + " can be another in training only where it is a factor.";
    }
    std::size_t conditions = 1;
    for (const StudyFactor& factor : experiment.factors)
        if ((conditions *= factor.levels.size()) > most_study_trials)
            break;
    if (conditions * static_cast<std::size_t>(experiment.repetitions) > most_study_trials)
        return "The experiment has more than " + std::to_string(most_study_trials) + " trials.";
    const bool names = experiment.task == StudyTask::name;
    if (names != experiment.answer.has_value())
        return names ? "The experiment does not say what is to be named: a line \"answer: …\" is missing."
                     : "Where a contour is followed there is no answer.";
    if (names && std::ranges::find(experiment.factors, *experiment.answer, &StudyFactor::parameter) ==
                     experiment.factors.end())
        return "What is to be named must be a factor.";
    return {};
}

} // namespace

Result<Experiment> read_experiment(std::string_view text) {
    if (text.size() > most_experiment_bytes)
        return Error{"The experiment is longer than " + std::to_string(most_experiment_bytes / 1024) +
                     " KB."};
    Experiment experiment;
    std::set<std::string> once;
    bool has_task = false;
    int line_number = 0;
    for (std::string_view rest = text; !rest.empty();) {
        ++line_number;
        const std::size_t end = rest.find('\n');
        const std::string_view line = trimmed(rest.substr(0, end));
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
        if (line.empty() || line.starts_with('#'))
            continue;
        const std::size_t colon = line.find(':');
        const std::string key(trimmed(line.substr(0, colon)));
        Problem problem = "has no colon";
        if (colon != std::string_view::npos)
            problem = once.insert(key).second ? take_line(key, trimmed(line.substr(colon + 1)), experiment)
                                              : "says it a second time";
        if (!problem.empty())
            return Error{"Line " + std::to_string(line_number) + " of the experiment " + problem + "."};
        has_task = has_task || key == "task";
    }
    if (!has_task)
        return Error{"The experiment does not say what is done: a line \"task: follow\" or \"task: name\" is "
                     "missing."};
    if (std::string fault = fault_of(experiment); !fault.empty())
        return Error{std::move(fault)};
    return experiment;
}

std::string experiment_text(const Experiment& experiment) {
    std::string text = "experiment: " + experiment.name + "\n";
    if (!experiment.title.empty())
        text += "title: " + experiment.title + "\n";
    text += std::string("task: ") + (experiment.task == StudyTask::follow ? "follow" : "name") + "\n";
    for (const auto& [word, factors] :
         {std::pair("factor ", &experiment.factors), std::pair("set ", &experiment.settings),
          std::pair("training ", &experiment.training_factors)})
        for (const StudyFactor& factor : *factors) {
            text += word + std::string(kind_of(factor.parameter).name) + ": ";
            for (std::size_t i = 0; i < factor.levels.size(); ++i)
                text += (i == 0 ? "" : ", ") +
                        (i + 1 == factor.levels.size() ? level_words(factor, i) : factor.levels[i]);
            text += "\n";
        }
    if (experiment.answer)
        text += "answer: " + std::string(kind_of(*experiment.answer).name) + "\n";
    text +=
        std::string("order: ") + (experiment.order == StudyOrder::random ? "random" : "latin-square") + "\n";
    text += "repetitions: " + std::to_string(experiment.repetitions) + "\n";
    text += "training: " + std::to_string(experiment.training) + "\n";
    if (experiment.trials_between_breaks > 0)
        text += "break after: " + std::to_string(experiment.trials_between_breaks) + "\n";
    if (experiment.longest_trial_s)
        text += "longest trial: " + shortest(*experiment.longest_trial_s) + " s\n";
    if (experiment.longest_training_s)
        text += "longest training: " + shortest(*experiment.longest_training_s) + " s\n";
    return text + "surface: " + shortest(experiment.surface_width_mm) + " x " +
           shortest(experiment.surface_height_mm) + " mm\n";
}

} // namespace tp
