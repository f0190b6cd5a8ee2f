// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// What became of a part that lay in a folder.
struct RepairedPart {
    enum class Outcome {
        stored, ///< `file` is the FLAC made of it, and the part is gone
        empty,  ///< it held no sound and is gone
        in_use, ///< it is being recorded or finished, and was left alone
        failed, ///< it is as it was; `sentence` says why
    };
    std::filesystem::path part;
    Outcome outcome = Outcome::failed;
    std::filesystem::path file; ///< only where stored
    std::string sentence;       ///< for a person
};

/// Makes FLACs of all recordings in that folder (not in those below) that were not finished. May be killed at
/// any time and called again by anyone: a recording is never lost and never there twice. An error is a
/// sentence.
Result<std::vector<RepairedPart>> repair_folder(const std::filesystem::path& folder);

} // namespace tp
