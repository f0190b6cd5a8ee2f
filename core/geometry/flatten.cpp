// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/flatten.hpp"

#include <algorithm>
#include <numbers>

namespace tp {

namespace {

/// Angle between two directions, radians; 0 where one of them has no direction.
double turn_between(Vec2 u, Vec2 v) {
    const double size = length(u) * length(v);
    if (!(size > 0.0) || !std::isfinite(size))
        return 0.0;
    return std::abs(std::atan2(cross(u / length(u), v / length(v)), glm::dot(u / length(u), v / length(v))));
}

double distance_from_chord(Vec2 a, Vec2 b, Vec2 p) { return length(p - nearest_on_segment(a, b, p)); }

Vec2 middle(Vec2 a, Vec2 b) { return 0.5 * a + 0.5 * b; }

class Flattener {
public:
    Flattener(const FlattenTolerance& tolerance, std::vector<Vec2>& out)
        : tolerance_(tolerance), facet_(tolerance.facet_degrees * std::numbers::pi / 180.0), out_(out) {}

    void operator()(const Line& p) {
        emit(p.a);
        emit(p.b);
    }

    void operator()(const Quadratic& p) {
        emit(p.a);
        subdivide(p, 0);
    }

    void operator()(const Cubic& p) {
        emit(p.a);
        subdivide(p, 0);
    }

private:
    void emit(Vec2 p) {
        if (out_.empty() || out_.back() != p)
            out_.push_back(p);
    }

    /// The turn of a control polygon bounds the turn of its curve, and its distance from the chord bounds the
    /// curve's (the convex-hull property), so both tests err on the fine side.
    bool fine(const Quadratic& p) const {
        return distance_from_chord(p.a, p.b, p.control) <= 2.0 * tolerance_.chord &&
               turn_between(p.control - p.a, p.b - p.control) <= facet_;
    }

    bool fine(const Cubic& p) const {
        const double reach =
            std::max(distance_from_chord(p.a, p.b, p.control_a), distance_from_chord(p.a, p.b, p.control_b));
        const double turn =
            turn_between(p.control_a - p.a, p.control_b - p.control_a) +
            turn_between(p.control_b - p.control_a, p.b - p.control_b) +
            (p.control_a == p.control_b ? turn_between(p.control_a - p.a, p.b - p.control_b) : 0.0);
        return reach <= tolerance_.chord * 4.0 / 3.0 && turn <= facet_;
    }

    void subdivide(const Quadratic& p, int depth) {
        if (depth >= tolerance_.max_depth || fine(p)) {
            emit(p.b);
            return;
        }
        const Vec2 left = middle(p.a, p.control);
        const Vec2 right = middle(p.control, p.b);
        const Vec2 centre = middle(left, right);
        subdivide(Quadratic{p.a, left, centre}, depth + 1);
        subdivide(Quadratic{centre, right, p.b}, depth + 1);
    }

    void subdivide(const Cubic& p, int depth) {
        if (depth >= tolerance_.max_depth || fine(p)) {
            emit(p.b);
            return;
        }
        const Vec2 left = middle(p.a, p.control_a);
        const Vec2 top = middle(p.control_a, p.control_b);
        const Vec2 right = middle(p.control_b, p.b);
        const Vec2 left_top = middle(left, top);
        const Vec2 right_top = middle(top, right);
        const Vec2 centre = middle(left_top, right_top);
        subdivide(Cubic{p.a, left, left_top, centre}, depth + 1);
        subdivide(Cubic{centre, right_top, right, p.b}, depth + 1);
    }

    const FlattenTolerance& tolerance_;
    double facet_;
    std::vector<Vec2>& out_;
};

} // namespace

Polyline flatten(const Contour& contour, const FlattenTolerance& tolerance) {
    Polyline line{{}, contour.closed};
    Flattener flattener(tolerance, line.points);
    for (const Piece& piece : contour.pieces)
        if (is_finite(piece))
            std::visit(flattener, piece);
    if (line.closed && line.points.size() > 1 && line.points.front() == line.points.back())
        line.points.pop_back();
    return line;
}

} // namespace tp
