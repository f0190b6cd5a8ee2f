// SPDX-License-Identifier: Apache-2.0
#include "core/friction/friction_finger.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

/// What the distances of an index and the length of a step may be wrong by: their rounding, many times over.
constexpr double slack_share = 1e-9;
constexpr double slack_mm = 1e-9;
/// Farther from each line a finger that follows none has nothing to be told.
constexpr double heed_mm = std::max(FrictionFinger::along_mm, FrictionLaw::corner_mm);

/// A third of the time of `length`. Beyond 1e154 it is infinite, and below 1e-154 zero: a step so small is looked at anyway
/// where a line is near (slack_mm).
double quick_length(Vec2 v) { return std::sqrt(glm::dot(v, v)); }

double angle_between(Vec2 way, Vec2 line) {
    return std::atan2(std::abs(cross(way, line)), std::abs(glm::dot(way, line)));
}

} // namespace

void FrictionFinger::lift() noexcept {
    down_ = following_ = at_corner_ = false;
    lately_count_ = 0;
    near_ = {};
}

Friction FrictionFinger::step(Vec2 place, Vec2 velocity, const Guidance& exact) noexcept {
    told_ = 0;
    crossings_.clear();
    if (!is_finite(place)) {
        lift();
        return {};
    }
    forget_left(place);
    if (!down_) {
        down_ = true;
        in_texture_ = law_->in_texture(place);
    } else if (may_cross(place, exact.distance) || exact.distance <= heed_mm || following_ || at_corner_) {
        const double speed = quick_length(velocity);
        const Movement now{place, quick_length(place - before_.place), speed, law_->share_at(speed)};
        if (may_cross(place, exact.distance))
            cross_lines(now);
        follow(now, exact);
        look_for_corner(now, exact);
    } else {
        near_ = {};
    }
    before_ = {place, exact.distance, exact.nearest, exact.contour, exact.segment};
    double level = law_->moving_level(place, exact.distance, in_texture_);
    if (level > 0.0)
        level *= law_->share_at(quick_length(velocity));
    return {level, {events_.data(), told_}, crossings_.left_out()};
}

/// No place of the step is nearer to a line than the distances at its ends allow: most steps cross nothing, and are not
/// looked at.
bool FrictionFinger::may_cross(Vec2 place, double distance) const noexcept {
    const Vec2 way = place - before_.place;
    const double clear = (1.0 - slack_share) * (before_.distance + distance) - slack_mm;
    return !(clear > 0.0 && glm::dot(way, way) < clear * clear);
}

void FrictionFinger::cross_lines(const Movement& now) noexcept {
    law_->lines().find(before_.place, now.place, crossings_);
    for (const LineCrossing& crossing : crossings_.list()) {
        in_texture_ ^= law_->bounds_texture(crossing.contour);
        if (told_already(crossing, now.share))
            continue;
        tell({LineEventKind::crossed, crossing.contour, crossing.segment, crossing.place, now.speed,
              angle_between(now.place - before_.place, crossing.along), crossing.to_left, now.share});
    }
    if (crossings_.left_out() > 0)
        in_texture_ = law_->in_texture(now.place);
}

/// A finger that rests on a line trembles, and would cross it many times a second. Notes a crossing that is felt.
bool FrictionFinger::told_already(const LineCrossing& crossing, double share) noexcept {
    if (law_->again_mm() <= 0.0)
        return false;
    for (std::size_t i = 0; i < lately_count_; ++i)
        if (lately_[i].contour == crossing.contour)
            return true;
    if (share > 0.0 && lately_count_ < lately_.size())
        lately_[lately_count_++] = {crossing.contour, crossing.place};
    return false;
}

void FrictionFinger::forget_left(Vec2 place) noexcept {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < lately_count_; ++i)
        if (quick_length(place - lately_[i].place) <= law_->again_mm())
            lately_[kept++] = lately_[i];
    lately_count_ = kept;
}

/// A finger follows a line where the place nearest to it goes along as the finger does; one that crosses leaves that place
/// where it is. Older way counts less and less.
void FrictionFinger::follow(const Movement& now, const Guidance& exact) noexcept {
    const bool same = exact.contour == before_.contour;
    if (following_ && (!same || exact.distance > away_mm)) {
        tell({LineEventKind::left, before_.contour, before_.segment, now.place, now.speed, 0.0, false,
              now.share});
        following_ = false;
    }
    if (!same || exact.distance > along_mm) {
        near_ = {};
        return;
    }
    const double kept = std::max(0.0, 1.0 - now.way * (1.0 / along_way_mm));
    near_.all += now.way;
    near_.lately = kept * near_.lately + now.way;
    near_.along = kept * near_.along + std::min(now.way, quick_length(exact.nearest - before_.nearest));
    if (following_ || near_.all < along_way_mm || near_.along < along_share * near_.lately)
        return;
    following_ = true;
    tell(
        {LineEventKind::followed, exact.contour, exact.segment, now.place, now.speed, 0.0, false, now.share});
}

/// Once; again when the finger has been away from it.
void FrictionFinger::look_for_corner(const Movement& now, const Guidance& exact) noexcept {
    if (at_corner_ && quick_length(now.place - corner_) > 2.0 * FrictionLaw::corner_mm)
        at_corner_ = false;
    if (exact.distance > FrictionLaw::corner_mm || now.place == before_.place)
        return;
    const Nearest corner = law_->corners().nearest_within(now.place, FrictionLaw::corner_mm);
    if (!corner.found() || (at_corner_ && corner.point == corner_))
        return;
    at_corner_ = true;
    corner_ = corner.point;
    tell({LineEventKind::corner, exact.contour, exact.segment, corner.point, now.speed, 0.0, false,
          now.share});
}

} // namespace tp
