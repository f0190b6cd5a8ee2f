// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/experiment/experiment.hpp"
#include "core/experiment/trial_table.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tp {

inline constexpr const char* study_protocol_file = "protocol.study";
inline constexpr std::size_t most_study_participants = 10'000;

/// What lies in a folder of a study.
struct StudyFolder {
    Experiment experiment;
    std::vector<TrialRecord> records; ///< by participant, as they were done
    std::vector<std::string> remarks; ///< sentences about what is not as it should be
};

/// "participant-007.csv"
std::string participant_file(int participant);

/// An error, in one sentence with the file's name, where something cannot be read: a study with a table left out would be another
/// study.
Result<StudyFolder> read_study(const std::filesystem::path& folder);

/// How far each participant has come, a sentence each: what is done, what is missing.
std::vector<std::string> study_progress(const StudyFolder& study);

} // namespace tp
