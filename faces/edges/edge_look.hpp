// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace tp {

/// What speaks for a line in one channel of a picture. The channel is followed across the line, outwards
/// from the opening, smoothed by a Gaussian; slope is its first derivative times the Gaussian's deviation,
/// bend its second derivative times the variance. A positive slope: becomes more outwards; a positive bend: a
/// valley.
struct ChannelLook {
    double fine_slope = 0.0, fine_bend = 0.0, coarse_slope = 0.0, coarse_bend = 0.0;
};

/// How an edge of the face looks to one who crosses it outwards, and how far it may be from where a net put
/// it. The sum of all weighted slopes and bends is the logarithm of how likely the edge is there.
struct EdgeLook {
    ChannelLook brightness; ///< of ln(grey level + 16)
    ChannelLook redness;    ///< of ln(red + 16) - ln(green + 16)
    double stray = 0.0;     ///< price of a displacement, per percent²
    double bend = 0.0;      ///< price of a difference between neighbours among `edge_points`, per percent²
};

// All lengths across an edge are percent of the distance between the outer corners of the eyes.
inline constexpr double fine_percent = 0.5, coarse_percent = 1.3; ///< deviations of the Gaussians
inline constexpr double darkest = 16.0; ///< grey levels, below which differences are noise

/// The kinds of edges in the order of arrays that hold something about each.
enum EdgeKind : std::size_t {
    at_lower_lid,
    at_upper_lid,
    at_outer_lower_lip,
    at_outer_upper_lip,
    at_shut_lower_lip, ///< the inner lips of a shut mouth, of an open one below
    at_shut_upper_lip,
    at_open_lower_lip,
    at_open_upper_lip,
    edge_kind_count
};
/// Deviation of the Gaussian that smooths the picture before an edge of that kind is looked for, percent of
/// the unit. The outer lip is the faintest edge: grain and crispness draw it away from where people place it
/// (painted lips at 0.4, 0.7 and 0.9: 0.60, 0.54, 0.49 % off; the nets alone 0.53).
inline constexpr std::array<double, edge_kind_count> edge_grain_percent{0.0, 0.0, 0.9, 0.9,
                                                                        0.0, 0.0, 0.0, 0.0};
using EdgeLooks = std::array<EdgeLook, edge_kind_count>;

/// Weights and prices by learn_edge_look, those of the outer lip by an earlier fit; see faces/LEARNING.md.
inline constexpr EdgeLooks edge_looks{{
#include "faces/edges/edge_look_weights.inc"
}};
inline constexpr const EdgeLook& lower_lid = edge_looks[at_lower_lid];
inline constexpr const EdgeLook& upper_lid = edge_looks[at_upper_lid];
inline constexpr const EdgeLook& outer_lower_lip = edge_looks[at_outer_lower_lip];
inline constexpr const EdgeLook& outer_upper_lip = edge_looks[at_outer_upper_lip];
inline constexpr const EdgeLook& shut_lower_lip = edge_looks[at_shut_lower_lip];
inline constexpr const EdgeLook& shut_upper_lip = edge_looks[at_shut_upper_lip];
inline constexpr const EdgeLook& open_lower_lip = edge_looks[at_open_lower_lip];
inline constexpr const EdgeLook& open_upper_lip = edge_looks[at_open_upper_lip];

/// Mean gap between the inner lips as a net saw them, below which they are moved onto the line of shut lips. From
/// `open_percent` on they are moved onto the edges of open ones; up to `open_from_percent` only if, looked for as shut
/// ones, they are not found in one line, `one_line_percent` apart at most. All others stay where the net put them:
/// neither look fits (mouths opened by a tenth of their width were 1.2 % off when they were moved).
inline constexpr double shut_below_percent = 1.5, open_from_percent = 8.0;
inline constexpr double open_percent = 4.0, one_line_percent = 1.3;

} // namespace tp
