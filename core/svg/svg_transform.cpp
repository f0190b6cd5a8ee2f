// SPDX-License-Identifier: Apache-2.0
#include "core/svg/svg_transform.hpp"

#include "core/svg/svg_number.hpp"

#include <2geom/transforms.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tp::svg {

namespace {

Affine translation(double x, double y) { return {glm::dmat2(1.0), Vec2(x, y)}; }

/// lib2geom's, because it is exact at quarter turns.
Affine rotation(double degrees) {
    const Geom::Affine turn = Geom::Rotate::from_degrees(degrees);
    return {glm::dmat2(turn[0], turn[1], turn[2], turn[3]), Vec2(0.0)};
}

double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180.0); }

bool is_finite(const Affine& map) {
    return tp::is_finite(map.linear[0]) && tp::is_finite(map.linear[1]) && tp::is_finite(map.offset);
}

std::optional<Affine> step_from(std::string_view name, const std::vector<double>& n) {
    if (name == "matrix" && n.size() == 6)
        return Affine{glm::dmat2(n[0], n[1], n[2], n[3]), Vec2(n[4], n[5])};
    if (name == "translate" && (n.size() == 1 || n.size() == 2))
        return translation(n[0], n.size() == 2 ? n[1] : 0.0);
    if (name == "scale" && (n.size() == 1 || n.size() == 2))
        return Affine{glm::dmat2(n[0], 0.0, 0.0, n.back()), Vec2(0.0)};
    if (name == "rotate" && n.size() == 1)
        return rotation(n[0]);
    if (name == "rotate" && n.size() == 3)
        return compose(translation(n[1], n[2]), compose(rotation(n[0]), translation(-n[1], -n[2])));
    if (name == "skewX" && n.size() == 1)
        return Affine{glm::dmat2(1.0, 0.0, tangent(n[0]), 1.0), Vec2(0.0)};
    if (name == "skewY" && n.size() == 1)
        return Affine{glm::dmat2(1.0, tangent(n[0]), 0.0, 1.0), Vec2(0.0)};
    return std::nullopt;
}

double align(std::string_view word, char axis, double spare) {
    const std::size_t at = word.find(axis);
    const std::string_view where = at == std::string_view::npos ? "" : word.substr(at + 1, 3);
    return where == "Min" ? 0.0 : where == "Max" ? spare : 0.5 * spare;
}

} // namespace

std::optional<Affine> transform_from(std::string_view text) {
    Affine map;
    text = trimmed(text);
    while (!text.empty() && text != "none") {
        const std::size_t open = text.find('(');
        const std::size_t close = text.find(')');
        if (close == std::string_view::npos || open > close)
            return std::nullopt;
        const auto numbers = number_list(text.substr(open + 1, close - open - 1));
        const auto step = numbers ? step_from(trimmed(text.substr(0, open)), *numbers) : std::nullopt;
        if (!step || !is_finite(*step))
            return std::nullopt;
        map = compose(map, *step);
        text = trimmed(text.substr(close + 1));
        if (!text.empty() && text.front() == ',')
            text = trimmed(text.substr(1));
    }
    return is_finite(map) ? std::optional(map) : std::nullopt;
}

std::optional<ViewBox> view_box_from(std::string_view text) {
    const auto n = number_list(text);
    if (!n || n->size() != 4 ||
        !std::all_of(n->begin(), n->end(), [](double v) { return std::isfinite(v); }) || !((*n)[2] > 0.0) ||
        !((*n)[3] > 0.0))
        return std::nullopt;
    return ViewBox{(*n)[0], (*n)[1], (*n)[2], (*n)[3]};
}

Affine fit_view_box(const ViewBox& box, double width, double height, std::string_view preserve_aspect_ratio) {
    Vec2 scale(width / box.width, height / box.height);
    if (preserve_aspect_ratio.find("none") == std::string_view::npos)
        scale =
            Vec2(preserve_aspect_ratio.find("slice") == std::string_view::npos ? std::min(scale.x, scale.y)
                                                                               : std::max(scale.x, scale.y));
    const Vec2 corner(align(preserve_aspect_ratio, 'x', width - scale.x * box.width),
                      align(preserve_aspect_ratio, 'Y', height - scale.y * box.height));
    return {glm::dmat2(scale.x, 0.0, 0.0, scale.y), corner - scale * Vec2(box.x, box.y)};
}

double largest_stretch(const Affine& map) {
    // The larger singular value, from the sum and the difference of both.
    const glm::dmat2& m = map.linear;
    const double sum = std::hypot(m[0][0] + m[1][1], m[0][1] - m[1][0]);
    const double difference = std::hypot(m[0][0] - m[1][1], m[0][1] + m[1][0]);
    return 0.5 * sum + 0.5 * difference;
}

} // namespace tp::svg
