// SPDX-License-Identifier: Apache-2.0
#include "core/study_folder/study_readme.hpp"

#include <cstddef>
#include <string_view>

namespace tp {
namespace {

constexpr std::size_t column_width = 14;

std::string row(std::string_view name, std::string_view words) {
    std::string line = "  " + std::string(name);
    line.append(name.size() < column_width ? column_width - name.size() : 1, ' ');
    return line + std::string(words) + "\n";
}

std::string factor_words(const StudyFactor& factor) {
    const StudyParameterKind& kind = kind_of(factor.parameter);
    std::string words = "factor, ";
    words +=
        kind.unit.empty() ? (kind.words.empty() ? "a number" : "a word") : "in " + std::string(kind.unit);
    words += ": ";
    for (const std::string& level : factor.levels)
        words += (&level == &factor.levels.front() ? "" : ", ") + level;
    return words;
}

/// "; in training line, curve"; empty where training has the same levels.
std::string training_words(const Experiment& experiment, StudyParameter parameter) {
    std::string words;
    for (const StudyFactor& factor : experiment.training_factors)
        if (factor.parameter == parameter)
            for (const std::string& level : factor.levels)
                words += (words.empty() ? "; in training " : ", ") + level;
    return words;
}

} // namespace

std::string study_readme(const Experiment& experiment) {
    std::string text = "A study made with TouchPhoto: experiment " + experiment.name;
    text += experiment.title.empty() ? "\n" : "\n" + experiment.title + "\n";
    text += "\nParticipants are numbers; no name is in any file. All tables are CSV (RFC 4180): commas, a "
            "point in\n"
            "numbers, the first line names the columns, text is UTF-8.\n"
            "\nFiles\n" +
            row("protocol.study", "the experiment: what varies, how often, in which order; lines of text") +
            row("study.txt", "seed: the number from which, with a participant's own, the order of the") +
            row("", "trials and their seeds follow; participants: people, or simulated") +
            row("sittings.csv", "with which machine trials were done") +
            row("participant-NNN.csv", "what came of each trial of participant NNN, in the order of doing") +
            row("paths/participant-NNN-trial-MMMM.csv.gz", "") +
            row("", "where the finger was in trial MMMM of participant NNN; gzip") +
            row("running.txt",
                "only while a trial runs, or where the program was killed in one: its path's name") +
            "\nColumns of participant-NNN.csv, a line a trial\n" +
            row("experiment", "the experiment's name") + row("participant", "number of the person, from 1") +
            row("trial", "number of the trial of this person, from 1; training and repeated ones too") +
            row("repetition", "which time the condition is met, from 1") +
            row("training", "yes: the trial does not count; no");
    for (const StudyFactor& factor : experiment.factors)
        text += row(kind_of(factor.parameter).name,
                    factor_words(factor) + training_words(experiment, factor.parameter));
    text += row("error_mm", "mm: mean distance of the finger from the path, over the samples of the trial;") +
            row("", "empty: no path was followed") +
            row("time_s", "s: from the start of the trial to its end, or to the answer") +
            row("answer", "where something is named: what was answered; empty: nothing in time") +
            row("correct", "yes: the answer is what it was; no; empty: nothing was to be named") +
            row("repeated", "yes: the trial does not count and is done again in the next line; no") +
            row("seed", "the number from which all that is random in the trial follows") +
            "\nColumns of sittings.csv, a line each time a participant goes on with another machine\n" +
            row("participant", "number of the person") +
            row("from_trial", "the first trial that was done so; the line holds up to the next one") +
            row("date", "day, as 2026-11-26; empty where participants are simulated") +
            row("software", "the program and its version") +
            row("device", "what pulled the finger, or was moved instead") +
            row("calibration", "how the device's numbers became millimetres and newtons") +
            "\nColumns of a path, a line a sample, at least 100 a second\n" +
            row("time_s", "s: since the trial began, to 0.1 ms") +
            row("x_mm", "mm: to the right of the middle of the surface, to 1 micrometre") +
            row("y_mm", "mm: up from the middle of the surface, to 1 micrometre") +
            row("fx_n", "N: force to the right that the device was told to give, to 0.1 mN") +
            row("fy_n", "N: the same upwards") +
            "\nReading in R: read.csv(\"participant-001.csv\"); "
            "read.csv(gzfile(\"paths/participant-001-trial-0001.csv.gz\"))\n"
            "In Python: pandas.read_csv of either.\n";
    return text;
}

} // namespace tp
