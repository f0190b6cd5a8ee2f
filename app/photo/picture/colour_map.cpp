// SPDX-License-Identifier: Apache-2.0
#include "app/photo/picture/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tp {

QColor field_colour(double share) {
    struct Stop {
        double r, g, b;
    };
    static constexpr std::array<Stop, 5> stops{
        {{18, 18, 32}, {38, 60, 130}, {24, 126, 140}, {110, 196, 96}, {252, 240, 140}}};
    const double place = (std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0) * (stops.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    const double t = place - static_cast<double>(low);
    const auto mix = [&](double a, double b) { return static_cast<int>(std::lround(a + t * (b - a))); };
    const Stop& a = stops[low];
    const Stop& b = stops[low + 1];
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

QColor line_colour(int index) {
    static constexpr std::array<QRgb, 8> colours{0xff35d0ff, 0xffffb000, 0xff7dff7a, 0xffff6f91,
                                                 0xffd9a6ff, 0xfffff27a, 0xff6affd8, 0xffff9d5c};
    return QColor::fromRgb(colours[static_cast<std::size_t>(std::abs(index)) % colours.size()]);
}

} // namespace tp
