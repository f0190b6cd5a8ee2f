// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/check/findings.hpp"
#include "app/album/metadata/photo_record.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace tp {

/// The files of a folder of recordings that nobody is writing; `error`: the system's number where it cannot be listed whole.
std::set<std::string> recordings_in(const std::filesystem::path& folder, int* error = nullptr);

/// Recordings in a folder that a crash stopped.
void check_unfinished(const std::filesystem::path& folder, Findings& findings);

/// What was deleted, by album; a trash is read once, when it is first asked for.
class Deleted {
public:
    bool holds(const std::filesystem::path& album, const std::filesystem::path& file);

private:
    std::map<std::filesystem::path, std::set<std::filesystem::path>> albums_; ///< files relative to each
};

/// Whether a photograph's recordings are those that its record lists, and can be heard, by their owner alone.
/// Returns how many there are.
std::size_t check_recordings(const std::filesystem::path& photo, const PhotoRecord& record, Deleted& deleted,
                             Findings& findings);

/// Whether others on this machine may hear the files of a folder.
void check_readers(const std::filesystem::path& folder, const std::set<std::string>& files,
                   Findings& findings);

} // namespace tp
