// SPDX-License-Identifier: Apache-2.0
#include "app/photo/tactile/spaced_lines.hpp"

#include "core/geometry/flatten.hpp"
#include "core/guidance/spacing.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tp {

namespace {

constexpr double step_mm = 0.2; ///< between the places at which a line's distance to others is looked at
/// Between two places a line is at most half a step nearer; and curves are not quite their segments.
constexpr double slack_mm = 0.5 * step_mm + 0.02;
constexpr FlattenTolerance fine{0.005, 3.0, 10};

Rect box_round(const Polyline& line) { return bounds_of(line.points); }

/// The least distance between two segments' ends and the other one; 0 where they cross.
double between(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const auto side = [](Vec2 from, Vec2 to, Vec2 p) { return cross(to - from, p - from) > 0.0; };
    if (side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b))
        return 0.0;
    return std::min({length(a - nearest_on_segment(c, d, a)), length(b - nearest_on_segment(c, d, b)),
                     length(c - nearest_on_segment(a, b, c)), length(d - nearest_on_segment(a, b, d))});
}

/// The larger distance along an axis between the boxes round two segments: they are no nearer than that.
double at_least_between(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const Vec2 off = glm::max(glm::min(a, b) - glm::max(c, d), glm::min(c, d) - glm::max(a, b));
    return std::max(off.x, off.y);
}

double between(const Polyline& one, const Polyline& other) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < one.segment_count(); ++i) {
        const Vec2 a = one.segment_start(i), b = one.segment_end(i);
        for (std::size_t k = 0; k < other.segment_count(); ++k) {
            const Vec2 c = other.segment_start(k), d = other.segment_end(k);
            if (at_least_between(a, b, c, d) < least)
                least = std::min(least, between(a, b, c, d));
        }
    }
    return least;
}

bool passes_within(const Polyline& line, Vec2 place, double distance) {
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
        const Vec2 a = line.segment_start(i), b = line.segment_end(i);
        if (at_least_between(a, b, place, place) < distance && length(nearest_on_segment(a, b, place) - place) < distance)
            return true;
    }
    return false;
}

/// Points along the line, `step_mm` apart or nearer.
Polyline sampled(const Polyline& line) {
    const auto count = static_cast<std::size_t>(std::ceil(length_of(line) / step_mm)) + 2;
    Polyline even = resampled(line, std::min<std::size_t>(count, 50'000));
    even.closed = line.closed;
    return even;
}

/// Runs of clear places, of a closed line round its seam too.
std::vector<std::vector<Vec2>> runs_of(const Polyline& line, const std::vector<bool>& clear) {
    const std::size_t count = line.points.size();
    std::size_t start = 0;
    if (line.closed)
        while (start < count && clear[start])
            ++start; // begins at a gap
    std::vector<std::vector<Vec2>> runs;
    bool running = false;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = (start + i) % count;
        if (clear[at] && !running)
            runs.emplace_back();
        running = clear[at];
        if (running)
            runs.back().push_back(line.points[at]);
    }
    return runs;
}

/// Fewer points, none of the left-out ones farther than 0.01 mm from the line (Douglas and Peucker 1973).
void simplify(const std::vector<Vec2>& points, std::size_t from, std::size_t to, std::vector<Vec2>& into) {
    std::size_t farthest = from;
    double most = 0.01;
    for (std::size_t i = from + 1; i < to; ++i)
        if (const double away = length(points[i] - nearest_on_segment(points[from], points[to], points[i]));
            away > most) {
            most = away;
            farthest = i;
        }
    if (farthest != from) {
        simplify(points, from, farthest, into);
        simplify(points, farthest, to, into);
    } else {
        into.push_back(points[to]);
    }
}

Contour path_through(std::string name, const std::vector<Vec2>& points) {
    std::vector<Vec2> fewer{points.front()};
    simplify(points, 0, points.size() - 1, fewer);
    return contour_through(std::move(name), fewer, false);
}

} // namespace

bool SpacedLines::is_clear(Vec2 place, double half_width) const {
    return std::all_of(laid_.begin(), laid_.end(), [&](const Laid& other) {
        const double wanted = gap_mm + slack_mm + half_width + other.half_width;
        const Vec2 off = glm::max(other.box.min - place, place - other.box.max);
        return std::max(off.x, off.y) >= wanted || !passes_within(other.line, place, wanted);
    });
}

void SpacedLines::add(Contour path, double width_mm) {
    Polyline line = flatten(path, fine);
    const Rect box = box_round(line);
    laid_.push_back({std::move(line), box, 0.5 * width_mm});
    lines_.push_back({path.name, std::move(path), width_mm});
}

