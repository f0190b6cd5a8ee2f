// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_index.hpp"
#include "app/album/index/album_scan.hpp"
#include "app/cli/album/album_words.hpp"
#include "app/cli/command_line.hpp"

#include <QJsonObject>

#include <filesystem>
#include <vector>

namespace tp {

/// Adds what every verb that uses an index has: --cache, and the album's folders as arguments.
VerbLine& add_index_options(VerbLine& line);

/// Where the index of an album lies that nobody named a place for: below the user's cache folder, by the
/// album's folders.
std::filesystem::path cache_of(const VerbLine& line, const std::vector<std::filesystem::path>& folders);

/// Opens the index; what it has to tell is said on stderr.
Result<AlbumIndex> open_index(const VerbLine& line, const std::vector<std::filesystem::path>& folders);

/// Brings it up to date, with progress on stderr; stopped by the signal.
Result<ScanReport> scan_with_progress(AlbumIndex& index, const std::vector<std::filesystem::path>& folders);

/// The same for folders in which something changed.
Result<ScanReport> rescan_with_progress(AlbumIndex& index, const std::vector<std::filesystem::path>& folders);

/// Opens the index and brings it up to date.
Result<AlbumIndex> scanned_index(const VerbLine& line, const std::vector<std::filesystem::path>& folders);

/// Opens the index and scans where it was never filled.
Result<AlbumIndex> filled_index(const VerbLine& line, const std::vector<std::filesystem::path>& folders);

} // namespace tp
