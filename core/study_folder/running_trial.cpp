// SPDX-License-Identifier: Apache-2.0
#include "core/study_folder/running_trial.hpp"

#include "core/files/durable_file.hpp"
#include "core/files/whole_file.hpp"
#include "core/study_folder/path_file.hpp"

#include <algorithm>
#include <cstddef>
#include <system_error>

namespace tp {

namespace {

constexpr std::size_t most_bytes = 100;

/// A trial's name is that of its path.
std::string note_of(int participant, int trial) { return path_file_name(participant, trial) + '\n'; }

} // namespace

std::string note_running(const std::filesystem::path& folder, int participant, int trial) {
    return replace_file(folder / study_running_file, note_of(participant, trial));
}

void forget_running(const std::filesystem::path& folder) {
    std::error_code nothing; // a note of a trial that was kept says nothing
    std::filesystem::remove(folder / study_running_file, nothing);
}

std::string lost_trial(const std::filesystem::path& folder, std::span<const TrialRecord> records) {
    const std::filesystem::path file = folder / study_running_file;
    if (!name_taken(file))
        return {};
    const auto note = read_whole(file, most_bytes); // a note that cannot be read is of no trial that was kept
    const bool kept = note && std::ranges::any_of(records, [&](const TrialRecord& record) {
                          return *note == note_of(record.participant, record.trial);
                      });
    return kept ? std::string() : "A trial was running when the program ended; it is done again.";
}

} // namespace tp
