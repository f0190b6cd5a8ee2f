// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/scene.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace tp::testing {

inline Polyline ellipse(Vec2 centre, double radius_x, double radius_y, int count) {
    Polyline line{{}, true};
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        line.points.emplace_back(centre.x + radius_x * std::cos(angle),
                                 centre.y + radius_y * std::sin(angle));
    }
    return line;
}

/// The face scene of DESIGN.md §4: eyes 28×10 mm, lips 44×16 and 36×2 mm, an outline arc 130×170 mm.
inline FlatScene face_scene(int points_per_line = 200) {
    FlatScene scene;
    scene.names = {"right_eye", "left_eye", "outer_lip", "inner_lip", "outline"};
    scene.lines = {ellipse({-32, 30}, 14, 5, points_per_line), ellipse({32, 30}, 14, 5, points_per_line),
                   ellipse({0, -45}, 22, 8, points_per_line), ellipse({0, -45}, 18, 1, points_per_line)};
    Polyline arc{{}, false};
    for (int i = 0; i <= points_per_line; ++i) {
        const double angle = std::numbers::pi * (1.0 + 1.0 * i / points_per_line);
        arc.points.emplace_back(65.0 * std::cos(angle), 30.0 + 115.0 * std::sin(angle));
    }
    scene.lines.push_back(arc);
    return scene;
}

/// A few random lines, open and closed, in ±`extent` mm; now and then with points that coincide.
inline FlatScene random_scene(std::mt19937& random, double extent = 50.0) {
    std::uniform_real_distribution<double> place(-extent, extent);
    std::uniform_int_distribution<int> count(1, 12);
    FlatScene scene;
    const int lines = 1 + count(random) / 3;
    for (int c = 0; c < lines; ++c) {
        Polyline line{{}, (c % 2) == 0};
        const int points = count(random);
        for (int i = 0; i < points; ++i) {
            line.points.push_back({place(random), place(random)});
            if (i % 5 == 4)
                line.points.push_back(line.points.back());
        }
        scene.names.push_back("line " + std::to_string(c));
        scene.lines.push_back(line);
    }
    return scene;
}

inline Vec2 random_point(std::mt19937& random, double extent = 60.0) {
    std::uniform_real_distribution<double> place(-extent, extent);
    const double x = place(random);
    return {x, place(random)};
}

/// `count` segments as small closed curves all over ±`extent` mm.
inline FlatScene many_curves(int count, double extent) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> radius(0.2, 1.0);
    FlatScene scene;
    const int curves = count / 200;
    const double typical = extent / std::sqrt(double(curves));
    for (int k = 0; k < curves; ++k) {
        scene.names.push_back("curve " + std::to_string(k));
        const Vec2 centre = random_point(random, 0.95 * extent);
        const double wide = typical * radius(random), high = typical * radius(random);
        scene.lines.push_back(ellipse(centre, wide, high, 200));
    }
    return scene;
}

} // namespace tp::testing
