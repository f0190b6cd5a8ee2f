// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace Exiv2 {
class ExifData;
}

namespace tp {

/// How a picture lies as EXIF counts it, 1 … 8; none where `key` is not there or says no such number.
std::optional<int> exif_orientation(const Exiv2::ExifData& exif, const char* key = "Exif.Image.Orientation");

} // namespace tp
