// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace tp {

/// The points [begin, end) of a contour net's answer that belong to one feature.
struct PointRange {
    std::size_t begin, end;
    constexpr std::size_t size() const { return end - begin; }
};

/// How the points of a face are numbered by the nets; the same as in faces/training/contours.py. Left and
/// right are the person's own. The first three are in the order of `Landmarks`; an iris is its centre and a
/// point of its rim on the outer side, on the line through both centres.
namespace net_points {
inline constexpr PointRange right_eye{0, 16}, left_eye{16, 32}, outer_lip{32, 52}, inner_lip{52, 72},
    outline{72, 105}, irises{105, 107}, rims{107, 109}, right_brow{109, 119}, left_brow{119, 129},
    nose{129, 140};
inline constexpr PointRange lips{outer_lip.begin, inner_lip.end};
inline constexpr PointRange felt{0, outline.end};    ///< of the five contours
inline constexpr PointRange windowed{0, irises.end}; ///< that say where the window of the face net lies
inline constexpr PointRange all{0, nose.end};
} // namespace net_points

/// Which point stands in a mirror where point `number` of `net_points::all` stands.
std::size_t in_mirror(std::size_t number);

} // namespace tp
