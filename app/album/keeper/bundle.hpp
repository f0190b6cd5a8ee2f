// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace tp {

// A `.touchphoto` bundle: a zip file of photographs with everything that is theirs, as they lie in their
// album, so that a person without TouchPhoto can open it too. Photographs and recordings are stored, not
// compressed again.

struct BundleLimits {
    std::uintmax_t most_bytes = std::uintmax_t{64} << 30; ///< unpacked
    std::size_t most_files = 200'000;                     ///< and folders, be they part of it or not
    double most_growth = 200.0; ///< unpacked size against the bundle's own, beyond a megabyte: more is a bomb
};

/// Bytes done of all, while a bundle is written or read.
using BundleProgress = std::function<void(std::uintmax_t done, std::uintmax_t total)>;

/// Writes the photographs, which lie below `album`, with their companions. `bundle` appears when it is whole;
/// an existing one is replaced. Empty when done; else why not. What is a link stays out, and is named in `left`.
std::string write_bundle(const std::filesystem::path& bundle, const std::filesystem::path& album,
                         const std::vector<std::filesystem::path>& photos, const BundleProgress& report = {},
                         std::stop_token stop = {}, std::vector<std::filesystem::path>* left = nullptr);

/// The same for photographs and all photographs in folders of the album.
std::string export_bundle(const std::filesystem::path& bundle, const std::filesystem::path& album,
                          const std::vector<std::filesystem::path>& photos_and_folders,
                          const BundleProgress& report = {}, std::stop_token stop = {},
                          std::vector<std::filesystem::path>* left = nullptr);

/// Unpacks a bundle's photographs and what belongs to them (`BundleParts`) into an empty folder, which only
/// the owner may read. A bundle without a photograph, beyond the limits or damaged is refused, and so is one
/// that holds something under a name outside the folder, twice, or that is no plain file or folder. Empty
/// when done; else why not, and the folder may hold a part.
std::string unpack_bundle(const std::filesystem::path& bundle, const std::filesystem::path& folder,
                          const BundleLimits& limits = {}, const BundleProgress& report = {},
                          std::stop_token stop = {});

} // namespace tp
