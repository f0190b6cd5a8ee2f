// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/hard_cases.hpp"

#include "app/figures/report/csv_table.hpp"
#include "core/guidance/exact_law.hpp"
#include "core/guidance/published_law.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/simulated/simulated_device.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace tp {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Polyline open_line(std::vector<Vec2> points) { return {std::move(points), false}; }

FlatScene scene_of(std::vector<Polyline> lines) {
    FlatScene scene;
    for (Polyline& line : lines) {
        scene.names.push_back("line " + std::to_string(scene.names.size() + 1));
        scene.lines.push_back(std::move(line));
    }
    return scene;
}

/// Two arcs that meet at the corners of a nearly shut eye, `gap` mm apart in the middle.
FlatScene closed_eye(double gap) {
    Polyline eye{{}, true};
    for (int i = -14; i <= 14; ++i)
        eye.points.emplace_back(i, 0.5 * gap * (1.0 - i * i / 196.0));
    for (int i = 13; i >= -13; --i)
        eye.points.emplace_back(i, -0.5 * gap * (1.0 - i * i / 196.0));
    return scene_of({eye});
}

FlatScene million_in_a_square_millimetre() {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    Polyline scribble{{}, false};
    scribble.points.reserve(1'000'001);
    for (int i = 0; i <= 1'000'000; ++i) {
        const double x = place(random);
        scribble.points.emplace_back(x, place(random));
    }
    return scene_of({scribble});
}

constexpr int crowd = 100'000;

/// Short chords, all of them equally far from the centre.
FlatScene circle_of_many() {
    Polyline circle{{}, true};
    for (int i = 0; i < crowd; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / crowd;
        circle.points.push_back(80.0 * Vec2(std::cos(angle), std::sin(angle)));
    }
    return scene_of({circle});
}

/// Long lines that all cross in the origin.
FlatScene many_diameters() {
    std::vector<Polyline> diameters;
    for (int i = 0; i < crowd; ++i) {
        const double angle = std::numbers::pi * i / crowd;
        const Vec2 end = 80.0 * Vec2(std::cos(angle), std::sin(angle));
        diameters.push_back(open_line({-end, end}));
    }
    return scene_of(std::move(diameters));
}

/// Distance to the nearest contour, by looking at every segment.
double true_distance(const FlatScene& scene, Vec2 finger) {
    double best = infinity;
    for (const Polyline& line : scene.lines)
        best = std::min(best, distance_to(line, finger));
    return best;
}

HardVerdict judge_place(const HardPlace& place, const std::string& name, const GuidanceLaw& law,
                        const TentProfile& profile) {
    HardVerdict verdict{place.name, name, "right", 0.0, ""};
    double worst = 0.0;
    for (const Vec2 finger : place.fingers) {
        const Vec2 force = law.at(finger).force;
        const double magnitude = length(force);
        if (!is_finite(force) || magnitude > profile.peak() * (1.0 + 1e-9)) {
            verdict.verdict = "unsafe";
            verdict.note = "a force that is no number or above the peak";
            return verdict;
        }
        verdict.max_force_n = std::max(verdict.max_force_n, magnitude);
        const double distance = is_finite(finger) ? true_distance(place.scene, finger) : infinity;
        double error = std::abs(magnitude - profile.force(distance));
        if (magnitude > 0.0 && distance < profile.band()) {
            // Going the distance along the force must end on a contour, whichever of several equally near
            // ones.
            const double miss = true_distance(place.scene, finger + (distance / magnitude) * force);
            if (miss > 1e-6 * std::max(1.0, length(finger)))
                error = std::max(error, profile.stiffness * miss);
        }
        worst = std::max(worst, error);
    }
    // Far from the origin a double has fewer digits left for a distance.
    double far = 1.0;
    for (const Vec2 finger : place.fingers)
        if (is_finite(finger))
            far = std::max(far, length(finger));
    if (worst > 1e-9 * std::max(1.0, 1e-6 * far)) {
        verdict.verdict = "wrong";
        verdict.note = "force off by " + cell(worst, 3) + " N";
    }
    return verdict;
}

/// The servo in simulated time, with a hand held at `finger`, 2 mm beside a line.
struct Touch {
    VirtualClock clock;
    SimulatedDevice device{200.0, 150.0, firm_hand()};
    Capabilities can = *device.open();
    ServoLoop loop{device, can, clock, ServoSettings{}};
    LawKind law;
    double largest = 0.0;
    double largest_step = 0.0;
    Vec2 last{0.0};

    static SimulatedPlant firm_hand() {
        SimulatedPlant plant;
        plant.hand_stiffness = 2.0;
        plant.hand_damping = 20.0;
        return plant;
    }

