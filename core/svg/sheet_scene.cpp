// SPDX-License-Identifier: Apache-2.0
#include "core/svg/contour_sheet.hpp"

namespace tp {

Scene scene_from_sheet(const ContourSheet& sheet) {
    Scene scene;
    if (sheet.unit != ContourSheet::Unit::millimetre)
        return scene;
    scene.width_mm = sheet.width;
    scene.height_mm = sheet.height;
    const auto to_surface = [&](Vec2 p) { return Vec2(p.x - 0.5 * sheet.width, 0.5 * sheet.height - p.y); };
    for (const Contour& contour : sheet.contours)
        scene.contours.push_back(mapped(contour, to_surface));
    return scene;
}

ContourSheet sheet_from_scene(const Scene& scene) {
    ContourSheet sheet{scene.width_mm, scene.height_mm, ContourSheet::Unit::millimetre, {}};
    const auto to_sheet = [&](Vec2 p) {
        return Vec2(p.x + 0.5 * scene.width_mm, 0.5 * scene.height_mm - p.y);
    };
    for (const Contour& contour : scene.contours)
        sheet.contours.push_back(mapped(contour, to_sheet));
    return sheet;
}

} // namespace tp