LineFate SpacedLines::lay_what_is_clear(const Contour& contour, const Polyline& line, double width_mm) {
    const double half = 0.5 * width_mm;
    const Polyline even = sampled(line);
    const auto clear_places = [&] {
        std::vector<bool> clear;
        for (const Vec2 p : even.points)
            clear.push_back(is_clear(p, half));
        return clear;
    };
    std::vector<bool> clear = clear_places();
    if (std::find(clear.begin(), clear.end(), false) == clear.end()) {
        add(contour, width_mm);
        return LineFate::whole;
    }
    bool any = false;
    for (;;) { // the longest piece first; what is left of the others must keep its distance from it
        std::vector<std::vector<Vec2>> runs = runs_of(even, clear);
        const auto longest = std::max_element(
            runs.begin(), runs.end(), [](const auto& a, const auto& b) { return length_of({a, false}) < length_of({b, false}); });
        if (longest == runs.end() || longest->size() < 2 || length_of({*longest, false}) < shortest_mm)
            return any ? LineFate::partly : LineFate::left_out;
        add(path_through(contour.name, *longest), width_mm);
        any = true;
        clear = clear_places();
    }
}

LineFate SpacedLines::lay_middle(const Contour& contour, double narrower_than, double width_mm) {
    const auto middle = thinned(contour, narrower_than);
    if (!middle)
        return LineFate::left_out;
    const Polyline line = flatten(*middle, fine);
    if (length_of(line) < shortest_mm)
        return LineFate::left_out;
    const LineFate fate = lay_what_is_clear(*middle, line, width_mm);
    return fate == LineFate::whole ? LineFate::one_line : fate;
}

LineFate SpacedLines::lay(const Contour& contour, double width_mm) {
    const Polyline line = flatten(contour, fine);
    if (line.points.size() < 2 || !std::isfinite(length_of(line)) || length_of(line) < shortest_mm)
        return LineFate::left_out;
    if (thinned(contour, gap_mm + width_mm))
        return lay_middle(contour, gap_mm + width_mm, width_mm);
    const std::size_t before = lines_.size();
    const LineFate fate = lay_what_is_clear(contour, line, width_mm);
    double drawn = 0.0;
    for (std::size_t i = before; i < laid_.size(); ++i)
        drawn += length_of(laid_[i].line);
    if (fate == LineFate::whole || !contour.closed || drawn >= 0.5 * length_of(line))
        return fate;
    // Less than half of an opening's sides says less than the line between them.
    const std::vector<TactileLine> sides(lines_.begin() + static_cast<std::ptrdiff_t>(before), lines_.end());
    const std::vector<Laid> laid_sides(laid_.begin() + static_cast<std::ptrdiff_t>(before), laid_.end());
    lines_.resize(before);
    laid_.resize(before);
    if (const LineFate instead = lay_middle(contour, std::numeric_limits<double>::infinity(), width_mm);
        instead != LineFate::left_out)
        return instead;
    lines_.insert(lines_.end(), sides.begin(), sides.end());
    laid_.insert(laid_.end(), laid_sides.begin(), laid_sides.end());
    return fate;
}

double SpacedLines::distance_to_lines(const Rect& box) const {
    double least = std::numeric_limits<double>::infinity();
    const Polyline border{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, true};
    for (const Laid& other : laid_) {
        const Vec2 off = glm::max(other.box.min - box.max, box.min - other.box.max);
        if (std::max(off.x, off.y) - other.half_width >= least)
            continue;
        if (!other.line.points.empty() && box.contains(other.line.points.front()))
            return 0.0;
        least = std::min(least, std::max(0.0, between(border, other.line) - other.half_width));
    }
    return least;
}

double least_gap(const std::vector<TactileLine>& lines) {
    double least = std::numeric_limits<double>::infinity();
    std::vector<Polyline> flat;
    for (const TactileLine& line : lines)
        flat.push_back(flatten(line.path, fine));
    for (std::size_t i = 0; i < flat.size(); ++i)
        for (std::size_t k = i + 1; k < flat.size(); ++k) {
            const Rect one = box_round(flat[i]), other = box_round(flat[k]);
            const Vec2 off = glm::max(one.min - other.max, other.min - one.max);
            const double widths = 0.5 * (lines[i].width_mm + lines[k].width_mm);
            if (std::max(off.x, off.y) - widths < least)
                least = std::min(least, between(flat[i], flat[k]) - widths);
        }
    return least;
}

} // namespace tp
