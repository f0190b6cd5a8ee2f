// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/touch_drive.hpp"

#include <algorithm>
#include <utility>

namespace tp {

namespace {

/// A hand at rest trembles at 6 to 12 Hz (Lakie et al., "Increased gravitational force reveals the mechanical, resonant nature of
/// physiological tremor", Journal of Physiology 593, 2015). Surgeons who held an instrument still stayed within 0.2 mm (Riviere,
/// Rader, Khosla, "Characteristics of hand motion of eye surgeons", IEEE EMBS 1997); of other hands more is assumed.
constexpr double tremble_mm = 0.3;

double scale_of(const TouchCapabilities& can, Vec2 surface) {
    if (!can.pad)
        return 1.0;
    const Vec2 size = can.pad->max - can.pad->min;
    return std::min(surface.x / size.x, surface.y / size.y);
}

TouchSettings on_surface(TouchSettings settings, const TouchCapabilities& can, Vec2 surface) {
    if (can.pad)
        settings.pad_to_surface = pad_on_surface(*can.pad, surface);
    return settings;
}

std::vector<Vec2> reach_of(const TouchCapabilities& can, Vec2 surface) {
    const Rect& pad = *can.pad;
    const Affine map = pad_on_surface(pad, surface);
    return {map(pad.min), map({pad.max.x, pad.min.y}), map(pad.max), map({pad.min.x, pad.max.y})};
}

} // namespace

Affine pad_on_surface(const Rect& pad, Vec2 surface) {
    const Vec2 size = pad.max - pad.min;
    const double scale = std::min(surface.x / size.x, surface.y / size.y);
    return {glm::dmat2(scale), -scale * pad.centre()};
}

TouchDrive::TouchDrive(std::unique_ptr<TouchOutput> output, const TouchCapabilities& can, Vec2 surface,
                       TouchSettings settings, Clock* clock)
    : output_(std::move(output)), drawn_(dynamic_cast<DrawnTouch*>(output_.get())),
      scale_(scale_of(can, surface)),
      loop_(*output_, can, clock != nullptr ? *clock : own_clock_, on_surface(settings, can, surface)) {
    if (can.pad && drawn_ == nullptr)
        reach_ = reach_of(can, surface);
}

std::uint64_t TouchDrive::show(FlatScene scene, std::optional<Polyline> tour) {
    FrictionChoices choices;
    choices.again_mm = tremble_mm;
    auto made = make_touch_scene(std::move(scene), choices.enlarged(scale_));
    if (!made)
        return loop_.render(nullptr);
    (*made)->tour = std::move(tour);
    return loop_.render(std::move(*made));
}

void TouchDrive::move(Vec2 place) {
    if (is_pad())
        return;
    if (drawn_ != nullptr)
        drawn_->move_hand(place);
    else
        loop_.tell(place);
}

void TouchDrive::set_down(Vec2 place) {
    if (is_pad())
        return;
    if (drawn_ != nullptr)
        return drawn_->set_down(place);
    loop_.tell_set_down(place);
}

void TouchDrive::lift() {
    if (is_pad())
        return;
    if (drawn_ != nullptr)
        drawn_->lift();
    else
        loop_.tell_lifted();
}

} // namespace tp
