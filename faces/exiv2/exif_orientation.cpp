// SPDX-License-Identifier: Apache-2.0
#include "faces/exiv2/exif_orientation.hpp"

#include <exiv2/exiv2.hpp>

namespace tp {

std::optional<int> exif_orientation(const Exiv2::ExifData& exif, const char* key) {
    const auto found = exif.findKey(Exiv2::ExifKey(key));
    if (found == exif.end() || found->count() == 0)
        return std::nullopt;
    const float value = found->toFloat(); // the one number that Exiv2 0.27 and 0.28 tell by the same name
    return value >= 1.0f && value <= 8.0f ? std::optional(static_cast<int>(value)) : std::nullopt;
}

} // namespace tp
