// SPDX-License-Identifier: Apache-2.0
#include "scene_check.hpp"

#include "brute_force.hpp"
#include "core/guidance/branch_hold.hpp"
#include "core/guidance/corner_cue.hpp"
#include "core/guidance/haptic_scene.hpp"
#include "core/guidance/spacing.hpp"
#include "core/svg/contour_sheet.hpp"

#include <functional>

namespace tp::test {

namespace {

/// What is worth looking at in a moment; beyond, only what takes no longer with more.
constexpr std::size_t most_pieces = 32;
constexpr std::size_t most_felt = 2000; ///< segments
constexpr std::size_t most_paired = 300;

std::size_t segments_of(const FlatScene& flat) {
    std::size_t count = 0;
    for (const Polyline& line : flat.lines)
        count += line.segment_count();
    return count;
}

/// On the lines, beside them, between them and far away.
std::vector<Vec2> fingers_for(const FlatScene& flat) {
    std::vector<Vec2> fingers{{0, 0}, {1e9, -1e9}};
    Vec2 last(0.0);
    for (const Polyline& line : flat.lines) {
        if (line.points.empty() || fingers.size() > 24)
            continue;
        const Vec2 here = line.points[line.points.size() / 2];
        for (const Vec2 finger : {here, here + Vec2(0.3, -0.7), 0.5 * here + 0.5 * last, here + Vec2(5, 5)})
            fingers.push_back(finger);
        last = here;
    }
    return fingers;
}

double largest_coordinate(const FlatScene& flat) {
    double largest = 1.0;
    for (const Polyline& line : flat.lines)
        for (const Vec2 p : line.points)
            largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    return largest;
}

std::string wrong_index(const FlatScene& flat, const std::vector<Vec2>& fingers) {
    const ContourIndex index(flat);
    std::mt19937 random(1);
    const FlatScene other = testing::shuffled(flat, random);
    const ContourIndex other_index(other);
    const double largest = largest_coordinate(flat);
    for (const Vec2 finger : fingers) {
        const Nearest nearest = index.nearest(finger);
        const Nearest shuffled = other_index.nearest(finger);
        if (nearest.distance != shuffled.distance || nearest.point != shuffled.point)
            return "the order of the contours changes the answer";
        const long double truth = testing::true_distance(flat, finger);
        const double coarse = largest > 1e100 ? 1e-13 * largest : 4e-16 * largest;
        if (!(std::abs(nearest.distance - truth) <= 1e-9L + 4e-16L * truth + coarse))
            return "the index is off by " +
                   std::to_string(static_cast<double>(std::abs(nearest.distance - truth))) + " mm";
        const Nearest within = index.nearest_within(finger, 3.0);
        if (within.found() != (nearest.distance <= 3.0))
            return "the bounded question has another answer";
    }
    return {};
}

/// One law a text, so that a search gets round quickly.
std::string wrong_force(const Scene& scene, const std::vector<Vec2>& fingers, std::size_t which) {
    const TentProfile profile;
    const std::pair<LawKind, Continuity> choices[] = {{LawKind::exact, {}},
                                                      {LawKind::exact, {0.0, 0.4, false}},
                                                      {LawKind::exact, {0.4, 0.0, true}},
                                                      {LawKind::published, {}}};
    const auto& [kind, continuity] = choices[which % std::size(choices)];
    const auto made = make_haptic_scene(scene, profile, kind, continuity);
    if (!made)
        return made.error().ends_with('.') ? "" : "no sentence: " + made.error();
    BranchHold hold((*made)->flat, profile, continuity.hold_mm);
    const double most = profile.peak() * (continuity.corner_cue ? 1.0 + CornerCueLaw::share_of_peak : 1.0);
    for (const Vec2 finger : fingers) {
        Guidance guidance = (*made)->law->at(finger);
        if (continuity.hold_mm > 0.0)
            guidance = hold.hold(finger, guidance);
        if (!is_finite(guidance.force) || length(guidance.force) > most * (1.0 + 1e-9))
            return "a force is out of bounds";
        if (kind == LawKind::exact && !std::isfinite(guidance.energy))
            return "an energy is not finite";
    }
    return {};
}

std::string wrong_geometry(const Scene& scene, const FlatScene& flat) {
    for (const Vec2 corner : corners_of(flat))
        if (!is_finite(corner))
            return "a corner is not finite";
    for (const Contour& contour : scene.contours)
        if (const auto thin = thinned(contour))
            for (const Piece& piece : thin->pieces)
                if (!is_finite(piece))
                    return "a thinned contour is not finite";
    if (segments_of(flat) > most_paired)
        return {};
    for (const Closeness& pair : closeness(flat, TentProfile{}))
        if (!(pair.gap >= 0.0) || !(pair.peak >= 0.0) || !is_finite(pair.where))
            return "a gap is no number";
    return {};
}

} // namespace

std::string complaint_about_scene(std::string_view svg) {
    const Result<ContourSheet> sheet = sheet_from_svg(svg);
    if (!sheet)
        return {};
    const Scene scene = scene_from_sheet(*sheet);
    std::size_t pieces = 0;
    for (const Contour& contour : scene.contours)
        pieces += contour.pieces.size();
    if (pieces == 0 || pieces > most_pieces)
        return {};
    const FlatScene flat = flatten(scene);
    for (const Polyline& line : flat.lines)
        for (const Vec2 p : line.points)
            if (!is_finite(p))
                return "a flattened point is not finite";
    std::string complaint = wrong_geometry(scene, flat);
    const std::size_t segments = segments_of(flat);
    if (!complaint.empty() || segments == 0 || segments > most_felt)
        return complaint;
    const std::vector<Vec2> fingers = fingers_for(flat);
    complaint = wrong_index(flat, fingers);
    return complaint.empty() ? wrong_force(scene, fingers, std::hash<std::string_view>{}(svg)) : complaint;
}

} // namespace tp::test