    explicit Touch(LawKind kind) : law(kind) {
        device.place_finger({0.0, 2.0});
        show(0.0);
        loop.engage();
        run(1.0);
        largest = 0.0;
        largest_step = 0.0;
    }
    void show(double y) {
        std::vector<Vec2> points;
        for (int x = -90; x <= 90; ++x)
            points.emplace_back(x, y);
        auto made = make_haptic_scene({200.0, 150.0, {contour_through("line", points, false)}}, {}, law);
        loop.render(std::move(made).value());
    }
    void tick(double dt) {
        clock.sleep_until(clock.now() + dt);
        loop.tick();
        const Vec2 force = loop.snapshot().force();
        largest = std::max(largest, length(force));
        largest_step = std::max(largest_step, length(force - last));
        last = force;
    }
    void run(double seconds) {
        for (double t = 0.0; t < seconds; t += 0.001)
            tick(0.001);
    }
    double force() const { return length(last); }
};

HardVerdict judge_event(const char* name, LawKind law, const std::function<std::string(Touch&)>& happen) {
    Touch touch(law);
    const std::string fault = happen(touch);
    HardVerdict verdict{name, law == LawKind::exact ? "exact" : "published",
                        fault.empty() ? "right" : "unsafe", touch.largest, fault};
    if (fault.empty())
        verdict.note = "largest change in one tick " + cell(touch.largest_step, 3) + " N";
    return verdict;
}

std::string late_tick(Touch& touch) {
    touch.tick(0.100);
    if (touch.force() != 0.0 || touch.loop.snapshot().fault != Fault::stalled)
        return "a force was left after the loop had stood still";
    touch.run(1.0);
    return touch.force() == 0.0 ? "" : "the force came back by itself";
}

std::string swapped_scene(Touch& touch) {
    touch.show(5.0);
    touch.run(0.5);
    return touch.largest_step <= 0.04 + 1e-9 ? "" : "the force changed faster than 40 N/s";
}

std::string jumping_device(Touch& touch) {
    touch.device.place_finger({50.0, 2.0});
    double t = 0.0;
    while (t < 0.025 && touch.force() > 0.0) {
        touch.tick(0.001);
        t += 0.001;
    }
    return touch.force() == 0.0 ? "" : "a force was left 25 ms after the jump";
}

} // namespace

