// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

inline constexpr int longest_film_side = 8192;                ///< px
inline constexpr std::int64_t most_film_px = 4096LL * 2304LL; ///< of one picture

/// One picture of a video, 8 bit, of television's range (16 … 235): the brightness of all pixels and then, half as wide and
/// half as high, two planes of colour (I420).
struct FilmPicture {
    double time_s = 0.0;              ///< of the video's clock
    int width = 0, height = 0;        ///< px, as it is stored; both even
    int turn_deg = 0;                 ///< clockwise, by which it becomes upright: 0, 90, 180 or 270
    std::vector<std::uint8_t> planes; ///< `film_bytes` of them
};

inline std::size_t film_bytes(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3 / 2;
}

/// The pictures of a video, one after the other.
class FilmStream {
public:
    virtual ~FilmStream() = default;
    /// The next one that is not before `from_s` of the video's clock. None at the end, or where decoding breaks off.
    virtual std::optional<FilmPicture> next(double from_s) = 0;
};

} // namespace tp
