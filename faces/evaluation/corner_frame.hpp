// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace tp {

/// What opens and closes, an eye or a mouth, seen from its corners: u along the line from one to the other,
/// v across it, down the face; px.
struct CornerFrame {
    Vec2 corner{0.0}, across{1.0, 0.0}; ///< `across` of length 1
    double width = 0.0;                 ///< from corner to corner

    Vec2 of(Vec2 p) const;
    Vec2 back(Vec2 uv) const;
    bool inside(double u) const { return u > 0.0 && u < width; }
};

/// v over u, 0 beyond both ends.
class EdgeLine {
public:
    explicit EdgeLine(std::vector<Vec2> uv);
    double at(double u) const;

private:
    std::vector<Vec2> points_; ///< by u
};

/// A closed contour between its corners.
struct OpenedShape {
    CornerFrame frame;
    EdgeLine upper, lower; ///< px, from corner to corner

    /// The corners are its points farthest apart the way `across` points.
    OpenedShape(const Contour& contour, Vec2 across);
};

/// Points of a contour, so many that it is straight between them.
std::vector<Vec2> many_points(const Contour& contour);

/// Which points of a closed contour, in its frame, lie on the lower edge, corners not among them.
std::vector<bool> on_lower_edge(const std::vector<Vec2>& uv);

/// From the middle of the right eye to that of the left one, of length 1.
Vec2 across_face(const Contour& right_eye, const Contour& left_eye);

/// 0 below 0, 1 above 1, level at both.
double smooth_step(double t);

/// As much of `colour` in the picture (float BGR) as `share` (float, 0 … 1) says, its border blurred.
void blend(cv::Mat& picture, const cv::Mat& share, cv::Scalar colour, double softness_px);

} // namespace tp
