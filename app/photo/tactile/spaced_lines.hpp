// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"
#include "core/geometry/polyline.hpp"

#include <string>
#include <vector>

namespace tp {

/// A raised line on a tactile sheet, mm.
struct TactileLine {
    std::string name; ///< of the contour it comes from; several lines may come from one
    Contour path;
    double width_mm = 1.0;
};

/// What became of a contour whose lines would have come too close to others.
enum class LineFate {
    whole,    ///< drawn as it is
    one_line, ///< both its sides became the line between them: a shut eye, shut lips
    partly,   ///< drawn as far as it keeps its distance
    left_out  ///< no part of it does
};

/// Lays lines on a sheet one after another, so that there are never less than `gap_mm` between the edges of
/// two of them: those laid first stay as they are. The two sides of one line may meet, at the corners of an
/// eye.
class SpacedLines {
public:
    static constexpr double gap_mm = 3.0;      ///< between two lines' edges (BANA, Guidelines and Standards for
                                               ///< Tactile Graphics, 2010)
    static constexpr double shortest_mm = 8.0; ///< shorter pieces say nothing to a finger

    LineFate lay(const Contour& contour, double width_mm);
    const std::vector<TactileLine>& lines() const { return lines_; }

    /// The least distance from a rectangle to a line's edge, mm; 0 where one touches or lies within it;
    /// infinity without lines.
    double distance_to_lines(const Rect& box) const;

private:
    struct Laid {
        Polyline line;
        Rect box;
        double half_width;
    };
    bool is_clear(Vec2 place, double half_width) const;
    LineFate lay_what_is_clear(const Contour& contour, const Polyline& line, double width_mm);
    LineFate lay_middle(const Contour& contour, double narrower_than, double width_mm);
    void add(Contour path, double width_mm);

    std::vector<TactileLine> lines_;
    std::vector<Laid> laid_;
};

/// The least distance between the edges of two different lines, mm; infinity for fewer than two. Exact over
/// segments that are within 0.005 mm of the curves.
double least_gap(const std::vector<TactileLine>& lines);

} // namespace tp
