// SPDX-License-Identifier: Apache-2.0
#include "app/photo/sight/look.hpp"

#include "app/photo/sight/face_sight.hpp"
#include "app/photo/sight/picture_sight.hpp"

namespace tp {

namespace {

/// More of a face's box than that beyond the edge: the edge cuts the face.
constexpr double cut_share = 0.05;

SeenFace seen_face(const Face& face, Vec2 size) {
    SeenFace seen;
    seen.part = {face.box.min / size, face.box.max / size};
    const Vec2 beyond = glm::max(-face.box.min, face.box.max - size);
    seen.cut_off = beyond.x > cut_share * face.box.width() || beyond.y > cut_share * face.box.height();
    if (const auto measures = measures_of(face)) {
        seen.mien = mien_of(*measures);
        seen.eyes = eyes_of(*measures);
        seen.facing = facing_of(*measures);
    }
    return seen;
}

} // namespace

SeenPhoto look_at(const cv::Mat& picture, const Extraction& found) {
    SeenPhoto seen;
    seen.width = found.width;
    seen.height = found.height;
    seen.turned_degrees = found.turned_degrees;
    if (found.width <= 0 || found.height <= 0)
        return seen;
    for (const Face& face : found.faces)
        seen.faces.push_back(seen_face(face, Vec2(found.width, found.height)));
    const PictureMeasures measures = measures_of(picture, found);
    seen.light = light_of(measures);
    seen.colours = colours_of(measures);
    seen.blurred = is_blurred(measures);
    return seen;
}

} // namespace tp
