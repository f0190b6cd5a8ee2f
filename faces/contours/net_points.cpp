// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/net_points.hpp"

#include <array>

namespace tp {
namespace {

using Mirror = std::array<std::size_t, net_points::all.size()>;

/// Both features keep their order: it begins at the outer end of each.
constexpr void swap(Mirror& mirror, PointRange right, PointRange left) {
    for (std::size_t i = 0; i < right.size(); ++i) {
        mirror[right.begin + i] = left.begin + i;
        mirror[left.begin + i] = right.begin + i;
    }
}

/// An open line runs the other way.
constexpr void reverse(Mirror& mirror, PointRange line) {
    for (std::size_t i = 0; i < line.size(); ++i)
        mirror[line.begin + i] = line.end - 1 - i;
}

/// Round a lip the other way, from the other corner.
constexpr void turn(Mirror& mirror, PointRange lip) {
    for (std::size_t i = 0; i < lip.size(); ++i)
        mirror[lip.begin + i] = lip.begin + (lip.size() * 3 / 2 - i) % lip.size();
}

constexpr Mirror make_mirror() {
    Mirror mirror{};
    swap(mirror, net_points::right_eye, net_points::left_eye);
    turn(mirror, net_points::outer_lip);
    turn(mirror, net_points::inner_lip);
    reverse(mirror, net_points::outline);
    reverse(mirror, net_points::irises);
    reverse(mirror, net_points::rims);
    swap(mirror, net_points::right_brow, net_points::left_brow);
    reverse(mirror, net_points::nose);
    return mirror;
}

} // namespace

std::size_t in_mirror(std::size_t number) {
    static constexpr Mirror mirror = make_mirror();
    return mirror[number];
}

} // namespace tp
