// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/contour.hpp"

namespace tp {

namespace {

Vec2 mix(Vec2 a, Vec2 b, double t) { return (1.0 - t) * a + t * b; }

struct PointAt {
    double t;
    Vec2 operator()(const Line& p) const { return mix(p.a, p.b, t); }
    Vec2 operator()(const Quadratic& p) const {
        return mix(mix(p.a, p.control, t), mix(p.control, p.b, t), t);
    }
    Vec2 operator()(const Cubic& p) const {
        const Vec2 q = mix(p.control_a, p.control_b, t);
        return mix(mix(mix(p.a, p.control_a, t), q, t), mix(q, mix(p.control_b, p.b, t), t), t);
    }
};

struct AllFinite {
    bool operator()(const Line& p) const { return is_finite(p.a) && is_finite(p.b); }
    bool operator()(const Quadratic& p) const {
        return is_finite(p.a) && is_finite(p.control) && is_finite(p.b);
    }
    bool operator()(const Cubic& p) const {
        return is_finite(p.a) && is_finite(p.control_a) && is_finite(p.control_b) && is_finite(p.b);
    }
};

} // namespace

Vec2 start_of(const Piece& piece) {
    return std::visit([](const auto& p) { return p.a; }, piece);
}

Vec2 end_of(const Piece& piece) {
    return std::visit([](const auto& p) { return p.b; }, piece);
}

Vec2 point_at(const Piece& piece, double t) { return std::visit(PointAt{t}, piece); }

bool is_finite(const Piece& piece) { return std::visit(AllFinite{}, piece); }

Contour contour_through(std::string name, const std::vector<Vec2>& points, bool closed) {
    Contour contour{std::move(name), {}, closed};
    if (points.size() == 1)
        contour.pieces.emplace_back(Line{points.front(), points.front()});
    for (std::size_t i = 1; i < points.size(); ++i)
        contour.pieces.emplace_back(Line{points[i - 1], points[i]});
    if (closed && points.size() > 1)
        contour.pieces.emplace_back(Line{points.back(), points.front()});
    return contour;
}

} // namespace tp
