// SPDX-License-Identifier: Apache-2.0
#include "core/participant/touch_hand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tp {
namespace {

// All of these are assumed: nobody has measured how hands go about lines that only resist or tick.
constexpr double noticed_friction = 0.5; // level
constexpr double noticed_gap_s =
    0.03; // in friction; two clicks on the skin are two from 10 ms on (Gescheider 1966)
constexpr double edge_mm = 5.0;          // from there it turns round
constexpr double usual_sway_mm = 2.5;    // to either side
constexpr double widest_sway_mm = 8.0;   // a line that is not met within so much is lost
constexpr double usual_sway_hz = 1.2;    // to and fro
constexpr double first_circle_mm = 3.0;
constexpr double widest_round_mm = 40.0;
constexpr double look_back_mm = 6.0;   // along the places felt, for the line's direction
constexpr double apart_mm = 2.0;       // nearer places say nothing of the direction
constexpr std::size_t remembered = 12; // places that are known when met again

Vec2 left_of(Vec2 v) { return {-v.y, v.x}; }

} // namespace

TouchHand::TouchHand(const Person& person, const Rect& area, Vec2 start, bool on_line, double dt_s,
                     std::uint64_t seed)
    : person_(person), area_(area), dt_s_(dt_s), chance_(seed), along_noise_(person.noise_s),
      across_noise_(person.noise_s),
      on_its_way_(static_cast<std::size_t>(std::max(1L, std::lround(person.delay_s / dt_s))),
                  Felt{start, {}}),
      trail_{start}, hand_(start), base_(start), side_(chance_.happens(0.5) ? 1.0 : -1.0),
      mode_(on_line ? Mode::circle : Mode::search), wide_(first_circle_mm) {
    const double angle = chance_.between(0.0, 2.0 * std::numbers::pi);
    heading_ = {std::cos(angle), std::sin(angle)};
}

Vec2 TouchHand::step(Vec2 finger, const BareTouch& touch) {
    const Felt felt = on_its_way_[next_];
    on_its_way_[next_] = {finger, touch};
    next_ = (next_ + 1) % on_its_way_.size();
    feel(felt);
    const Vec2 before = hand_;
    if (mode_ == Mode::search)
        search();
    else if (mode_ == Mode::circle)
        circle();
    else
        sway();
    const double noise = person_.motor_noise * length(hand_ - before);
    const double sideways = across_noise_.next(chance_, dt_s_), forward = along_noise_.next(chance_, dt_s_);
    hand_ += noise * (forward * heading_ + sideways * left_of(heading_));
    hand_ = glm::clamp(hand_, area_.min, area_.max);
    return hand_;
}

/// A tick is a place of the line; of friction it is the middle between where it began and where it ended. A finger that friction
/// stops is let go, moves on, and is stopped again, many times on one ridge: to the hand that is one.
void TouchHand::feel(const Felt& felt) {
    const double up = chance_.normal(), right = chance_.normal();
    const Vec2 error = person_.touch_mm * Vec2(right, up);
    if (felt.touch.ticked) {
        meet_line(felt.place + error);
        return;
    }
    const bool on_ridge = felt.touch.friction >= noticed_friction;
    if (on_ridge && !on_ridge_)
        ridge_from_ = felt.place;
    if (on_ridge) {
        on_ridge_ = true;
        ridge_to_ = felt.place;
        gap_s_ = 0.0;
    } else if (on_ridge_ && (gap_s_ += dt_s_) >= noticed_gap_s) {
        on_ridge_ = false;
        meet_line(0.5 * (ridge_from_ + ridge_to_) + error);
    }
}

void TouchHand::meet_line(Vec2 place) {
    if (mode_ == Mode::search) {
        trail_ = {place};
        begin_circle();
        return;
    }
    const bool circled = mode_ == Mode::circle;
    if (circled && (length(place - trail_.back()) < apart_mm || (times_lost_ > 0 && known(place))))
        return;
    Vec2 from = trail_.back();
    for (std::size_t back = trail_.size(); !circled && back-- > 0 && length(place - from) < look_back_mm;)
        from = trail_[back];
    const Vec2 way = place - from;
    if (length(way) >= apart_mm && (circled || glm::dot(way, heading_) > 0.0))
        heading_ = way / length(way);
    trail_.push_back(place);
    base_ = place + glm::dot(hand_ - place, heading_) * heading_;
    if (circled)
        phase_ = 0.0;
    mode_ = Mode::sway;
    wide_ = usual_sway_mm;
    unmet_rad_ = 0.0;
}

/// Straight on; another way where the surface ends.
void TouchHand::search() {
    if (!area_.contains(hand_ + edge_mm * heading_)) {
        const Vec2 inwards = area_.centre() - hand_;
        const double angle = std::atan2(inwards.y, inwards.x) + chance_.between(-0.7, 0.7);
        heading_ = {std::cos(angle), std::sin(angle)};
    }
    hand_ += dt_s_ * person_.search_speed_mm_s * heading_;
}

/// Across the line and on. While it is not met where it should be, the hand stays and sways wider.
void TouchHand::sway() {
    const double turns_s =
        std::min(usual_sway_hz, person_.search_speed_mm_s / (2.0 * std::numbers::pi * wide_));
    const double turn = 2.0 * std::numbers::pi * turns_s * dt_s_;
    phase_ += turn;
    unmet_rad_ += turn;
    if (unmet_rad_ > 2.0 * std::numbers::pi + 2.0 * std::numbers::pi * person_.delay_s * turns_s)
        wide_ += 4.0 * usual_sway_mm * turns_s * dt_s_;
    else // a half sway goes on by as much as it is wide
        base_ += std::min(person_.follow_speed_mm_s, 4.0 * usual_sway_mm * turns_s) * dt_s_ * heading_;
    if (wide_ > widest_sway_mm) {
        ++times_lost_;
        begin_circle();
        return;
    }
    go_towards(base_ + side_ * wide_ * std::sin(phase_) * left_of(heading_), 1.5 * person_.search_speed_mm_s);
}

void TouchHand::begin_circle() {
    mode_ = Mode::circle;
    side_ = -side_;
    base_ = trail_.back();
    wide_ = first_circle_mm;
    phase_ = 0.0;
}

/// Round the last place of the line, wider with each round.
void TouchHand::circle() {
    const double turns_s =
        std::min(0.5 * usual_sway_hz, person_.search_speed_mm_s / (2.0 * std::numbers::pi * wide_));
    phase_ += 2.0 * std::numbers::pi * turns_s * dt_s_;
    wide_ = std::min(widest_round_mm, wide_ + 0.5 * first_circle_mm * turns_s * dt_s_);
    go_towards(base_ + wide_ * (std::cos(phase_) * heading_ + side_ * std::sin(phase_) * left_of(heading_)),
               1.5 * person_.search_speed_mm_s);
}

/// A place on which the hand came here.
bool TouchHand::known(Vec2 place) const {
    for (std::size_t back = 1; back < std::min(trail_.size(), remembered); ++back)
        if (length(trail_[trail_.size() - 1 - back] - place) < 0.8 * look_back_mm)
            return true;
    return false;
}

void TouchHand::go_towards(Vec2 place, double speed) {
    const double way = length(place - hand_);
    hand_ += std::min(1.0, speed * dt_s_ / std::max(way, 1e-9)) * (place - hand_);
}

} // namespace tp
