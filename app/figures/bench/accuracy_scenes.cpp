// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/accuracy_scenes.hpp"

#include "app/figures/bench/bench_scene.hpp"
#include "app/figures/report/test_scenes.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace tp {

namespace {

constexpr double side_mm = 2.0 * bench_half_side_mm;
constexpr int map_rings = 275;
constexpr double turn = 2.0 * std::numbers::pi;

/// Cubics through `count` places of a curve given over [0, 1], tangents by central differences (Hermite).
Contour smooth(std::string name, const std::function<Vec2(double)>& curve, int count, bool closed) {
    const double step = 1.0 / count;
    const auto tangent = [&](double t) { return (curve(t + 1e-6) - curve(t - 1e-6)) / 2e-6; };
    Contour contour{std::move(name), {}, closed};
    for (int i = 0; i < count; ++i) {
        const double t = i * step;
        const Vec2 a = curve(t);
        const Vec2 b = closed && i == count - 1 ? curve(0.0) : curve(t + step);
        contour.pieces.push_back(
            Cubic{a, a + (step / 3.0) * tangent(t), b - (step / 3.0) * tangent(t + step), b});
    }
    return contour;
}

Scene map() {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Scene scene{side_mm, side_mm, {}};
    for (int k = 0; k < map_rings; ++k) {
        const double radius = 0.8 + 2.8 * unit(random);
        const double room = bench_half_side_mm - 1.3 * radius;
        const double x = room * (2.0 * unit(random) - 1.0);
        const double y = room * (2.0 * unit(random) - 1.0);
        const double wobble = 0.25 * unit(random);
        const double waves = 2.0 + std::floor(4.0 * unit(random));
        const double phase = turn * unit(random);
        const auto ring = [=](double t) {
            const double r = radius * (1.0 + wobble * std::cos(waves * turn * t + phase));
            return Vec2(x, y) + r * Vec2(std::cos(turn * t), std::sin(turn * t));
        };
        scene.contours.push_back(smooth("ring " + std::to_string(k), ring, 16, true));
    }
    return scene;
}

Scene adversarial() {
    Scene scene{side_mm, side_mm, {}};
    scene.contours.push_back(smooth(
        "spiral",
        [](double t) {
            const double r = 2.0 + 1.5 * 20.0 * t;
            return Vec2(-50.0, 45.0) + r * Vec2(std::cos(20.0 * turn * t), std::sin(20.0 * turn * t));
        },
        320, false));
    for (int k = 0; k < 12; ++k) { // cubics whose handles cross: a cusp, a loop, a hairpin
        const Vec2 at(12.0 + 14.0 * (k % 6), k < 6 ? 30.0 : 60.0);
        const double open = 0.5 * (k - 6);
        scene.contours.push_back(
            {"cusp " + std::to_string(k),
             {Cubic{at, at + Vec2(12.0 + open, 20.0), at + Vec2(-open, 20.0), at + Vec2(12.0, 0.0)}},
             false});
    }
    for (int k = 0; k < 60; ++k) {
        const double x = -90.0 + 0.7 * k;
        scene.contours.push_back(
            contour_through("tooth " + std::to_string(k), {{x, -20.0}, {x, -20.0 - k}}, false));
    }
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int k = 0; k < 200; ++k) {
        const double x = 5.0 + 85.0 * unit(random);
        const Vec2 at(x, -85.0 + 70.0 * unit(random));
        scene.contours.push_back(contour_through(
            "speck " + std::to_string(k), {at, at + (k % 2 == 0 ? Vec2(0.0) : Vec2(1e-12, 0.0))}, false));
    }
    return scene;
}

} // namespace

std::vector<AccuracyScene> accuracy_scenes() {
    return {{"face", reference_face()}, {"map", map()}, {"adversarial", adversarial()}};
}

} // namespace tp
