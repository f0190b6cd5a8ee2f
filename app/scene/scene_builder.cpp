// SPDX-License-Identifier: Apache-2.0
#include "app/scene/scene_builder.hpp"

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
            for (const Vec2 p : flatten(contour, {0.5, 10.0}).points) {
                bounds.min = glm::min(bounds.min, p);
                bounds.max = glm::max(bounds.max, p);
            }
    return bounds;
}

Face only_part(Face face, FacePart part) {
    std::erase_if(face.contours, [&](const Contour& contour) { return !belongs_to(part, contour.name); });
    return face;
}

} // namespace

bool belongs_to(FacePart part, std::string_view name) {
    const bool left = name == feature::left_eye || name == feature::left_iris || name == feature::left_brow;
    const bool right = name == feature::right_eye || name == feature::right_iris || name == feature::right_brow;
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

Result<BuiltScene> build_scene(const Extraction& extraction, const SurfaceSize& surface, const Subject& subject) {
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

    const Vec2 half(0.5 * surface.width_mm - surface.margin_mm, 0.5 * surface.height_mm - surface.margin_mm);
    const Result<Affine> fitted = fit_photo_to_surface(bounds_of_faces(faces), {-half, half});
    if (!fitted)
        return Error{fitted.error()};

    return BuiltScene{scene_of(faces, surface, *fitted), *fitted, std::move(features)};
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
