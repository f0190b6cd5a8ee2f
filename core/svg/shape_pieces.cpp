// SPDX-License-Identifier: Apache-2.0
#include "core/svg/shape_pieces.hpp"

#include "core/geometry/transform.hpp"
#include "core/svg/arc_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace tp::svg {

namespace {

using Subpaths = Result<std::vector<Subpath>>;

/// Reads the lengths of one element and remembers the first that it cannot read.
class Lengths {
public:
    Lengths(pugi::xml_node shape, const LengthScale& scale) : shape_(shape), scale_(scale) {}

    double x(const char* name) { return length(name, scale_.width); }
    double y(const char* name) { return length(name, scale_.height); }
    double radius(const char* name) { return length(name, scale_.diagonal()); }
    bool has(const char* name) const {
        const std::string_view text = trimmed(shape_.attribute(name).value());
        return !text.empty() && text != "auto";
    }

    bool ok() const { return trouble_.empty(); }
    Error error() const { return Error{trouble_}; }

private:
    double length(const char* name, double whole) {
        if (!has(name))
            return 0.0;
        const auto value = length_in_units(shape_.attribute(name).value(), scale_.units_per_mm, whole);
        if (value && std::isfinite(*value))
            return *value;
        if (trouble_.empty())
            trouble_ = std::string("has a length \"") + name + "\" that cannot be read";
        return 0.0;
    }

    pugi::xml_node shape_;
    const LengthScale& scale_;
    std::string trouble_;
};

Subpaths none() { return std::vector<Subpath>{}; }

Subpaths one(Subpath path) {
    std::vector<Subpath> paths;
    paths.push_back(std::move(path));
    return paths;
}

void append_line(Subpath& path, Vec2 to) {
    const Vec2 from = path.pieces.empty() ? path.start : end_of(path.pieces.back());
    if (from != to)
        path.pieces.emplace_back(Line{from, to});
}

/// From the angle `start` (radians, clockwise on the sheet) a quarter turn on, about `centre`.
void append_quarter(Subpath& path, Vec2 centre, Vec2 radii, int quarter, Vec2 to, double tolerance) {
    const Vec2 from = path.pieces.empty() ? path.start : end_of(path.pieces.back());
    const Affine unit_circle{glm::dmat2(radii.x, 0.0, 0.0, radii.y), centre};
    append_arc(path.pieces, unit_circle, quarter * 0.5 * std::numbers::pi, 0.5 * std::numbers::pi, from, to,
               tolerance);
}

Subpaths line(Lengths& lengths) {
    const Vec2 a(lengths.x("x1"), lengths.y("y1"));
    const Vec2 b(lengths.x("x2"), lengths.y("y2"));
    return lengths.ok() ? one({a, {Line{a, b}}, false}) : lengths.error();
}

Subpaths polyline(pugi::xml_node shape, bool closed) {
    const auto numbers = number_list(shape.attribute("points").value());
    if (!numbers || numbers->size() % 2 != 0)
        return Error{"has a list of points that is broken"};
    if (numbers->size() < 4)
        return none();
    Subpath path{Vec2((*numbers)[0], (*numbers)[1]), {}, closed};
    for (std::size_t i = 2; i < numbers->size(); i += 2)
        append_line(path, Vec2((*numbers)[i], (*numbers)[i + 1]));
    return one(std::move(path));
}

Subpaths ellipse(Vec2 centre, Vec2 radii, double tolerance) {
    if (!(radii.x > 0.0) || !(radii.y > 0.0))
        return none();
    const Vec2 right = centre + Vec2(radii.x, 0.0);
    Subpath path{right, {}, true};
    append_quarter(path, centre, radii, 0, centre + Vec2(0.0, radii.y), tolerance);
    append_quarter(path, centre, radii, 1, centre - Vec2(radii.x, 0.0), tolerance);
    append_quarter(path, centre, radii, 2, centre - Vec2(0.0, radii.y), tolerance);
    append_quarter(path, centre, radii, 3, right, tolerance);
    return one(std::move(path));
}

Subpaths rectangle(Lengths& lengths, double tolerance) {
    const Vec2 a(lengths.x("x"), lengths.y("y"));
    const Vec2 size{lengths.x("width"), lengths.y("height")}; // in this order: the first fault is told
    Vec2 round(lengths.x("rx"), lengths.y("ry"));
    if (!lengths.ok())
        return lengths.error();
    if (!(size.x > 0.0) || !(size.y > 0.0))
        return none();
    if (!lengths.has("rx") || round.x < 0.0)
        round.x = round.y;
    if (!lengths.has("ry") || round.y < 0.0)
        round.y = round.x;
    round = glm::clamp(round, Vec2(0.0), 0.5 * size);
    const Vec2 b = a + size;
    const bool rounded = round.x > 0.0 && round.y > 0.0;
    if (!rounded)
        round = Vec2(0.0);
    Subpath path{Vec2(a.x + round.x, a.y), {}, true};
    const auto corner = [&](Vec2 centre, int quarter, Vec2 to) {
        if (rounded)
            append_quarter(path, centre, round, quarter, to, tolerance);
    };
    append_line(path, Vec2(b.x - round.x, a.y));
    corner(Vec2(b.x - round.x, a.y + round.y), 3, Vec2(b.x, a.y + round.y));
    append_line(path, Vec2(b.x, b.y - round.y));
    corner(b - round, 0, Vec2(b.x - round.x, b.y));
    append_line(path, Vec2(a.x + round.x, b.y));
    corner(Vec2(a.x + round.x, b.y - round.y), 1, Vec2(a.x, b.y - round.y));
    append_line(path, Vec2(a.x, a.y + round.y));
    corner(a + round, 2, path.start);
    return one(std::move(path));
}

Subpaths circle(Lengths& lengths, double tolerance) {
    const Vec2 centre(lengths.x("cx"), lengths.y("cy"));
    const Vec2 radii(lengths.radius("r"));
    return lengths.ok() ? ellipse(centre, radii, tolerance) : lengths.error();
}

Subpaths ellipse(Lengths& lengths, double tolerance) {
    const Vec2 centre(lengths.x("cx"), lengths.y("cy"));
    Vec2 radii(lengths.x("rx"), lengths.y("ry"));
    if (!lengths.has("rx"))
        radii.x = radii.y;
    if (!lengths.has("ry"))
        radii.y = radii.x;
    return lengths.ok() ? ellipse(centre, radii, tolerance) : lengths.error();
}

} // namespace

bool is_shape(std::string_view name) {
    constexpr std::array<std::string_view, 7> shapes = {"path", "line",   "polyline", "polygon",
                                                        "rect", "circle", "ellipse"};
    return std::find(shapes.begin(), shapes.end(), name) != shapes.end();
}

Subpaths subpaths_of(pugi::xml_node shape, std::string_view name, const LengthScale& scale, double tolerance,
                     std::size_t piece_limit) {
    Lengths lengths(shape, scale);
    if (name == "path")
        return subpaths_from(shape.attribute("d").value(), tolerance, piece_limit);
    if (name == "line")
        return line(lengths);
    if (name == "polyline" || name == "polygon")
        return polyline(shape, name == "polygon");
    if (name == "rect")
        return rectangle(lengths, tolerance);
    if (name == "circle")
        return circle(lengths, tolerance);
    if (name == "ellipse")
        return ellipse(lengths, tolerance);
    return none();
}

} // namespace tp::svg
