// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/planes_to_rgb.hpp"

#include <vector>

namespace tp {
namespace {

/// By the shares of red and blue in brightness (H.273, equations 38 to 40 solved for the colours).
ColourShares shares_of(float red, float blue) {
    const float green = blue + red - 1;
    return {2 * (1 - red), 2 * blue * (1 - blue) / green, 2 * red * (1 - red) / green, 2 * (1 - blue)};
}

/// A row's chroma times its share, twice each.
void spread(const std::uint8_t* chroma, float share, std::vector<float>& row) {
    for (std::size_t x = 0; 2 * x < row.size(); ++x)
        row[2 * x] = row[2 * x + 1] = share * (static_cast<float>(chroma[x]) - 128.0F);
}

constexpr float half = 0.5F; ///< rounds to the nearest what is not below 0

void add(const std::uint8_t* brightness, const float* first, const float* second, std::uint8_t* out,
         int width) {
    for (int x = 0; x < width; ++x) {
        const float value = static_cast<float>(brightness[x]) + first[x] + second[x];
        const int rounded = static_cast<int>(value + half);
        out[x] = static_cast<std::uint8_t>(rounded < 0 ? 0 : rounded > 255 ? 255 : rounded); // in vectors
    }
}

} // namespace

std::optional<ColourShares> colour_shares(int matrix) {
    switch (matrix) {
    case 1:
        return shares_of(0.2126F, 0.0722F);
    case 2:
        return ColourShares{1.402F, -0.344136F, -0.714136F, 1.772F};
    case 5:
    case 6:
        return shares_of(0.299F, 0.114F);
    default:
        return std::nullopt;
    }
}

void to_rgb(const std::array<ReadPlane, 3>& coded, int width, int height, const ColourShares& shares,
            const std::array<WrittenPlane, 3>& rgb) {
    const std::size_t row = static_cast<std::size_t>(width + 1) / 2 * 2;
    std::vector<float> red(row), green_of_cb(row), green_of_cr(row), blue(row), nothing(row, 0.0F);
    for (int y = 0; y < height; ++y) {
        if (y % 2 == 0) {
            const std::uint8_t* const cb = coded[1].values + y / 2 * coded[1].step;
            const std::uint8_t* const cr = coded[2].values + y / 2 * coded[2].step;
            spread(cr, shares.red_of_cr, red);
            spread(cb, shares.green_of_cb, green_of_cb);
            spread(cr, shares.green_of_cr, green_of_cr);
            spread(cb, shares.blue_of_cb, blue);
        }
        const std::uint8_t* const brightness = coded[0].values + y * coded[0].step;
        add(brightness, red.data(), nothing.data(), rgb[0].values + y * rgb[0].step, width);
        add(brightness, green_of_cb.data(), green_of_cr.data(), rgb[1].values + y * rgb[1].step, width);
        add(brightness, blue.data(), nothing.data(), rgb[2].values + y * rgb[2].step, width);
    }
}

} // namespace tp
