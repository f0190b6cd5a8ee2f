// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/experiment/trial_table.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace tp {

inline constexpr const char* study_running_file = "running.txt";

/// Notes durably which trial is about to be done, so that a program that is killed in it has left a word. Empty, or the reason why
/// not, the end of a sentence.
std::string note_running(const std::filesystem::path& folder, int participant, int trial);
/// Takes the note away.
void forget_running(const std::filesystem::path& folder);
/// A sentence where the trial that was noted last is none of those that were kept; empty where it is, or nothing is noted.
std::string lost_trial(const std::filesystem::path& folder, std::span<const TrialRecord> records);

} // namespace tp
