// SPDX-License-Identifier: Apache-2.0
#include "faces/covered_mouth.hpp"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double smallest_told_px = 30.0; ///< eyes apart; below, nothing about a face is clear
constexpr double clear_eyes = 0.25;       ///< mean clarity of the lids; sharp portraits have 0.45 and more
/// Outline points that are looked at: jaw, chin, jaw. Mirror images of each other, so that guesses are, too.
constexpr std::array<std::size_t, 3> jaw_and_chin{8, 16, 24};
constexpr std::size_t points_of_a_lip = 20; ///< of each lip

#include "faces/covered_mouth_weights.inc"

/// The frame of lip_guides.
struct BetweenEyes {
    Vec2 origin, across;
    double unit;

    explicit BetweenEyes(const Landmarks& points)
        : origin(0.5 * (points.right_eye[0] + points.left_eye[0])),
          across(points.left_eye[0] - points.right_eye[0]), unit(glm::dot(across, across)) {}
    Vec2 into(Vec2 p) const {
        const Vec2 d = p - origin;
        return Vec2(glm::dot(d, across), across.x * d.y - across.y * d.x) / unit;
    }
    Vec2 back(Vec2 p) const { return origin + p.x * across + p.y * Vec2(-across.y, across.x); }
};

} // namespace

std::array<double, cover_sign_count> cover_signs(const QualitySigns& signs) {
    const auto of_lips = [](const std::array<double, feature_count>& percent) {
        return std::log(0.3 + std::max(0.0, 0.5 * (percent[at_outer_lip] + percent[at_inner_lip])));
    };
    const auto least = [](const EdgeReports::Pair& pair, double most) {
        return std::clamp(std::min(pair.lower.clarity, pair.upper.clarity), -0.5, most);
    };
    return {1.0, of_lips(signs.between_mirrors), of_lips(signs.between_nets),
            least(signs.edges.inner_lip, 1.0), least(signs.edges.outer_lip, 1.0)};
}

bool can_tell_cover(const QualitySigns& signs) {
    double eyes = 0.0;
    for (const EdgeReports::Pair* pair : {&signs.edges.right_eye, &signs.edges.left_eye})
        eyes += 0.25 * (pair->lower.clarity + pair->upper.clarity);
    return signs.between_mirrors[at_outer_lip] > 0.0 && signs.unit_px >= smallest_told_px &&
           eyes > clear_eyes;
}

bool is_mouth_covered(const QualitySigns& signs) {
    if (!can_tell_cover(signs))
        return false;
    const auto sign = cover_signs(signs);
    double evidence = 0.0;
    for (std::size_t i = 0; i < cover_sign_count; ++i)
        evidence += cover_weights[i] * sign[i];
    return evidence > 0.0;
}

std::array<double, lip_guide_count> lip_guides(const Landmarks& points) {
    const BetweenEyes frame(points);
    std::array<double, lip_guide_count> guides{1.0};
    for (std::size_t i = 0; i < jaw_and_chin.size(); ++i) {
        const Vec2 p = frame.into(points.outline[jaw_and_chin[i]]);
        guides[1 + 2 * i] = p.x;
        guides[2 + 2 * i] = p.y;
    }
    return guides;
}

Landmarks with_guessed_lips(Landmarks points) {
    const BetweenEyes frame(points);
    if (!(frame.unit > 0.0))
        return points;
    auto guides = lip_guides(points);
    for (std::size_t g = 0; g < lip_guide_count; ++g) // an outline unlike all counts as the most unlike one
        guides[g] = std::clamp(guides[g], lip_guide_range[g][0], lip_guide_range[g][1]);
    for (std::size_t i = 0; i < 2 * points_of_a_lip; ++i) {
        Vec2 place(0.0);
        for (std::size_t g = 0; g < lip_guide_count; ++g)
            place += guides[g] * Vec2(lip_weights[2 * i][g], lip_weights[2 * i + 1][g]);
        (i < points_of_a_lip ? points.outer_lip[i] : points.inner_lip[i - points_of_a_lip]) =
            frame.back(place);
    }
    return points;
}

} // namespace tp
