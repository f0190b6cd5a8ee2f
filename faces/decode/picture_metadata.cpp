// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture_metadata.hpp"

#include "faces/exiv2/exif_orientation.hpp"
#include "faces/exiv2/prepare_exiv2.hpp"

#include <exiv2/exiv2.hpp>

#include <cstdlib>

namespace tp {

PictureMetadata metadata_of(const Bytes& bytes) noexcept {
    PictureMetadata metadata;
    try {
        prepare_exiv2();
        const auto image = Exiv2::ImageFactory::open(bytes.data(), static_cast<long>(bytes.size()));
        try {
            image->readMetadata();
        } catch (...) { // what was read until here stands
        }
        metadata.width = std::llabs(image->pixelWidth());
        metadata.height = std::llabs(image->pixelHeight());
        metadata.orientation = exif_orientation(image->exifData());
    } catch (...) { // not a kind that Exiv2 knows
    }
    return metadata;
}

} // namespace tp
