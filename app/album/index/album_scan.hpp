// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_index.hpp"
#include "app/album/metadata/photo_record.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace tp {

struct ScanProgress {
    std::size_t done = 0, total = 0;               ///< photographs that are new or changed
    std::filesystem::path photo;                   ///< the one that was just read
    std::optional<std::chrono::milliseconds> left; ///< none: not known yet
};

/// What a scan is given.
struct ScanTools {
    std::function<Result<PhotoRecord>(const std::filesystem::path& photo)> read_record;
    /// Of a recording that the sidecar does not list; may be empty, then it is left out.
    std::function<Result<Tag>(const std::filesystem::path& recording)> read_recording;
    std::function<void(const ScanProgress&)> progress; ///< after each photograph read; may be empty
    std::stop_token stop;
};

struct ScanReport {
    std::size_t found = 0;   ///< photographs and what may be one
    std::size_t read = 0;    ///< new ones and ones whose sidecars or content changed
    std::size_t hashed = 0;  ///< of those, the ones whose content was read
    std::size_t missing = 0; ///< that are gone since the last scan
    std::vector<Move> moves;
    std::vector<std::vector<std::filesystem::path>> duplicates;
    std::vector<std::string> problems; ///< sentences; the album without what they name is in the index
    bool stopped = false;              ///< the next scan goes on where this one stopped
};

/// Brings the index up to date with an album that is these folders and all below them; links to folders are
/// followed. Only what changed is read, by what the folders show of it. What is gone or elsewhere becomes
/// missing; what lies in a folder that cannot be read stays as it was. An error: the database fails.
Result<ScanReport> scan_album(AlbumIndex& index, const std::vector<std::filesystem::path>& folders,
                              const ScanTools& tools);

/// The same for some folders of the album in which something changed, and for folders below them that are new
/// or gone. A folder of recordings stands for the one that it lies in.
Result<ScanReport> rescan_folders(AlbumIndex& index, const std::vector<std::filesystem::path>& folders,
                                  const ScanTools& tools);

} // namespace tp
