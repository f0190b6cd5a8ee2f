// SPDX-License-Identifier: Apache-2.0
#include "experiment_check.hpp"

#include "core/experiment/experiment_file.hpp"
#include "core/experiment/trial_order.hpp"
#include "core/experiment/trial_table.hpp"

namespace tp::test {
namespace {

bool is_sentence(const std::string& text) {
    return text.size() > 10 && text.ends_with('.') && text.find('\n') == std::string::npos;
}

} // namespace

std::string complaint_about_experiment(std::string_view text) {
    const auto experiment = read_experiment(text);
    if (!experiment)
        return is_sentence(experiment.error()) ? "" : "no sentence: " + experiment.error();
    if (experiment->trials() > most_study_trials)
        return "more trials than there may be";
    const std::string written = experiment_text(*experiment);
    const auto again = read_experiment(written);
    if (!again)
        return "refused when it was written: " + again.error();
    if (experiment_text(*again) != written)
        return "another one when it was written";
    const auto trials = trials_of(*experiment, 1, 1);
    if (trials.size() != experiment->trials() + static_cast<std::size_t>(experiment->training))
        return "another number of trials";
    for (const PlannedTrial& trial : trials) {
        const Experiment from = trial.training ? experiment->in_training() : *experiment;
        if (trial.condition >= from.conditions())
            return "a condition that there is not";
        if (from.condition_of(from.levels_of(trial.condition)) != trial.condition)
            return "levels of another condition";
    }
    return {};
}

std::string complaint_about_trials(std::string_view csv) {
    const Experiment experiment = small_experiment();
    const auto table = read_trials(experiment, csv);
    if (!table)
        return is_sentence(table.error()) ? "" : "no sentence: " + table.error();
    std::string written = trial_columns(experiment);
    for (const TrialRecord& record : table->records)
        written += trial_line(experiment, record);
    const auto again = read_trials(experiment, written);
    if (!again)
        return "refused when it was written: " + again.error();
    if (again->records != table->records || again->torn)
        return "another one when it was written";
    return {};
}

Experiment small_experiment() {
    return read_experiment(
               "experiment: small\ntask: name\nfactor shape: circle, square\nfactor radius: 20, 50 mm\n"
               "set stiffness: 0.5 N/mm\nanswer: shape\nrepetitions: 2\ntraining: 1\n")
        .value();
}

} // namespace tp::test
