// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <vector>

namespace tp {

using Bytes = std::vector<unsigned char>;

/// What a file's first bytes say it is.
enum class PictureKind {
    jpeg,
    png,
    webp,
    tiff,
    bmp,
    jpeg2000,
    heif, ///< HEIC and AVIF, which OpenCV does not read
    unknown
};
PictureKind kind_of(const Bytes& bytes);

/// A whole file; an error where there is none, it is a folder, may not be read, is empty or has more than 2
/// GiB.
Result<Bytes> read_bytes(const std::filesystem::path& file);

} // namespace tp
