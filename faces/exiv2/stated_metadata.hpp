// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/open_file.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tp {

inline constexpr std::size_t most_stated_keywords = 10'000;

/// What a photograph's file states of itself, before anything is made of it. Texts are as they lie there, in any
/// encoding; numbers may make no sense.
struct StatedMetadata {
    std::int64_t width = 0, height = 0;        ///< px as stored; 0 where unknown
    std::optional<int> orientation;            ///< EXIF, 1 … 8
    std::string taken, taken_offset;           ///< EXIF's DateTimeOriginal, OffsetTimeOriginal
    std::optional<double> latitude, longitude; ///< EXIF's, in degrees; south and west are less than 0
    std::string date, time, caption;           ///< IPTC's
    std::vector<std::string> keywords;         ///< IPTC's, `most_stated_keywords` at most
    std::vector<std::string> places;           ///< IPTC's, from the smallest to the largest
    std::string xmp;                           ///< a packet
    bool is_damaged = false, exif_is_damaged = false, xmp_is_damaged = false, iptc_is_damaged = false;

    bool operator==(const StatedMetadata&) const = default;
};

/// Of a file's bytes; none where they are of no kind that Exiv2 knows. Never throws but where memory is short.
std::optional<StatedMetadata> stated_in(std::span<const unsigned char> file);

/// Of a file, read by a helper of foreign_decoder.hpp where this program has them and the system confines a process,
/// else in this process. None too where reading takes more than the helper has.
std::optional<StatedMetadata> stated_metadata(OpenFile file);

} // namespace tp
