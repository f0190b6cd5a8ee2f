// SPDX-License-Identifier: Apache-2.0
#include "core/participant/study_hand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tp {
namespace {

constexpr double step_mm = 2.0;  // between remembered places
constexpr double stop_s = 0.08;  // in which it stops
constexpr double gather_s = 0.2; // in which a hand comes to another speed (a slow reach)
constexpr double ease_n =
    0.1; // a pull this strong tells the line's direction half as surely as a very strong one
constexpr double sway_hz = 1.2;       // to and fro
constexpr double first_sway_mm = 2.0; // to either side
constexpr double wider_mm_s = 4.0;    // by which it grows
constexpr double lost_sway_mm = 8.0;  // a line that is not found within so much is lost
constexpr double widest_circle_mm = 40.0;
constexpr double again_mm = 12.0;      // slipping off so near the last time is at a corner
constexpr double on_way_back_mm = 6.0; // along places that were passed the other way
constexpr double smallest_trust = 0.1;
constexpr double most_lean = 1.0;     // rad
constexpr double slip_s = 0.15;       // so long nothing is felt until it may have left the line
constexpr double recent_s = 0.3;      // in which the strongest pull of a moment ago is forgotten
constexpr double left_share = 0.35;   // of the strongest pull ever: what was felt before leaving is stronger
constexpr double on_line_share = 0.5; // of the strongest pull: below that the finger is on the line

Vec2 across(Vec2 v) { return {-v.y, v.x}; }
Vec2 turned(Vec2 v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

} // namespace

StudyHand::StudyHand(const Person& person, const Rect& area, Vec2 start, bool on_line, double dt_s,
                     std::uint64_t seed)
    : person_(person), area_(area), dt_s_(dt_s), chance_(seed), sense_(person, dt_s, seed + 1),
      along_noise_(person.noise_s), across_noise_(person.noise_s),
      mode_(on_line ? Mode::follow : Mode::search), on_line_(on_line),
      places_(static_cast<std::size_t>(std::max(1L, std::lround(person.delay_s / dt_s))),
              {start, {1.0, 0.0}}),
      line_at_(start), hand_(start),
      heading_(turned({1.0, 0.0}, chance_.between(0.0, 2.0 * std::numbers::pi))),
      side_(chance_.happens(0.5) ? 1.0 : -1.0), trust_(person.caution), sway_from_(start) {}

Vec2 StudyHand::step(Vec2 finger, Vec2 force) {
    const Vec2 felt = sense_.feel(force);
    felt_at_ = places_[next_place_].place;
    felt_heading_ = places_[next_place_].heading;
    places_[next_place_] = {finger, heading_};
    strongest_n_ = std::max(strongest_n_, length(felt));
    recent_n_ = std::max(length(felt), recent_n_ * std::exp(-dt_s_ / recent_s));
    next_place_ = (next_place_ + 1) % places_.size();
    if (mode_ == Mode::search)
        search(felt);
    else if (mode_ == Mode::go_back)
        go_back();
    else
        follow(felt);
    const double noise = person_.motor_noise * speed_ * dt_s_;
    const double sideways = across_noise_.next(chance_, dt_s_), forward = along_noise_.next(chance_, dt_s_);
    hand_ += noise * (forward * heading_ + sideways * across(heading_));
    hand_ = glm::clamp(hand_, area_.min, area_.max);
    return hand_;
}

/// Straight on; another way where the surface ends.
void StudyHand::search(Vec2 felt) {
    if (felt != Vec2(0.0)) {
        find(felt);
        return;
    }
    speed_ += dt_s_ / gather_s * (person_.search_speed_mm_s - speed_);
    const Vec2 next = hand_ + 5.0 * heading_;
    if (!area_.contains(next))
        heading_ = turned((area_.centre() - hand_) / std::max(1.0, length(area_.centre() - hand_)),
                          chance_.between(-0.7, 0.7));
    hand_ += dt_s_ * speed_ * heading_;
}

/// The line lies across the pull, and the way that turns the hand less is the way on. The hand was faster than what it felt: it goes
/// back to where that was.
void StudyHand::find(Vec2 felt) {
    const Vec2 along = across(felt) / length(felt);
    const Vec2 on = mode_ == Mode::circle ? felt_at_ - sway_from_ : heading_;
    heading_ = glm::dot(along, on) < 0.0 ? -along : along;
    turn_rate_ = 0.0;
    mode_ = Mode::go_back;
    found_at_ = felt_at_;
}

void StudyHand::go_back() {
    const Vec2 way = found_at_ - hand_;
    const double step = dt_s_ * person_.search_speed_mm_s;
    speed_ = 0.0;
    if (length(way) > step) {
        hand_ += step / length(way) * way;
        return;
    }
    hand_ = found_at_;
    mode_ = Mode::follow;
    unfelt_s_ = 0.0;
    last_felt_ = Vec2(0.0);
    recent_n_ = 0.0;
    on_line_ = false;
}

void StudyHand::turn_across(Vec2 felt) {
    const double strength = length(felt);
    Vec2 along = across(felt) / strength;
    // A pull straight back says nothing of the side: the hand tries the one it would rather.
    if (glm::dot(along, heading_) + 0.2 * side_ * glm::dot(along, across(heading_)) < 0.0)
        along = -along;
    const double lean = std::min(most_lean, person_.lean_rad_n * strength);
    along = std::cos(lean) * along + std::sin(lean) / strength * felt;
    const double then = std::atan2(cross(felt_heading_, along), glm::dot(felt_heading_, along));
    const double since = std::atan2(cross(felt_heading_, heading_), glm::dot(felt_heading_, heading_));
    const double off = std::remainder(then - since, 2.0 * std::numbers::pi);
    const double turn = std::min(1.0, dt_s_ / person_.turn_s) * strength / (strength + ease_n) * off;
    heading_ = turned(heading_, turn);
    turn_rate_ += dt_s_ / 0.3 * (turn / dt_s_ - turn_rate_);
}

/// The two-thirds power law, from the radius that the hand's own turning tells.
double StudyHand::bend_factor() const {
    const double radius = speed_ / std::max(std::abs(turn_rate_), 1e-6);
    return std::cbrt(std::clamp(radius / person_.preferred_radius_mm, 0.05, 1.0));
}

void StudyHand::follow(Vec2 felt) {
    const bool feels = felt != Vec2(0.0);
    unfelt_s_ = feels ? 0.0 : unfelt_s_ + dt_s_;
    if (mode_ == Mode::sway || mode_ == Mode::circle) {
        if (feels && !(mode_ == Mode::circle && known(felt_at_)))
            find(felt);
        else if (mode_ == Mode::sway)
            sway();
        else
            circle();
        return;
    }
    if (feels && length(felt) >= 2.0 * person_.threshold_n) {
        last_felt_ = felt;
        line_at_ = last_felt_at_ = felt_at_;
    }
    if (slipped_off()) {
        lose();
        const bool again = length(last_felt_at_ - slipped_at_) < again_mm;
        slipped_at_ = last_felt_at_;
        if (again) {
            begin(Mode::circle, last_felt_at_);
        } else {
            mode_ = Mode::go_back;
            found_at_ = last_felt_at_;
            const Vec2 towards = heading_ + last_felt_ / length(last_felt_);
            heading_ = length(towards) > 0.1 ? towards / length(towards) : across(heading_);
        }
        last_felt_ = Vec2(0.0);
        trail_.resize(std::min(trail_.size(), trail_sure_)); // what came after was not on the line
        return;
    }
    if (unfelt_s_ > person_.doubt_s) {
        begin(Mode::sway, hand_);
        return;
    }
    double wanted = trust_ * person_.follow_speed_mm_s * bend_factor();
    if (feels) {
        turn_across(felt);
        wanted *= std::clamp(1.0 + glm::dot(felt, heading_) / person_.brake_n, 0.0, 1.0);
    }
    trust_ = std::clamp(trust_ * (1.0 + person_.trust_per_s * dt_s_ * (1.0 - length(felt) / person_.brake_n)),
                        smallest_trust, 1.5);
    speed_ += dt_s_ / (wanted < speed_ ? stop_s : gather_s) * (wanted - speed_);
    hand_ += dt_s_ * (speed_ * heading_ + person_.yield_mm_s_n * felt);
    const bool weak = length(felt) < on_line_share * strongest_n_;
    on_line_ = on_line_ ? weak || !feels : weak && feels;
    if (on_line_) {
        if (feels)
            trail_sure_ = trail_.size();
        remember(felt_at_);
    }
}

/// The pull faded while the hand went against it, or nothing is felt at the surface's edge: on a line it fades as the hand goes with it.
bool StudyHand::slipped_off() const {
    if (unfelt_s_ < slip_s || last_felt_ == Vec2(0.0))
        return false;
    if (recent_n_ * std::exp(unfelt_s_ / recent_s) > left_share * strongest_n_)
        return true;
    const Vec2 off = glm::abs(hand_ - area_.centre());
    const bool at_edge = off.x >= 0.5 * area_.width() || off.y >= 0.5 * area_.height();
    return at_edge;
}

void StudyHand::lose() {
    ++times_lost_;
    trust_ = std::max(smallest_trust, trust_ * person_.caution);
}

void StudyHand::begin(Mode mode, Vec2 from) {
    mode_ = mode;
    sway_from_ = from;
    swayed_s_ = 0.0;
    swayed_turns_ = 0.0;
    speed_ = 0.0;
}

void StudyHand::go_towards(Vec2 place, double speed) {
    const double way = length(place - hand_);
    hand_ += std::min(1.0, speed * dt_s_ / std::max(way, 1e-9)) * (place - hand_);
}

/// To and fro across the heading, wider and wider, no faster than in a search. Once that is wide the line is lost, and the hand goes
/// round where it had it.
void StudyHand::sway() {
    swayed_s_ += dt_s_;
    const double wide = first_sway_mm + wider_mm_s * swayed_s_;
    if (wide > lost_sway_mm) {
        lose();
        begin(Mode::circle, line_at_);
        return;
    }
    swayed_turns_ += dt_s_ * std::min(sway_hz, person_.search_speed_mm_s / (2.0 * std::numbers::pi * wide));
    const double phase = 2.0 * std::numbers::pi * swayed_turns_;
    go_towards(sway_from_ + side_ * wide * std::sin(phase) * across(heading_) +
                   0.3 * wide * (1.0 - std::cos(phase)) * heading_,
               1.5 * person_.search_speed_mm_s);
}

/// Round the place in wider and wider circles, past where the line is known already; at last it searches.
void StudyHand::circle() {
    swayed_s_ += dt_s_;
    const double wide = first_sway_mm + wider_mm_s * swayed_s_;
    if (wide > widest_circle_mm) {
        mode_ = Mode::search;
        return;
    }
    swayed_turns_ += dt_s_ * std::min(sway_hz, person_.search_speed_mm_s / (2.0 * std::numbers::pi * wide));
    const double phase = 2.0 * std::numbers::pi * swayed_turns_;
    go_towards(sway_from_ + wide * (std::cos(phase) * heading_ + side_ * std::sin(phase) * across(heading_)),
               1.5 * person_.search_speed_mm_s);
}

/// A place of the line on which it came.
bool StudyHand::known(Vec2 place) const {
    const std::size_t count = trail_.size();
    for (std::size_t back = 1; back < 40 && back < count; ++back)
        if (length(trail_[count - 1 - back].place - place) < 0.8 * person_.place_mm)
            return true;
    return false;
}

void StudyHand::remember(Vec2 finger) {
    if (!trail_.empty() && length(finger - trail_.back().place) < step_mm)
        return;
    trail_.push_back({finger, heading_});
    const std::size_t count = trail_.size();
    bool passed = false;
    for (std::size_t back = 4; back < 40 && back < count && !passed; ++back) {
        const FeltPlace& old = trail_[count - 1 - back];
        passed =
            length(old.place - finger) < 0.8 * person_.place_mm && glm::dot(old.heading, heading_) < -0.8;
    }
    way_back_mm_ = passed ? way_back_mm_ + step_mm : 0.0;
    if (way_back_mm_ >
        on_way_back_mm) { // the way it came: it turns round, and at the corner tries the other side
        heading_ = -heading_;
        side_ = -side_;
        way_back_mm_ = 0.0;
        trail_.resize(count - std::min<std::size_t>(count, 6));
    }
}

} // namespace tp
