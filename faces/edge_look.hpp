// SPDX-License-Identifier: Apache-2.0
#pragma once

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

// Weights by maximum likelihood (softmax over the places on the normal) of hand-placed lines of 34 people,
// from where two models had put them; the inner lip also of 68 smiles as the face mesh saw them.
inline constexpr EdgeLook lower_lid{{-2.17, -1.50, 0.91, -2.46}, {4.40, -0.37, 11.79, -3.45}, 0.4, 6.0};
inline constexpr EdgeLook upper_lid{{1.53, 1.85, 0.08, 2.82}, {0.44, -0.50, 7.47, -4.20}, 0.3, 6.0};
inline constexpr EdgeLook outer_lower_lip{{-4.67, -3.33, 0.33, 0.49}, {-5.40, 0.72, -13.13, 1.58}, 0.1, 2.0};
inline constexpr EdgeLook outer_upper_lip{
    {8.21, -2.98, 1.65, -8.99}, {-4.15, -0.72, -2.56, -1.32}, 0.15, 2.0};
inline constexpr EdgeLook shut_lower_lip{{0.06, 2.02, 4.88, 8.58}, {1.62, -0.28, 5.98, -0.20}, 0.04, 2.0};
inline constexpr EdgeLook shut_upper_lip{{0.48, 1.75, -3.22, 8.97}, {-0.97, -0.73, -2.80, -1.66}, 0.04, 2.0};
inline constexpr EdgeLook open_lower_lip{{1.09, 0.03, 5.27, 3.06}, {1.25, 0.62, 10.05, -1.09}, 0.4, 2.0};
inline constexpr EdgeLook open_upper_lip{{1.20, 1.09, -1.33, 5.66}, {0.48, 0.88, 3.69, 1.95}, 0.4, 2.0};
/// Mean gap between the inner lips as a net saw them, below which a mouth is taken for shut; up to twice that
/// it is shut if both lips, looked for as shut ones, are found in one line, `one_line_percent` apart at most.
inline constexpr double open_percent = 4.0, one_line_percent = 1.3;

} // namespace tp
