// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/byte_source.hpp"

#include <cstdint>
#include <optional>

namespace tp {

/// Where in a file a video lies.
struct VideoPlace {
    std::uint64_t begin = 0; ///< bytes from the file's beginning
    std::uint64_t size = 0;  ///< bytes

    bool operator==(const VideoPlace&) const = default;
};

/// The video inside a motion photo, a JPEG with an MP4 file behind the picture, as its XMP says (Google,
/// "Motion Photo format 1.0": Container:Directory; before that GCamera:MicroVideoOffset) or, in older ones of
/// Samsung, the list at the file's end ("SEFT"); or a HEIC file with it in a box of its own ("mpvd", the same
/// format). None where there is none, where what is said leads out of the file, or where no MP4 begins there.
/// Reads the picture's head and the file's end, not the whole.
std::optional<VideoPlace> video_inside(const ByteSource& photo);

} // namespace tp
