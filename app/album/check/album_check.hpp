// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// Something in an album's folder that is not as it is promised to be.
struct Finding {
    enum class Kind {
        half_written,         ///< a temporary file that a killed program left; nothing in it was acknowledged
        unfinished_recording, ///< a recording that a crash stopped
        unlisted_recording,   ///< a recording that its photograph or person does not know of
        missing_recording,    ///< a listed recording without its file
        unreadable_recording,
        unreadable_sidecar,
        left_behind,    ///< a sidecar, contours or recordings whose photograph is not beside them, or a
                        ///< name of nobody
        conflict_copy,  ///< another machine changed the same sidecar
        changed_photo,  ///< its bytes are not those that its sidecar knew
        open_to_others, ///< recordings that other people on this machine may hear
        unfinished_import,
        damaged_trash,
        damaged_name_language, ///< a file of a name's language that cannot be read or does not have its place
    };
    Kind kind = Kind::half_written;
    std::filesystem::path file;
    std::string sentence; ///< what is wrong
    std::string mend;     ///< what mending does, "It is deleted."; empty: only a person can decide
    bool mended = false;
    std::string problem; ///< why it could not be mended
};

/// "half_written", …: as in JSON.
std::string_view name_of(Finding::Kind kind);

struct CheckReport {
    std::size_t photos = 0, recordings = 0;
    std::vector<Finding> findings;
    std::vector<std::string> told; ///< what merging sync conflicts left for a person to know
    bool stopped = false;
};

struct CheckOptions {
    bool mend = false;
    bool hashes = true; ///< reads every photograph whole
    std::function<void(std::size_t photos, const std::filesystem::path& current)> report = {};
};

/// Goes through a folder of an album and everything below it and compares what is there with what is
/// promised. Without `mend` nothing is written. With it nothing is deleted but half-written files: what has
/// to make way goes to the trash.
Result<CheckReport> check_album(const std::filesystem::path& album, const CheckOptions& options = {},
                                std::stop_token stop = {});

} // namespace tp
