// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/study_folder/study_folder.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace tp {

/// Trials done of all.
using TrialsDone = std::function<void(std::size_t done, std::size_t all)>;

struct StudyFindings {
    std::vector<std::string> faults; ///< sentences; empty: everything is as it should be
    bool running = false;            ///< a program runs the study now, and the folder changes meanwhile
};

/// What is wrong in a folder beside what read_study refuses: its remarks; a trial that was not planned; a path that is missing,
/// torn, has too few samples, or belongs to no trial; trials without a note of the machine; what a killed program left behind.
/// Reads every path. Ends early where it is stopped.
StudyFindings check_study(const std::filesystem::path& folder, const StudyFolder& study,
                          const TrialsDone& report = {}, std::stop_token stop = {});

} // namespace tp
