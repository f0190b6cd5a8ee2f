// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace tp {

/// What a picture's chroma adds to its brightness, for values from 0 to 255 of which chroma's middle is 128.
struct ColourShares {
    float red_of_cr, green_of_cb, green_of_cr, blue_of_cb;
};

/// By ITU-T H.273's number for the matrix (MatrixCoefficients, table 4): 1 (BT.709), 5 and 6 (BT.601), and 2,
/// unspecified, which is taken for BT.601. None for the others.
std::optional<ColourShares> colour_shares(int matrix);

struct ReadPlane {
    const std::uint8_t* values;
    std::ptrdiff_t step; ///< bytes from row to row
};
struct WrittenPlane {
    std::uint8_t* values;
    std::ptrdiff_t step;
};

/// Brightness, Cb and Cr of 8 bits in their full range (H.273, VideoFullRangeFlag 1), chroma halved both ways and rounded up,
/// to red, green and blue of `width` × `height`: each value of chroma counts for its four pixels, and is
/// rounded once, as libheif 1.15 does it.
void to_rgb(const std::array<ReadPlane, 3>& coded, int width, int height, const ColourShares& shares,
            const std::array<WrittenPlane, 3>& rgb);

} // namespace tp
