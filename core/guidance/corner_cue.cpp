// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/corner_cue.hpp"

#include <algorithm>
#include <numbers>
#include <set>

namespace tp {

namespace {

/// The arc length at each vertex of a line, and at the end of its last segment.
std::vector<double> arcs_of(const Polyline& line) {
    std::vector<double> arcs{0.0};
    for (std::size_t i = 0; i < line.segment_count(); ++i)
        arcs.push_back(arcs.back() + length(line.segment_end(i) - line.segment_start(i)));
    return arcs;
}

/// The point `arc` along the line, by the arcs of its vertices; a closed line wraps round.
Vec2 point_at(const Polyline& line, const std::vector<double>& arcs, double arc) {
    const double total = arcs.back();
    arc = line.closed ? arc - total * std::floor(arc / total) : std::clamp(arc, 0.0, total);
    const auto after = std::upper_bound(arcs.begin() + 1, arcs.end() - 1, arc);
    const auto segment = static_cast<std::size_t>(after - arcs.begin()) - 1;
    const Vec2 a = line.segment_start(segment);
    const Vec2 b = line.segment_end(segment);
    const double way = arcs[segment + 1] - arcs[segment];
    return way > 0.0 ? a + std::clamp((arc - arcs[segment]) / way, 0.0, 1.0) * (b - a) : a;
}

struct Turn {
    double angle; ///< rad
    double arc;   ///< mm
    Vec2 place;   ///< mm
};

std::vector<Turn> sharp_turns(const Polyline& line, const std::vector<double>& arcs, double least,
                              double window) {
    std::vector<Turn> turns;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const double arc = arcs[i];
        const bool at_an_end = !line.closed && (arc < 0.5 * window || arc > arcs.back() - 0.5 * window);
        if (at_an_end)
            continue;
        const Vec2 here = line.points[i];
        const Vec2 in = here - point_at(line, arcs, arc - window);
        const Vec2 out = point_at(line, arcs, arc + window) - here;
        const double angle = std::abs(std::atan2(cross(in, out), glm::dot(in, out)));
        if (angle > least)
            turns.push_back({angle, arc, here});
    }
    return turns;
}

/// Whether `arc` lies within `apart` of one of those taken, round the end of a line of length `round` too.
bool taken_near(const std::set<double>& taken, double arc, double apart, double round) {
    for (const double shift : {-round, 0.0, round}) {
        const auto next = taken.lower_bound(arc + shift - apart);
        if (next != taken.end() && *next <= arc + shift + apart)
            return true;
    }
    return false;
}

} // namespace

std::vector<Vec2> corners_of(const FlatScene& scene, double turn_degrees, double window_mm) {
    std::vector<Vec2> corners;
    for (const Polyline& line : scene.lines) {
        if (!std::all_of(line.points.begin(), line.points.end(), [](Vec2 p) { return is_finite(p); }))
            continue;
        const std::vector<double> arcs = arcs_of(line);
        if (!(arcs.back() > 4.0 * window_mm) || !std::isfinite(arcs.back()))
            continue; // too small for a finger to feel a corner in
        std::vector<Turn> turns = sharp_turns(line, arcs, turn_degrees * std::numbers::pi / 180.0, window_mm);
        std::stable_sort(turns.begin(), turns.end(),
                         [](const Turn& a, const Turn& b) { return a.angle > b.angle; });
        std::set<double> taken;
        for (const Turn& turn : turns)
            if (!taken_near(taken, turn.arc, 2.0 * window_mm, line.closed ? arcs.back() : 0.0)) {
                taken.insert(turn.arc);
                corners.push_back(turn.place);
            }
    }
    return corners;
}

namespace {

FlatScene points_as_scene(const std::vector<Vec2>& points) {
    FlatScene scene;
    for (const Vec2 p : points) {
        scene.names.emplace_back("corner");
        scene.lines.push_back({{p}, false});
    }
    return scene;
}

} // namespace

CornerCueLaw::CornerCueLaw(std::unique_ptr<const GuidanceLaw> law, const FlatScene& scene,
                           TentProfile profile)
    : law_(std::move(law)), reach_(0.5 * profile.range),
      // The well is steepest at ρ = R/√3, where its slope is 8E/(3√3·R).
      depth_(share_of_peak * profile.peak() * reach_ * 3.0 * std::numbers::sqrt3 / 8.0),
      corners_(points_as_scene(corners_of(scene)), reach_) {}

Guidance CornerCueLaw::at(Vec2 finger) const noexcept { return with_well(law_->at(finger), finger); }

Guidance CornerCueLaw::felt_at(Vec2 finger) const noexcept {
    return with_well(law_->felt_at(finger), finger);
}

Guidance CornerCueLaw::with_well(Guidance guidance, Vec2 finger) const noexcept {
    const Nearest corner = corners_.nearest_within(finger, reach_);
    if (!corner.found())
        return guidance;
    const double share = corner.distance / reach_;
    const double left = 1.0 - share * share;
    guidance.force += (4.0 * depth_ * left / (reach_ * reach_)) * (corner.point - finger);
    guidance.energy -= depth_ * left * left;
    return guidance;
}

} // namespace tp
