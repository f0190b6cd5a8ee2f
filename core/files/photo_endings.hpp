// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>

namespace tp {

/// What the names of photographs end in that this program takes as such, wherever it looks through a folder
/// or asks for files: JPEG, PNG, WebP, TIFF, HEIC, AVIF, and the raw files of cameras.
inline constexpr std::array<std::string_view, 18> photo_endings{
    ".jpg",  ".jpeg", ".jpe", ".png", ".webp", ".tif", ".tiff", ".heic", ".heif",
    ".avif", ".hif",  ".dng", ".cr2", ".cr3",  ".nef", ".arw",  ".orf",  ".rw2"};

/// What a file's name ends in, in small letters: ".jpg" of IMG_1.JPG.
inline std::string small_ending(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

/// Whether a file's name ends so, in capitals or not.
inline bool has_photo_ending(const std::filesystem::path& file) {
    const std::string ending = small_ending(file);
    return std::find(photo_endings.begin(), photo_endings.end(), ending) != photo_endings.end();
}

} // namespace tp
