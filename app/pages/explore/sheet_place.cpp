// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/sheet_place.hpp"

namespace tp {

namespace {
constexpr double least_stretch = 0.5; ///< from the screen's millimetres to the sheet's
constexpr double most_stretch =
    1.5; ///< 0.2 N/mm becomes 0.45 N/mm, for which the damping near a line suffices
} // namespace

bool SheetPlace::lies(double left, double top, double scale) {
    if (!(scale > 0.0))
        return false;
    const SheetPlace before = *this;
    const Vec2 middle = Vec2(left, -top) + scale * 0.5 * Vec2(frame_.width_mm, -frame_.height_mm);
    screen_to_surface_ = {glm::dmat2(1.0 / scale), -middle / scale};
    return !(*this == before);
}

std::optional<Affine> SheetPlace::from_device(const Calibration& calibration) const {
    const double real_mm = 1.0 / screen_to_surface_.linear[0].x;
    if (real_mm < 1.0 / most_stretch || real_mm > 1.0 / least_stretch)
        return std::nullopt;
    return compose(screen_to_surface_, calibration.device_to_surface);
}

bool SheetPlace::operator==(const SheetPlace& other) const {
    return screen_to_surface_.linear == other.screen_to_surface_.linear &&
           screen_to_surface_.offset == other.screen_to_surface_.offset;
}

} // namespace tp
