// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/felt_change.hpp"

#include "app/photo/picture/field_picture.hpp"
#include "app/photo/scene/scene_builder.hpp"
#include "core/guidance/haptic_scene.hpp"

#include <QRgb>

#include <algorithm>
#include <cmath>
#include <memory>

namespace tp {

namespace {

constexpr double pixels_per_mm = 3.0;

/// The picture to be laid over another one: the less force, the less is seen of it.
QImage see_through(const QImage& picture) {
    constexpr int no_force = 30, most = 205; // lightness of the colour of no force; opacity where it is strong
    QImage over = picture.convertToFormat(QImage::Format_ARGB32);
    for (int y = 0; y < over.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(over.scanLine(y));
        for (int x = 0; x < over.width(); ++x) {
            const int light = std::max({qRed(line[x]), qGreen(line[x]), qBlue(line[x])});
            line[x] = qRgba(qRed(line[x]), qGreen(line[x]), qBlue(line[x]), std::clamp(3 * (light - no_force), 0, most));
        }
    }
    return over;
}

Result<BuiltScene> fitted(const std::vector<Face>& faces, const SurfaceSize& surface) {
    Extraction extraction;
    extraction.faces = faces;
    return build_scene(extraction, surface);
}

} // namespace

FeltChange felt_change(const std::vector<Face>& before, const std::vector<Face>& now) {
    FeltChange change;
    const SurfaceSize surface;
    Result<BuiltScene> built = fitted(before, surface);
    if (!built)
        built = fitted(now, surface);
    if (!built)
        return change;
    const Scene scene = scene_of(now, surface, built->photo_to_surface);
    const auto haptic = make_haptic_scene(scene);
    const auto back = built->photo_to_surface.inverse();
    if (!haptic || !back)
        return change;
    const Rect area = scene.surface();
    const QImage picture = draw_force_field(**haptic, area, pixels_per_mm);
    change.field = see_through(picture.copy(0, 0, picture.width(), // without its legend
                                            static_cast<int>(std::lround(area.height() * pixels_per_mm))));
    const Vec2 top_left = (*back)({area.min.x, area.max.y}), bottom_right = (*back)({area.max.x, area.min.y});
    change.place = QRectF(QPointF(top_left.x, top_left.y), QPointF(bottom_right.x, bottom_right.y));
    if (const auto was = make_haptic_scene(scene_of(before, surface, built->photo_to_surface)))
        change.difference = difference_between(*(*was)->law, *(*haptic)->law, area);
    return change;
}

std::vector<Face> found_faces(const MendWork& work) {
    MendWork found = work;
    for (MendFace& face : found.faces)
        for (MendFeature& own : face.features)
            own.line = own.found_felt ? own.found : std::nullopt;
    return faces_of(found);
}

} // namespace tp
