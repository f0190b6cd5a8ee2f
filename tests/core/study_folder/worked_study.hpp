// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/experiment/experiment_file.hpp"
#include "core/study_folder/study_writer.hpp"

#include <vector>

namespace tp::test {

/// The study that study_worker runs: 5 trials a person, one of training, and each third one goes wrong.
inline Experiment worked_experiment() {
    return read_experiment(
               "experiment: small\ntask: follow\nfactor range: 2, 4 mm\nrepetitions: 2\ntraining: 1\n")
        .value();
}
inline constexpr int worked_participants = 2;
inline const StudyTerms worked_terms{42, false};
inline const StudyMachine worked_mouse{"2026-11-26", "touchphoto 0.1.0", "mouse", "3.7 pixels a millimetre"};
inline const StudyMachine worked_pad{"2026-11-26", "touchphoto 0.1.0", "force pad", "0.98"};

inline TrialRecord worked_record(const NextTrial& next, int participant) {
    TrialRecord record = begun_record(next, participant);
    record.error_mm = 1.0 + 0.125 * next.number;
    record.time_s = 2.0;
    record.repeated = next.number % 3 == 0;
    return record;
}

/// Long enough for more than one write.
inline std::vector<FingerSample> worked_path(const TrialRecord& record) {
    std::vector<FingerSample> path;
    for (int i = 0; i <= 200; ++i)
        path.push_back({0.01 * i, record.participant + 0.1 * i, 0.5 * record.trial, 0.25, -0.5});
    return path;
}

} // namespace tp::test
