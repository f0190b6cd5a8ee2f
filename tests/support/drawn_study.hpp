// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/experiment/experiment_file.hpp"
#include "core/experiment/trial_order.hpp"
#include "core/experiment/trial_table.hpp"

#include <QFile>
#include <QString>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>

namespace tp::testing {

/// What came of a planned trial; the numbers and flags are filled in.
using Outcome = std::function<void(int participant, const PlannedTrial&, TrialRecord&)>;

inline void write_file(const std::filesystem::path& file, const std::string& text) {
    QFile out(QString::fromStdString(file.string()));
    if (!out.open(QIODevice::WriteOnly) || out.write(text.data(), static_cast<qint64>(text.size())) < 0)
        qFatal("cannot write %s", file.c_str());
}

/// A study in `folder` in which so many people have done everything.
inline Experiment draw_study(const std::filesystem::path& folder, const std::string& protocol,
                             int participants, const Outcome& outcome) {
    const Experiment experiment = read_experiment(protocol).value();
    std::filesystem::create_directories(folder);
    write_file(folder / "protocol.study", protocol);
    for (int participant = 1; participant <= participants; ++participant) {
        std::string csv = trial_columns(experiment);
        int number = 0;
        for (const PlannedTrial& trial : trials_of(experiment, participant, 5)) {
            TrialRecord record;
            record.participant = participant;
            record.trial = ++number;
            record.repetition = trial.repetition + 1;
            record.training = trial.training;
            record.condition = trial.condition;
            record.seed = trial.seed;
            outcome(participant, trial, record);
            csv += trial_line(experiment, record);
        }
        char name[32];
        std::snprintf(name, sizeof name, "participant-%03d.csv", participant);
        write_file(folder / name, csv);
    }
    return experiment;
}

} // namespace tp::testing
