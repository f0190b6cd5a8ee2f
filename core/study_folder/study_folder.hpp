// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/experiment/experiment.hpp"
#include "core/experiment/trial_table.hpp"
#include "core/study_folder/study_terms.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tp {

inline constexpr const char* study_protocol_file = "protocol.study";
inline constexpr const char* study_terms_file = "study.txt";
inline constexpr const char* study_sittings_file = "sittings.csv";
inline constexpr const char* study_readme_file = "README.txt";
inline constexpr const char* study_paths_folder = "paths";
inline constexpr std::size_t most_study_participants = 10'000;

/// One participant's table.
struct ParticipantTable {
    std::filesystem::path file;
    int participant = 0; ///< 0: it has no trials yet
    std::vector<TrialRecord> records;
    bool torn = false;              ///< its last line is not whole, and left out
    std::uintmax_t whole_bytes = 0; ///< up to the end of the last whole line; 0: not even its columns are
};

/// What lies in a folder of a study, but for the fingers' paths (path_file.hpp).
struct StudyFolder {
    Experiment experiment;
    std::optional<StudyTerms> terms;    ///< nothing: no program of ours made the folder
    std::vector<StudySitting> sittings; ///< by participant and trial
    std::vector<TrialRecord> records;   ///< by participant, as they were done
    std::vector<std::string> remarks;   ///< sentences about what is not as it should be
};

/// "participant-007.csv"
std::string participant_file(int participant);

/// The tables of all participants, by their files' names. An error, in one sentence with the file's name, where one cannot be read,
/// has trials of two people, or two are of one person.
Result<std::vector<ParticipantTable>> read_tables(const std::filesystem::path& folder,
                                                  const Experiment& experiment);

/// An error, in one sentence with the file's name, where something cannot be read: a study with a table left out would be another
/// study.
Result<StudyFolder> read_study(const std::filesystem::path& folder);

/// How far each participant has come, a sentence each: what is done, what is missing.
std::vector<std::string> study_progress(const StudyFolder& study);

} // namespace tp
