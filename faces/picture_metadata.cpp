// SPDX-License-Identifier: Apache-2.0
#include "faces/picture_metadata.hpp"

#include <exiv2/exiv2.hpp>

#include <cstdlib>
#include <mutex>

namespace tp {
namespace {

/// Exiv2 keeps its log level and its XMP parser in globals that are not safe to set up from two threads; the
/// parser of XMP needs a lock from us to be used from two.
void prepare_exiv2() {
    static std::once_flag once;
    static std::mutex xmp;
    std::call_once(once, [] {
        Exiv2::LogMsg::setLevel(Exiv2::LogMsg::mute);
        Exiv2::XmpParser::initialize(
            [](void* mutex, bool lock) {
                lock ? static_cast<std::mutex*>(mutex)->lock() : static_cast<std::mutex*>(mutex)->unlock();
            },
            &xmp);
    });
}

} // namespace

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
        const Exiv2::ExifData& exif = image->exifData();
        const auto orientation = exif.findKey(Exiv2::ExifKey("Exif.Image.Orientation"));
        if (orientation != exif.end() && orientation->count() > 0)
            if (const long value = orientation->toLong(); value >= 1 && value <= 8)
                metadata.orientation = static_cast<int>(value);
    } catch (...) { // not a kind that Exiv2 knows
    }
    return metadata;
}

} // namespace tp