std::vector<HardPlace> hard_places() {
    const double nan = std::nan("");
    const double edge = TentProfile{}.band();
    const Polyline level = open_line({{-50, 0}, {-10, 0}, {0, 0}, {10, 0}, {50, 0}});
    const Polyline upright = open_line({{0, -50}, {0, -5}, {0, 5}, {0, 50}});
    std::vector<HardPlace> places;
    places.push_back({"finger_exactly_on_line", scene_of({level}), {{5, 0}, {-20, 0}, {33.3, 0}}});
    places.push_back({"finger_exactly_on_vertex", scene_of({level}), {{0, 0}, {10, 0}, {50, 0}}});
    places.push_back({"finger_beside_the_end", scene_of({level}), {{53, 1}, {-52, -2}, {57.9, 0}}});
    places.push_back(
        {"finger_at_a_crossing", scene_of({level, upright}), {{0, 0}, {1, 1}, {-2, 2}, {3, -3}}});
    places.push_back({"crossing_away_from_vertices",
                      scene_of({open_line({{-50, 0}, {-7, 0}, {9, 0}, {50, 0}}),
                                open_line({{0, -50}, {0, -6}, {0, 8}, {0, 50}})}),
                      {{1.5, 1.2}, {-1.0, 0.5}, {0.3, -0.9}}});
    places.push_back(
        {"equidistant_from_two_contours",
         scene_of({open_line({{-50, 3}, {0, 3}, {50, 3}}), open_line({{-50, -3}, {0, -3}, {50, -3}})}),
         {{5, 0}, {0, 0}, {-17, 0}}});
    places.push_back({"equidistant_from_three_contours",
                      scene_of({open_line({{-5, 3}, {5, 3}}), open_line({{-3, -9}, {-3, 5}}),
                                open_line({{3, -9}, {3, 5}})}),
                      {{0, 0}}});
    places.push_back({"medial_axis_of_a_closed_eye", closed_eye(1.0), {{0, 0}, {7, 0}, {-13, 0}, {0, 0.2}}});
    places.push_back({"two_lips_in_one_line",
                      scene_of({open_line({{-20, 0}, {-7, 0}, {7, 0}, {20, 0}}),
                                open_line({{-18, 0}, {-6, 0}, {6, 0}, {18, 0}})}),
                      {{0, 2}, {6.5, 1}, {-6.5, -3}}});
    places.push_back({"coincident_contours", scene_of({level, level}), {{5, 2}, {-20, 4}, {0, 1}}});
    const FlatScene dense_twice = with_vertex_spacing(scene_of({level, level}), 0.5);
    places.push_back(
        {"coincident_contours_of_dense_vertices", dense_twice, {{5.2, 0.1}, {-20, 4}, {0.1, 1}}});
    const FlatScene dense_crossing = with_vertex_spacing(scene_of({level, upright}), 0.5);
    places.push_back(
        {"crossing_of_dense_vertices", dense_crossing, {{0.2, 0.15}, {-0.3, 0.25}, {0.4, -0.2}, {0.7, 0.6}}});
    places.push_back(
        {"contour_of_dense_vertices", with_vertex_spacing(scene_of({level}), 0.5), {{5.2, 2}, {-20.1, 6}}});
    places.push_back({"coincident_vertices",
                      scene_of({open_line({{0, 0}, {0, 0}, {10, 0}, {10, 0}})}),
                      {{0, 2}, {5, 1}, {10, 3}}});
    places.push_back({"segment_of_length_zero", scene_of({{{{3, 3}}, true}}), {{3, 3}, {3, 5}, {6, 3}}});
    places.push_back({"segment_of_length_1e_minus_12",
                      scene_of({open_line({{3, 3}, {3 + 1e-12, 3}})}),
                      {{3, 3}, {3, 5}, {6, 3}}});
    places.push_back({"unevenly_spaced_vertices",
                      scene_of({open_line({{-50, 0}, {0, 0}, {0.1, 0}, {0.1, 20}})}),
                      {{-10, 2}, {-3, 1}, {-25, 3}, {2, 5}}});
    places.push_back(
        {"a_million_segments_in_1_mm2", million_in_a_square_millimetre(), {{0.5, 0.5}, {3, 0.5}, {-2, -2}}});
    places.push_back({"centre_of_a_circle_of_100000_segments",
                      circle_of_many(),
                      {{0, 0}, {1e-9, 2e-10}, {1e-3, 0}, {77, 0}, {0, -83}}});
    places.push_back({"crossing_of_100000_diameters",
                      many_diameters(),
                      {{0, 0}, {1e-9, 2e-10}, {0.01, 0.02}, {40, 3}, {84, 3}}});
    places.push_back({"a_stray_line_4_m_away",
                      scene_of({level, open_line({{4000, 0}, {4001, 1}})}),
                      {{5, 2}, {-20, 4}, {4000, 3}, {2000, 0}}});
    places.push_back({"a_line_200_m_long",
                      scene_of({level, open_line({{-1e5, -3e4}, {1e5, 3e4}})}),
                      {{5, 1}, {-30, -7}, {20, 8}, {1000, 303}}});
    places.push_back({"a_scene_of_1e6_mm",
                      scene_of({open_line({{-1e6, -1e6}, {1e6, 1e6}}), open_line({{-1e6, 5}, {1e6, 6}})}),
                      {{0, 1}, {30, 27}, {999990, 999987}, {-999000, 8}}});
    places.push_back({"nan_and_inf", scene_of({level}), {{nan, 0}, {0, nan}, {infinity, 0}, {0, -infinity}}});
    places.push_back({"coordinates_of_1e9_mm",
                      scene_of({open_line({{1e9, 1e9}, {1e9 + 10, 1e9}})}),
                      {{1e9 + 5, 1e9 + 2}, {1e9 + 3, 1e9 - 6}, {0, 0}}});
    places.push_back({"range_edge",
                      scene_of({level}),
                      {{5, edge}, {5, std::nextafter(edge, 0.0)}, {5, std::nextafter(edge, 9.0)}, {5, 4.0}}});
    return places;
}

std::vector<HardVerdict> judge_hard_cases() {
    const TentProfile profile;
    std::vector<HardVerdict> verdicts;
    for (const HardPlace& place : hard_places()) {
        verdicts.push_back(judge_place(place, "exact", ExactLaw(place.scene, profile), profile));
        verdicts.push_back(judge_place(place, "published", PublishedLaw(place.scene, profile), profile));
    }
    for (const LawKind law : {LawKind::exact, LawKind::published}) {
        verdicts.push_back(judge_event("a_tick_100_ms_late", law, late_tick));
        verdicts.push_back(judge_event("a_scene_swapped_in_mid_touch", law, swapped_scene));
        verdicts.push_back(judge_event("a_device_that_jumps_50_mm_in_one_tick", law, jumping_device));
    }
    return verdicts;
}

} // namespace tp
