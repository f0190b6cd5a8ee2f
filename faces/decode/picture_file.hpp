// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/descriptor.hpp"
#include "core/base/result.hpp"

#include <cstdint>
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
    heic, ///< a picture coded by HEVC in the boxes of HEIF, as phones write
    avif, ///< one coded by AV1 in the same boxes
    raw,  ///< a camera's raw file: DNG, CR2, CR3, NEF, ARW, ORF, RW2
    unknown
};
/// A raw file of DNG, NEF or ARW begins as any TIFF does; raw_file.hpp says how it is told from one.
PictureKind kind_of(const Bytes& bytes);

/// As many of a file's first bytes as kind_of looks at, or as it has; none where it is no file that can be
/// read.
Bytes first_bytes(const std::filesystem::path& file);

/// A file that is open, and how many bytes it has.
struct PictureFile {
    Descriptor descriptor;
    std::uintmax_t size = 0;
};
/// To be read, by another process; the same errors as `read_bytes`.
Result<PictureFile> open_picture_file(const std::filesystem::path& file);

/// A whole file; an error where there is none, it is a folder, may not be read, is empty or has more than 2
/// GiB.
Result<Bytes> read_bytes(const std::filesystem::path& file);

} // namespace tp
