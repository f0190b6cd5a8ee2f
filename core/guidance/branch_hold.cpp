// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/branch_hold.hpp"

namespace tp {

Nearest BranchHold::nearest_of_segment(Vec2 finger, std::uint32_t segment) const noexcept {
    const Polyline& line = scene_->lines[static_cast<std::size_t>(contour_)];
    Nearest nearest;
    const IndexedSegment piece(line.segment_start(segment), line.segment_end(segment));
    const Foot<double> foot(piece, finger);
    const WayToSegment<double> way(piece, foot.parameter, finger);
    nearest.distance = way.length();
    nearest.point = point_on(piece, foot.parameter);
    nearest.towards = way.vector();
    nearest.contour = contour_;
    nearest.segment = segment;
    return nearest;
}

Nearest BranchHold::downhill(Vec2 finger) const noexcept {
    const Polyline& line = scene_->lines[static_cast<std::size_t>(contour_)];
    const auto count = static_cast<std::int64_t>(line.segment_count());
    Nearest best = nearest_of_segment(finger, segment_);
    int looked_at = 1;
    for (bool better = true; better && looked_at < most_segments;) {
        better = false;
        const auto from = static_cast<std::int64_t>(best.segment);
        for (const std::int64_t direction : {1, -1}) {
            double way = 0.0;
            for (std::int64_t step = 1; step < count && way < look_ahead_mm; ++step) {
                std::int64_t at = from + direction * step;
                if (line.closed)
                    at = (at + count) % count;
                if (at < 0 || at >= count || ++looked_at > most_segments)
                    break;
                const auto segment = static_cast<std::uint32_t>(at);
                const Nearest here = nearest_of_segment(finger, segment);
                better = better || here.distance < best.distance;
                if (here.distance < best.distance)
                    best = here;
                way += length(line.segment_end(segment) - line.segment_start(segment));
            }
        }
    }
    return best;
}

Guidance BranchHold::moved_over(const Guidance& exact, const Nearest& held) const noexcept {
    const Nearest nearest{exact.distance, exact.nearest, exact.contour, exact.segment, exact.towards};
    const Guidance from = pull_towards(nearest, profile_);
    Guidance to = pull_towards(held, profile_);
    to.force += exact.force - from.force;
    to.energy += exact.energy - from.energy;
    return to;
}

Guidance BranchHold::hold(Vec2 finger, const Guidance& exact) noexcept {
    const bool pulled = exact.contour >= 0 && exact.distance < profile_.band();
    if (!pulled) {
        contour_ = -1;
        return exact;
    }
    if (contour_ >= 0) {
        const Nearest held = downhill(finger);
        if (held.distance <= exact.distance + margin_) {
            segment_ = held.segment;
            return moved_over(exact, held);
        }
        ++switches_;
    }
    contour_ = exact.contour;
    segment_ = exact.segment;
    return exact;
}

} // namespace tp
