// SPDX-License-Identifier: Apache-2.0
#include "core/svg/arc_pieces.hpp"

#include "core/svg/svg_transform.hpp"

#include <2geom/elliptical-arc.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tp::svg {

namespace {

/// Distance of the usual cubic for a quarter of the unit circle from it; it falls with the sixth power of the
/// angle (Goldapp 1991).
constexpr double quarter_error = 2.74e-4;
/// Relative to the radius: below this, rounding hides the difference.
constexpr double finest_error = 1e-15;

int pieces_for(double sweep, double radius, double tolerance) {
    const double allowed = std::clamp(tolerance / radius, finest_error, quarter_error);
    const double step = 0.5 * std::numbers::pi * std::pow(allowed / quarter_error, 1.0 / 6.0);
    return std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / step - 1e-9)));
}

} // namespace

void append_arc(std::vector<Piece>& pieces, const Affine& unit_circle, double start, double sweep, Vec2 from,
                Vec2 to, double tolerance) {
    const double radius = largest_stretch(unit_circle);
    if (!(radius > 0.0) || !std::isfinite(radius) || !std::isfinite(start) || !std::isfinite(sweep)) {
        pieces.emplace_back(Line{from, to});
        return;
    }
    const int count = pieces_for(sweep, radius, tolerance);
    const double step = sweep / count;
    const double handle = 4.0 / 3.0 * std::tan(0.25 * step);
    const auto point = [](double angle) { return Vec2(std::cos(angle), std::sin(angle)); };
    const auto tangent = [](Vec2 p) { return Vec2(-p.y, p.x); };
    Vec2 a = from;
    Vec2 u = point(start);
    for (int i = 1; i <= count; ++i) {
        const Vec2 v = point(start + i * step);
        const Vec2 b = i == count ? to : unit_circle(v);
        pieces.emplace_back(
            Cubic{a, unit_circle(u + handle * tangent(u)), unit_circle(v - handle * tangent(v)), b});
        a = b;
        u = v;
    }
}

void append_path_arc(std::vector<Piece>& pieces, Vec2 from, double rx, double ry, double rotation, bool large,
                     bool clockwise, Vec2 to, double tolerance) {
    // A small arc leaves its chord by max(rx, ry) / 8 · (chord / min(rx, ry))² at most. Where that is
    // nothing, the ellipse's centre is too far away to be computed with.
    const double share = length(to - from) / std::min(rx, ry);
    const bool flat = !large && share < 0.1 && std::max(rx, ry) * share * share / 8.0 <= 0.5 * tolerance;
    const Geom::EllipticalArc arc(Geom::Point(from.x, from.y), rx, ry, rotation, large, clockwise,
                                  Geom::Point(to.x, to.y));
    const double sweep = arc.sweepAngle();
    if (flat || arc.isChord() || !(std::abs(sweep) > 0.0)) {
        pieces.emplace_back(Line{from, to});
        return;
    }
    const Geom::Affine m = arc.unitCircleTransform();
    const Affine unit_circle{glm::dmat2(m[0], m[1], m[2], m[3]), Vec2(m[4], m[5])};
    append_arc(pieces, unit_circle, arc.initialAngle().radians(), sweep, from, to, tolerance);
}

} // namespace tp::svg
