// SPDX-License-Identifier: Apache-2.0
#include "motion_check.hpp"

#include "app/album/metadata/heif_boxes.hpp"
#include "app/album/metadata/motion_photo.hpp"
#include "audio/recordings/byte_source.hpp"
#include "failing_bytes.hpp"

namespace tp::test {

std::string complaint_about_motion(std::string_view bytes) {
    if (const auto turned = heif_orientation(MemoryBytes(bytes)); turned && (*turned < 1 || *turned > 8))
        return "turned in a way that EXIF does not know";
    on_failing_disks(bytes, [](const ByteSource& file) {
        static_cast<void>(heif_orientation(file));
        static_cast<void>(video_inside(file));
    });
    const auto place = video_inside(MemoryBytes(bytes));
    if (!place)
        return {};
    if (!bytes.starts_with("\xFF\xD8") && bytes.substr(0, 8).find("ftyp") != 4)
        return "found in what is neither JPEG nor HEIC";
    if (place->begin < 2 || place->size == 0 || place->begin >= bytes.size() ||
        place->size > bytes.size() - place->begin)
        return "it does not lie in the file";
    return bytes.substr(place->begin, place->size).substr(4).starts_with("ftyp") ? ""
                                                                                 : "no video begins there";
}

} // namespace tp::test
