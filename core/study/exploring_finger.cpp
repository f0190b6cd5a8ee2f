// SPDX-License-Identifier: Apache-2.0
#include "core/study/exploring_finger.hpp"

#include <algorithm>
#include <numbers>

namespace tp {

namespace {
constexpr double cell = 2.0; ///< mm, grain of the memory for places already followed

Vec2 turned(Vec2 v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}
} // namespace

ExploringFinger::ExploringFinger(const Rect& area, ExplorerManner manner)
    : area_(area), manner_(manner), columns_(static_cast<std::size_t>(area.width() / cell) + 1),
      rows_(static_cast<std::size_t>(area.height() / cell) + 1), first_visit_(columns_ * rows_, -1.0F),
      hand_(start()) {}

Vec2 ExploringFinger::start() const { return {area_.min.x, area_.max.y - 0.5 * manner_.lane}; }

std::size_t ExploringFinger::cell_of(Vec2 p) const {
    const Vec2 inside = glm::clamp(p, area_.min, area_.max) - area_.min;
    return static_cast<std::size_t>(inside.y / cell) * columns_ + static_cast<std::size_t>(inside.x / cell);
}

bool ExploringFinger::visited(Vec2 p) const { return first_visit_[cell_of(p)] >= 0.0F; }

void ExploringFinger::visit(Vec2 p) {
    const double reach = manner_.visited_radius;
    for (double dy = -reach; dy <= reach; dy += cell)
        for (double dx = -reach; dx <= reach; dx += cell)
            if (float& first = first_visit_[cell_of(p + Vec2(dx, dy))];
                std::hypot(dx, dy) <= reach && first < 0.0F)
                first = static_cast<float>(followed_);
}

Vec2 ExploringFinger::step(Vec2 finger, Vec2 force, double dt) {
    if (following_)
        follow(finger, force, dt);
    else
        search(finger, force, dt);
    return hand_;
}

void ExploringFinger::search(Vec2 finger, Vec2 force, double dt) {
    if (finished_)
        return;
    if (length(force) >= manner_.felt && !visited(finger)) {
        begin_following(finger, force);
        return;
    }
    along_lane_ += manner_.search_speed * dt;
    if (along_lane_ >= area_.width()) {
        along_lane_ = 0.0;
        ++lane_;
    }
    const double y = area_.max.y - (lane_ + 0.5) * manner_.lane;
    if (y < area_.min.y) {
        finished_ = true;
        return;
    }
    const double x = lane_ % 2 == 0 ? area_.min.x + along_lane_ : area_.max.x - along_lane_;
    const Vec2 wanted(x, y);
    const double way = length(wanted - hand_);
    const double reach = 2.0 * manner_.search_speed * dt;
    hand_ += std::min(1.0, reach / std::max(way, 1e-9)) * (wanted - hand_);
    if (way > reach)
        along_lane_ -=
            manner_.search_speed * dt; // the lane waits for a hand that is still on its way back to it
}

void ExploringFinger::begin_following(Vec2 finger, Vec2 force) {
    following_ = true;
    const Vec2 towards = force / length(force);
    heading_ = {-towards.y, towards.x};
    last_finger_ = finger;
    followed_ += 2.0 * manner_.again_after; // what was passed on an earlier line is known from the start
    again_ = 0.0;
    unfelt_ = 0.0;
    clock_ = 0.0;
}

void ExploringFinger::follow(Vec2 finger, Vec2 force, double dt) {
    clock_ += dt;
    const double way_done = length(finger - last_finger_);
    followed_ += way_done;
    last_finger_ = finger;
    visit(finger);
    const bool known = followed_ - first_visit_[cell_of(finger)] > manner_.again_after;
    again_ = known ? again_ + way_done : 0.0;

    const Vec2 across(-heading_.y, heading_.x);
    heading_ = turned(heading_, manner_.turn_gain * glm::dot(force, across) * dt);

    unfelt_ = length(force) >= manner_.felt ? 0.0 : unfelt_ + dt;
    if (again_ > manner_.give_up_again || unfelt_ > manner_.lost_after || !area_.contains(finger)) {
        go_back_to_search(finger);
        return;
    }
    const double sway = manner_.wiggle * std::sin(2.0 * std::numbers::pi * manner_.wiggle_rate * clock_);
    const Vec2 wanted = finger + manner_.lead * heading_ + sway * Vec2(-heading_.y, heading_.x);
    const double way = length(wanted - hand_);
    hand_ += std::min(1.0, manner_.follow_speed * dt / std::max(way, 1e-9)) * (wanted - hand_);
}

void ExploringFinger::go_back_to_search(Vec2 finger) {
    following_ = false;
    hand_ = finger;
}

} // namespace tp
