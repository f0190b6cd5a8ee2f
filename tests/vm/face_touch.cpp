// SPDX-License-Identifier: Apache-2.0
#include "face_touch.hpp"

#include "core/geometry/transform.hpp"
#include "core/svg/contour_sheet.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace tp::vm {

namespace {

constexpr double half_size = 40.0; ///< mm
constexpr double swing = 20.0;     ///< mm of way from one side of a line to the other
constexpr double step = 1.0;       ///< mm

} // namespace

Result<Scene> face_of(const std::string& svg_file) {
    const Result<ContourSheet> sheet = read_sheet(svg_file, ContourSheet::Unit::pixel);
    if (!sheet)
        return Error{sheet.error()};
    std::vector<Vec2> points;
    for (const Contour& contour : sheet->contours)
        for (const Vec2& point : flatten(contour).points)
            points.push_back(point);
    const Result<Affine> fit =
        fit_photo_to_surface(bounds_of(points), Rect{Vec2(-half_size), Vec2(half_size)});
    if (!fit)
        return Error{fit.error()};
    Scene face{2.0 * half_size, 2.0 * half_size, {}};
    for (const Contour& contour : sheet->contours)
        face.contours.push_back(mapped(contour, *fit));
    return face;
}

Polyline way_beside(const Scene& face, double beside) {
    Polyline way{{}, true};
    for (const Contour& contour : face.contours) {
        const Polyline line = flatten(contour);
        const double length = length_of(line);
        for (double arc = 0.0; arc < length; arc += step) {
            const Vec2 at = point_along(line, arc);
            const Vec2 ahead = point_along(line, arc + 0.1) - at;
            if (tp::length(ahead) > 0.0) {
                const Vec2 across = Vec2(-ahead.y, ahead.x) / tp::length(ahead);
                way.points.push_back(at +
                                     beside * (std::fmod(arc, 2.0 * swing) < swing ? 1.0 : -1.0) * across);
            }
        }
    }
    return way;
}

} // namespace tp::vm
