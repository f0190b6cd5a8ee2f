// SPDX-License-Identifier: Apache-2.0
#include "app/figures/simulated/touch_trials.hpp"

#include "app/figures/simulated/bare_finger.hpp"
#include "app/figures/simulated/simulated_trial.hpp"
#include "core/base/chance.hpp"
#include "core/participant/study_hand.hpp"
#include "core/participant/touch_hand.hpp"
#include "core/servo/servo_loop.hpp"
#include "core/trials/trial_judge.hpp"
#include "device/simulated/simulated_device.hpp"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double side_mm = 140.0; // of the surface
constexpr double off_line_mm = 15.0;
constexpr double tick_s = BareFinger::tick_s;
constexpr int ticks_a_step = BareFinger::ticks_a_step;
constexpr double step_s = BareFinger::step_s;

std::size_t ticks_of(double latency_s) { return static_cast<std::size_t>(std::lround(latency_s / tick_s)); }

Vec2 off_the_line(const StudyTrial& trial, std::uint64_t seed) {
    Chance chance(seed + 7);
    const double half = 0.5 * side_mm;
    Vec2 place{0.0};
    do {
        place.x = chance.between(-half, half);
        place.y = chance.between(-half, half);
    } while (distance_to(trial.path, place) < off_line_mm);
    return place;
}

/// Whether a line was found, asked after each step.
class Finding {
public:
    bool after_step(bool following, double distance) {
        near_s_ = following && distance <= found_mm ? near_s_ + step_s : 0.0;
        return near_s_ >= found_s;
    }

private:
    double near_s_ = 0.0;
};

SimulatedBench force_bench(double latency_s) {
    SimulatedBench bench;
    bench.delay_ticks = ticks_of(latency_s);
    return bench;
}

Result<std::optional<double>> find_by_force(const StudyTrial& trial, const Person& person, double latency_s,
                                            Vec2 start, std::uint64_t seed) {
    auto scene = haptic_scene_of(trial);
    if (!scene)
        return Error{scene.error()};
    SimulatedPlant plant;
    plant.mass = person.mass_kg;
    plant.hand_stiffness = person.stiffness_n_per_mm;
    plant.hand_damping = person.damping_n_s_per_m;
    plant.delay_ticks = ticks_of(latency_s);
    VirtualClock clock;
    SimulatedDevice device(side_mm, side_mm, plant);
    const Capabilities can = *device.open();
    ServoLoop loop(device, can, clock, ServoSettings{});
    loop.render(std::move(*scene));
    loop.engage();
    device.place_finger(start);
    StudyHand hand(person, trial.scene.surface(), start, false, step_s, seed);
    Finding finding;
    for (double time = 0.0; time < longest_touch_s; time += step_s) {
        for (int i = 0; i < ticks_a_step; ++i) {
            clock.sleep_until(clock.now() + tick_s);
            loop.tick();
        }
        const ServoSnapshot view = loop.snapshot();
        device.move_pointer(hand.step(view.finger(), view.force()));
        if (finding.after_step(hand.following(), distance_to(trial.path, view.finger())))
            return std::optional(time);
    }
    return std::optional<double>();
}

} // namespace

StudyTrial touch_trial(StudyShape shape, std::uint64_t seed) {
    Chance chance(seed);
    StudyTrial trial;
    trial.scene.width_mm = trial.scene.height_mm = side_mm;
    const double first = shape == StudyShape::triangle ? std::floor(chance.between(0.0, 3.0))
                         : shape == StudyShape::curve  ? (chance.happens(0.5) ? 1.0 : 0.0)
                                                       : chance.share();
    const double radius = std::min(usual_radius_mm(shape), 0.5 * side_mm - study_margin_mm);
    trial.scene.contours = {study_shape(shape, Vec2(0.0), radius, first)};
    trial.path = flatten(trial.scene.contours.front());
    trial.start = trial.path.points.front();
    const double whole = length_of(trial.path);
    trial.reach_mm = std::min(study_reach_mm, 0.5 * whole / study_path_parts);
    for (int part = 1; part < study_path_parts; ++part)
        trial.knots.push_back(point_along(trial.path, whole * part / study_path_parts));
    return trial;
}

Result<TouchFollowing> follow_line(const StudyTrial& trial, const Person& person, TouchManner manner,
                                   double latency_s, std::uint64_t seed) {
    if (manner == TouchManner::force) {
        const auto done = simulate_trial(trial, person, force_bench(latency_s), seed);
        if (!done)
            return Error{done.error()};
        return TouchFollowing{done->state == TrialState::done, done->time_s, done->error_mm.value_or(0.0), 0};
    }
    BareFinger finger(trial.path, person, manner, latency_s, trial.start);
    TouchHand hand(person, trial.scene.surface(), trial.start, true, step_s, seed);
    TrialJudge judge(trial);
    Vec2 meant = trial.start;
    for (double time = 0.0; judge.state() == TrialState::going && time < longest_touch_s; time += step_s) {
        const BareTouch touch = finger.move(meant);
        judge.feed(time, finger.place());
        meant = hand.step(finger.place(), touch);
    }
    return TouchFollowing{judge.state() == TrialState::done, judge.time_s(), judge.error_mm().value_or(0.0),
                          hand.times_lost()};
}

Result<std::optional<double>> find_line(const StudyTrial& trial, const Person& person, TouchManner manner,
                                        double latency_s, std::uint64_t seed) {
    const Vec2 start = off_the_line(trial, seed);
    if (manner == TouchManner::force)
        return find_by_force(trial, person, latency_s, start, seed);
    BareFinger finger(trial.path, person, manner, latency_s, start);
    TouchHand hand(person, trial.scene.surface(), start, false, step_s, seed);
    Finding finding;
    Vec2 meant = start;
    for (double time = 0.0; time < longest_touch_s; time += step_s) {
        const BareTouch touch = finger.move(meant);
        meant = hand.step(finger.place(), touch);
        if (finding.after_step(hand.following(), finger.distance()))
            return std::optional(time);
    }
    return std::optional<double>();
}

} // namespace tp
