// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/study_folder/study_check.hpp"

#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace tp {

struct StudyExport {
    std::size_t participants = 0, trials = 0, paths = 0;
    std::vector<std::string> remarks; ///< sentences: what of the folder is not in the zip
};

/// Writes a study as one zip: protocol, terms, README, sittings, tables and paths, in a folder with the experiment's name. Everything
/// is written anew from what was understood of it, so that no name that somebody put into a comment, a column of their own or a
/// file beside it goes along; the same study is the same bytes. `zip` appears when it is whole; an existing one is replaced.
Result<StudyExport> export_study(const std::filesystem::path& folder, const std::filesystem::path& zip,
                                 const TrialsDone& report = {}, const std::stop_token& stop = {});

} // namespace tp
