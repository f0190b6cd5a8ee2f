// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/byte_source.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// A box of a HEIC, AVIF or MP4 file (ISO/IEC 14496-12, 4.2): what is in it, without its head.
struct HeifBox {
    std::string type;        ///< four letters
    std::uint64_t begin = 0; ///< bytes from the file's beginning
    std::uint64_t size = 0;  ///< bytes
};

/// The boxes one after the other in that part of a file, until one is no box or leads out of it. No more than
/// a thousand.
std::vector<HeifBox> boxes_in(const ByteSource& file, std::uint64_t begin, std::uint64_t size);
/// The first of that type.
std::optional<HeifBox> box_of(std::string_view type, const std::vector<HeifBox>& boxes);

/// How the primary picture of a HEIC or AVIF file is turned before it is shown, as EXIF says it, 1 … 8: what
/// its properties irot and imir amount to (ISO/IEC 23008-12, 6.5.10 and 6.5.12). They count, whatever EXIF
/// says. None where the file is another or does not say which picture is meant.
std::optional<int> heif_orientation(const ByteSource& file);

} // namespace tp
