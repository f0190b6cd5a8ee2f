// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/bench_scene.hpp"

#include <algorithm>
#include <numbers>
#include <random>

namespace tp {

namespace {

constexpr std::size_t largest_face = 2000; ///< segments
constexpr std::size_t curve_segments = 200;

Polyline ellipse(Vec2 centre, Vec2 radii, std::size_t count) {
    Polyline line{{}, true};
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        line.points.push_back(centre + radii * Vec2(std::cos(angle), std::sin(angle)));
    }
    return line;
}

FlatScene face(std::size_t segments) {
    const std::size_t eye = segments * 3 / 20;
    const std::size_t lip = segments / 5;
    FlatScene scene;
    scene.names = {"right_eye", "left_eye", "outer_lip", "inner_lip", "outline"};
    scene.lines = {ellipse({-32, 30}, {14, 5}, eye), ellipse({32, 30}, {14, 5}, eye),
                   ellipse({0, -45}, {22, 8}, lip), ellipse({0, -45}, {18, 1}, lip),
                   ellipse({0, 0}, {65, 85}, segments - 2 * eye - 2 * lip)};
    return scene;
}

/// Wobbly rings; the more there are, the smaller.
FlatScene map(std::size_t segments) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const std::size_t curves = std::max<std::size_t>(1, segments / curve_segments);
    FlatScene scene;
    for (std::size_t k = 0; k < curves; ++k) {
        const std::size_t count = segments / curves + (k < segments % curves ? 1 : 0);
        const double radius = (0.3 + 0.7 * unit(random)) * 70.0 / std::sqrt(static_cast<double>(curves));
        const double room = bench_half_side_mm - radius;
        const double x = room * (2.0 * unit(random) - 1.0);
        const double y = room * (2.0 * unit(random) - 1.0);
        const double wobble = 0.3 * unit(random);
        const double phase = 2.0 * std::numbers::pi * unit(random);
        const double waves = 2.0 + std::floor(4.0 * unit(random));
        Polyline line{{}, true};
        for (std::size_t i = 0; i < count; ++i) {
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
            const double r = radius * (1.0 + wobble * std::cos(waves * angle + phase)) / 1.3;
            line.points.push_back(Vec2(x, y) + r * Vec2(std::cos(angle), std::sin(angle)));
        }
        scene.names.push_back("curve " + std::to_string(k));
        scene.lines.push_back(std::move(line));
    }
    return scene;
}

} // namespace

BenchScene bench_scene(std::size_t segments) {
    if (segments <= largest_face)
        return {"face", segments, face(segments)};
    return {"map", segments, map(segments)};
}

std::vector<Vec2> random_places(std::size_t count) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> along(-bench_half_side_mm, bench_half_side_mm);
    std::vector<Vec2> places;
    places.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = along(random);
        places.emplace_back(x, along(random));
    }
    return places;
}

} // namespace tp
