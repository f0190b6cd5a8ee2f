// SPDX-License-Identifier: Apache-2.0
#include "app/photo/scene/scene_builder.hpp"

#include "core/geometry/flatten.hpp"
#include "core/guidance/spacing.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tp {

namespace {

/// The rectangle round every contour of the faces, pixels; empty (max < min) where there is none.
Rect bounds_of_faces(const std::vector<Face>& faces) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Rect bounds{Vec2(infinity), Vec2(-infinity)};
    for (const Face& face : faces)
        for (const Contour& contour : face.contours)
            for (const Vec2 p : flatten(contour, {0.02, 10.0}).points) {
                bounds.min = glm::min(bounds.min, p);
                bounds.max = glm::max(bounds.max, p);
            }
    return bounds;
}

Face only_part(Face face, FacePart part) {
    std::erase_if(face.contours, [&](const Contour& contour) { return !belongs_to(part, contour.name); });
    return face;
}

constexpr double reach_margin_mm = 4.0; ///< beyond a line, where its pull is strongest

bool is_inside(const std::vector<Vec2>& polygon, Vec2 p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

/// Whether some of the way from a to b lies in the rectangle (Liang and Barsky 1984).
bool crosses(Vec2 a, Vec2 b, const Rect& rect) {
    double from = 0.0, to = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double way = b[axis] - a[axis], low = rect.min[axis] - a[axis], high = rect.max[axis] - a[axis];
        if (way == 0.0 && (low > 0.0 || high < 0.0))
            return false;
        if (way != 0.0) {
            from = std::max(from, std::min(low / way, high / way));
            to = std::min(to, std::max(low / way, high / way));
        }
    }
    return from <= to;
}

bool is_reached(const std::vector<Vec2>& reach, const Rect& rect) {
    if (!is_inside(reach, rect.centre()))
        return false;
    for (std::size_t i = 0; i < reach.size(); ++i)
        if (crosses(reach[i], reach[(i + 1) % reach.size()], rect))
            return false;
    return true;
}

/// What of the surface the subject may fill: inside the margin, and as large as a rectangle of its shape in
/// the middle of the device's reach. All inside the margin where that middle cannot be reached.
Rect room_for(const Rect& subject, const SurfaceSize& surface) {
    constexpr int halvings = 40;
    const Vec2 half(0.5 * surface.width_mm - surface.margin_mm, 0.5 * surface.height_mm - surface.margin_mm);
    const Rect room{-half, half};
    const Vec2 shape(subject.width(), subject.height());
    if (surface.reach.empty() || !(shape.x > 0.0 && shape.y > 0.0))
        return room;
    const Rect bounds = bounds_of(surface.reach);
    const Vec2 middle = Rect{glm::max(room.min, bounds.min), glm::min(room.max, bounds.max)}.centre();
    const auto around = [&](double scale, double more) {
        const Vec2 extent = 0.5 * scale * shape + more;
        return Rect{middle - extent, middle + extent};
    };
    double fitting = 0.0, too_large = std::max(room.width() / shape.x, room.height() / shape.y);
    for (int halving = 0; halving < halvings; ++halving) {
        const double scale = 0.5 * (fitting + too_large);
        const Rect rect = around(scale, 0.0);
        const bool fits = room.contains(rect.min) && room.contains(rect.max) &&
                          is_reached(surface.reach, around(scale, reach_margin_mm));
        (fits ? fitting : too_large) = scale;
    }
    return fitting > 0.0 ? around(fitting, 0.0) : room;
}

} // namespace

bool belongs_to(FacePart part, std::string_view name) {
    const bool left = name == feature::left_eye || name == feature::left_iris || name == feature::left_brow;
    const bool right =
        name == feature::right_eye || name == feature::right_iris || name == feature::right_brow;
    switch (part) {
    case FacePart::whole:
        return true;
    case FacePart::eyes:
        return left || right;
    case FacePart::left_eye:
        return left;
    case FacePart::right_eye:
        return right;
    case FacePart::mouth:
        return name == feature::outer_lip || name == feature::inner_lip;
    }
    return false;
}

Result<BuiltScene> build_scene(const Extraction& extraction, const SurfaceSize& surface,
                               std::optional<std::size_t> face) {
    return build_scene(extraction, surface, Subject{face});
}

Result<BuiltScene> build_scene(const Extraction& extraction, const SurfaceSize& surface,
                               const Subject& subject) {
    if (extraction.faces.empty())
        return Error{extraction.problem.empty() ? "No face was found in this picture." : extraction.problem};
    if (subject.face && *subject.face >= extraction.faces.size())
        return Error{"There is no face " + std::to_string(*subject.face + 1) + " in this picture; it has " +
                     std::to_string(extraction.faces.size()) + "."};
    std::vector<Face> faces;
    std::vector<SceneFeature> features;
    for (std::size_t i = 0; i < extraction.faces.size(); ++i) {
        if (subject.face && *subject.face != i)
            continue;
        faces.push_back(only_part(extraction.faces[i], subject.part));
        for (const Contour& contour : faces.back().contours)
            features.push_back({i, contour.name});
    }
    if (features.empty() && subject.part != FacePart::whole)
        return Error{"This part of the face was not found in the picture."};

    const Rect bounds = bounds_of_faces(faces);
    const Result<Affine> fitted = fit_photo_to_surface(bounds, room_for(bounds, surface));
    if (!fitted)
        return Error{fitted.error()};

    return BuiltScene{scene_of(faces, surface, *fitted), *fitted, std::move(features)};
}

std::optional<double> narrowest_eye_mm(const BuiltScene& built) {
    std::optional<double> narrowest;
    for (std::size_t i = 0; i < built.features.size(); ++i) {
        if (built.features[i].name != feature::left_eye && built.features[i].name != feature::right_eye)
            continue;
        const std::vector<Vec2> points = flatten(built.scene.contours[i]).points;
        double width = 0.0;
        for (const Vec2 a : points)
            for (const Vec2 b : points)
                width = std::max(width, length(a - b));
        narrowest = std::min(width, narrowest.value_or(width));
    }
    return narrowest;
}

Scene scene_of(const std::vector<Face>& faces, const SurfaceSize& surface, const Affine& photo_to_surface) {
    Scene scene{surface.width_mm, surface.height_mm, {}};
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (const Contour& contour : faces[i].contours) {
            const Contour felt = mapped(contour, photo_to_surface);
            scene.contours.push_back(thinned(felt).value_or(felt));
            if (faces.size() > 1)
                scene.contours.back().name = "face " + std::to_string(i + 1) + " " + contour.name;
        }
    return scene;
}

} // namespace tp
