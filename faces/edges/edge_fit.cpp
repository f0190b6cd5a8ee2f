// SPDX-License-Identifier: Apache-2.0
#include "faces/edges/edge_fit.hpp"

#include "faces/edges/edge_profile.hpp"

#include <cmath>
#include <utility>

namespace tp {
namespace {

constexpr double smallest_unit_px = 24.0; ///< below, a percent is a quarter of a pixel

} // namespace

std::vector<Vec2> on_edge(const cv::Mat& picture, const std::vector<Vec2>& line, Vec2 outwards,
                          double unit_px, const EdgeLook& look, EdgeReport* report, double grain_percent) {
    const Evidence evidence = evidence_in(edge_profile(picture, line, outwards, unit_px, grain_percent), look);
    const std::vector<double> displacement = snapped(evidence, look.stray, look.bend);
    const std::vector<Vec2> normals = normals_of(line, outwards);
    std::vector<Vec2> moved = line;
    double sum = 0.0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        moved[i] += displacement[i] * unit_px / 100.0 * normals[i];
        sum += std::abs(displacement[i]);
    }
    if (report)
        *report = {sum / static_cast<double>(line.size()), clarity(evidence, displacement)};
    return moved;
}

FaceLines on_edges(const cv::Mat& picture, FaceLines lines, EdgeReports* reports, const EdgeLooks& looks) {
    const Vec2 across = lines.left_eye.lower.front() - lines.right_eye.lower.front();
    const double unit_px = length(across);
    EdgeReports found;
    if (unit_px >= smallest_unit_px) {
        const Vec2 down(-across.y, across.x);
        const auto fitted = [&](Opening opening, EdgeKind lower, EdgeKind upper, EdgeReports::Pair& said) {
            opening.lower = on_edge(picture, opening.lower, down, unit_px, looks[lower], &said.lower,
                                    edge_grain_percent[lower]);
            opening.upper = on_edge(picture, opening.upper, -down, unit_px, looks[upper], &said.upper,
                                    edge_grain_percent[upper]);
            opening.lower.front() = opening.upper.front() =
                0.5 * (opening.lower.front() + opening.upper.front());
            opening.lower.back() = opening.upper.back() = 0.5 * (opening.lower.back() + opening.upper.back());
            return opening;
        };
        lines.right_eye = fitted(lines.right_eye, at_lower_lid, at_upper_lid, found.right_eye);
        lines.left_eye = fitted(lines.left_eye, at_lower_lid, at_upper_lid, found.left_eye);
        lines.outer_lip = fitted(lines.outer_lip, at_outer_lower_lip, at_outer_upper_lip, found.outer_lip);
        const double gap = 100.0 * lines.inner_lip.mean_gap() / unit_px;
        Opening inner = lines.inner_lip;
        if (gap < open_from_percent)
            inner = fitted(lines.inner_lip, at_shut_lower_lip, at_shut_upper_lip, found.inner_lip);
        const bool two_edges = gap >= open_percent && 100.0 * inner.mean_gap() / unit_px > one_line_percent;
        if (two_edges)
            inner = fitted(lines.inner_lip, at_open_lower_lip, at_open_upper_lip, found.inner_lip);
        if (gap < shut_below_percent || two_edges)
            lines.inner_lip = std::move(inner);
    }
    if (reports)
        *reports = found;
    return lines;
}

} // namespace tp
