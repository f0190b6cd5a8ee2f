// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes.hpp"

#include <functional>
#include <vector>

namespace tp::testing {

/// A scene where very many segments are about equally near to one place, and the place.
struct CrowdedScene {
    const char* name;
    Vec2 hub; ///< mm
    std::function<FlatScene(int count)> make;
};

inline FlatScene one_by_one(const std::vector<std::pair<Vec2, Vec2>>& segments) {
    FlatScene scene;
    for (const auto& [from, to] : segments) {
        scene.names.emplace_back("piece");
        scene.lines.push_back({{from, to}, false});
    }
    return scene;
}

inline Vec2 on_circle(double radius, double turns) {
    const double angle = 2.0 * std::numbers::pi * turns;
    return radius * Vec2(std::cos(angle), std::sin(angle));
}

/// Pieces made from their number and the share of all that comes before it.
inline FlatScene pieces(int count, const std::function<std::pair<Vec2, Vec2>(int, double)>& piece) {
    std::vector<std::pair<Vec2, Vec2>> all;
    for (int i = 0; i < count; ++i)
        all.push_back(piece(i, double(i) / count));
    return one_by_one(all);
}

inline FlatScene uneven_circle(int count, double unevenness) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> more(0.0, unevenness);
    Polyline line{{}, true};
    for (int i = 0; i < count; ++i)
        line.points.push_back(on_circle(80.0 + more(random), double(i) / count));
    return {{"circle"}, {line}};
}

inline const std::vector<CrowdedScene>& crowded_scenes() {
    static const std::vector<CrowdedScene> all{
        {"centre_of_a_circle",
         {3, -2},
         [](int n) {
             return FlatScene{{"circle"}, {ellipse({3, -2}, 80, 80, n)}};
         }},
        {"centre_of_a_circle_uneven_by_a_micrometre", {0, 0}, [](int n) { return uneven_circle(n, 1e-3); }},
        {"centre_of_a_circle_uneven_by_a_nanometre", {0, 0}, [](int n) { return uneven_circle(n, 1e-6); }},
        {"centre_of_a_circle_uneven_by_a_millimetre", {0, 0}, [](int n) { return uneven_circle(n, 1.0); }},
        {"centre_of_many_circles",
         {0, 0},
         [](int n) {
             FlatScene scene;
             for (int k = 0; k < 10; ++k) {
                 scene.names.push_back("circle " + std::to_string(k));
                 scene.lines.push_back(ellipse({0, 0}, 20.0 + 1e-7 * k, 20.0 + 1e-7 * k, n / 10));
             }
             return scene;
         }},
        {"crossing_of_diameters",
         {1, 2},
         [](int n) {
             return pieces(n, [](int, double share) {
                 return std::pair(Vec2(1, 2) - on_circle(80, 0.5 * share),
                                  Vec2(1, 2) + on_circle(80, 0.5 * share));
             });
         }},
        {"middle_of_a_star_of_rays",
         {0, 0},
         [](int n) {
             return pieces(
                 n, [](int, double share) { return std::pair(on_circle(1, share), on_circle(5, share)); });
         }},
        {"middle_of_dots_in_a_circle",
         {0, 0},
         [](int n) {
             return pieces(
                 n, [](int, double share) { return std::pair(on_circle(40, share), on_circle(40, share)); });
         }},
        {"middle_of_a_cogwheel",
         {0, 0},
         [](int n) {
             return pieces(n, [n](int i, double share) {
                 const double in = i % 2 == 0 ? 40 : 60;
                 return std::pair(on_circle(in, share), on_circle(100 - in, share + 1.0 / n));
             });
         }},
        {"where_an_ellipse_curves_most",
         {60, 0},
         [](int n) {
             return FlatScene{{"ellipse"}, {ellipse({0, 0}, 80, 40, n)}};
         }},
        {"chords_all_over",
         {0, 0},
         [](int n) {
             std::mt19937 random(6);
             return pieces(n, [&](int, double) {
                 const Vec2 from = random_point(random, 90.0);
                 return std::pair(from, random_point(random, 90.0));
             });
         }},
        {"teeth_of_a_comb",
         {0, 0},
         [](int n) {
             return pieces(n, [](int, double share) {
                 return std::pair(Vec2(-90, 100.0 * share - 50.0), Vec2(90, 100.0 * share - 50.0));
             });
         }},
        {"long_lines_among_short_ones",
         {0, 0},
         [](int n) {
             std::mt19937 random(7);
             return pieces(n, [&](int i, double share) {
                 const Vec2 from = random_point(random, 90.0);
                 return i % 8 == 0 ? std::pair(-on_circle(95, share), on_circle(95, share))
                                   : std::pair(from, from + random_point(random, 0.05));
             });
         }},
    };
    return all;
}

} // namespace tp::testing
