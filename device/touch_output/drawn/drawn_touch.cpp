// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/drawn/drawn_touch.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <utility>

namespace tp {

DrawnTouch::DrawnTouch(double width_mm, double height_mm, std::shared_ptr<TickListener> listener)
    : half_(0.5 * width_mm, 0.5 * height_mm), listener_(std::move(listener)) {}

Result<TouchCapabilities> DrawnTouch::open() {
    stopped_ = false;
    if (listener_)
        listener_->begin();
    TouchCapabilities can;
    can.name = "drawn finger";
    can.means = TouchMeans::friction;
    can.rate = 1000.0;
    can.pad = Rect{-half_, half_};
    return can;
}

void DrawnTouch::send(Vec2 place, bool touched, bool down) noexcept {
    if (!is_finite(place))
        return;
    const Vec2 inside = glm::clamp(place, -half_, half_);
    sent_ = {inside.x, inside.y, sent_.downs + (down ? 1 : 0), touched};
    hand_.publish(sent_);
}

std::optional<PadTouch> DrawnTouch::read(double now) noexcept {
    const Hand hand = hand_.latest();
    const Vec2 place(hand.x, hand.y);
    if (now >= level_until_)
        level_.store(0.0, std::memory_order_relaxed);
    const bool elsewhere = hand.downs != downs_ || time_ < 0.0;
    if (elsewhere)
        finger_.place = place;
    else
        finger_.step(place, level_.load(std::memory_order_relaxed), std::max(0.0, now - time_));
    downs_ = hand.downs;
    time_ = now;
    PadTouch touch;
    touch.time = now;
    touch.touched = hand.touched && !elsewhere; // lifted between, so that nothing on the way was crossed
    touch.place = finger_.place;
    return touch;
}

bool DrawnTouch::resist(double level) noexcept {
    if (stopped_)
        return false;
    level_.store(level > 0.0 ? std::min(level, 1.0) : 0.0, std::memory_order_relaxed);
    level_until_ = time_ + friction_lasts_s;
    return true;
}

bool DrawnTouch::tick(const Tick& tick) noexcept {
    if (stopped_)
        return false;
    if (listener_ && !tick.empty())
        listener_->ticked(tick, time_);
    return true;
}

void DrawnTouch::halt() noexcept {
    level_.store(0.0, std::memory_order_relaxed);
    if (listener_)
        listener_->hush();
}

void DrawnTouch::stop() noexcept {
    halt();
    stopped_ = true;
    if (listener_)
        listener_->end();
}

} // namespace tp
