// SPDX-License-Identifier: Apache-2.0
#include "app/figures/simulated/simulated_trial.hpp"

#include "app/figures/simulated/simulated_hands.hpp"
#include "core/base/chance.hpp"
#include "core/servo/servo_loop.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace tp {
namespace {

constexpr double settle_s = 0.7; // the force's ramp is over before a trial begins
constexpr double hand_step_s = 0.005;
constexpr double longest_lead_s = 60.0;

SimulatedPlant plant_of(const Person& person, const SimulatedBench& bench) {
    SimulatedPlant plant;
    plant.mass = bench.body.mass_kg;
    plant.damping = bench.body.damping_n_s_per_m;
    plant.coulomb = bench.body.coulomb_n;
    plant.quantum = bench.body.quantum_mm;
    if (!bench.body.drawn) {
        plant.mass += person.mass_kg - simulated_handle_kg;
        plant.hand_stiffness = person.stiffness_n_per_mm;
        plant.hand_damping = person.damping_n_s_per_m;
    }
    plant.delay_ticks = bench.delay_ticks;
    plant.tick = 1.0 / bench.rate_hz;
    return plant;
}

Vec2 somewhere_on(const Rect& surface, std::uint64_t seed) {
    Chance chance(seed);
    return {surface.min.x + surface.width() * chance.share(),
            surface.min.y + surface.height() * chance.share()};
}

ServoSettings servo_of(const StudyTrial& trial, const SimulatedBench& bench) {
    ServoSettings settings;
    settings.rate = bench.rate_hz;
    const double asked = trial.profile.stiffness * trial.profile.range;
    settings.limits.max_force = bench.limit_n.value_or(std::max(settings.limits.max_force, asked));
    return settings;
}

} // namespace

Result<SimulatedTrial> simulate_trial(const StudyTrial& trial, const Person& person,
                                      const SimulatedBench& bench, std::uint64_t seed) {
    auto scene = haptic_scene_of(trial, bench.continuity);
    if (!scene)
        return Error{scene.error()};
    VirtualClock clock;
    SimulatedDevice device(trial.scene.width_mm, trial.scene.height_mm, plant_of(person, bench));
    Capabilities can = *device.open();
    can.max_force = bench.body.max_force_n;
    can.continuous_force = bench.body.continuous_force_n;
    ServoLoop loop(device, can, clock, servo_of(trial, bench));
    const int ticks_a_step = std::max(1, static_cast<int>(std::lround(hand_step_s * bench.rate_hz)));
    const double step_s = ticks_a_step / bench.rate_hz;
    const auto pass = [&] {
        for (int i = 0; i < ticks_a_step; ++i) {
            clock.sleep_until(clock.now() + 1.0 / bench.rate_hz);
            loop.tick();
        }
    };
    SimulatedTrial done;
    Vec2 meant = trial.start;
    loop.engage();
    if (bench.led) {
        auto way = haptic_scene_of(trial, bench.continuity);
        (*way)->tour = Polyline{{trial.start}, false};
        device.place_finger(somewhere_on(trial.scene.surface(), seed));
        device.relax(true);
        loop.render(std::move(*way));
        while (!loop.snapshot().tour_finished && clock.now() < longest_lead_s)
            pass();
        device.relax(false);
        done.led_s = clock.now();
        device.move_pointer(meant = loop.snapshot().finger());
    } else {
        device.place_finger(meant);
    }
    loop.render(std::move(*scene));
    for (const double until = clock.now() + settle_s; clock.now() < until;)
        pass();

    const auto hand = hand_for(trial, person, step_s, seed);
    TrialJudge judge(trial);
    const double begun = clock.now();
    double next_sample = 0.0;
    std::optional<double> answers_at;
    while (judge.state() == TrialState::going) {
        const ServoSnapshot view = loop.snapshot();
        const double time = clock.now() - begun;
        if (time >= next_sample - 1e-9) {
            judge.feed(time, view.finger());
            done.path.push_back({time, view.x, view.y, view.fx, view.fy});
            next_sample += simulated_sample_s;
        }
        if (trial.asks && !answers_at)
            if (const auto answer = hand->knows(done.path)) {
                done.answer = *answer;
                answers_at = time + person.answer_s;
            }
        if (answers_at && time >= *answers_at)
            break;
        if (!trial.longest_s && time >= longest_following_s)
            break;
        meant = hand->step(bench.body.drawn ? meant : view.finger(), view.force());
        device.move_pointer(meant);
        pass();
    }
    if (trial.asks && !answers_at)
        done.answer = hand->guess(done.path);
    done.state = judge.state();
    done.error_mm = judge.error_mm();
    done.time_s = judge.time_s();
    return done;
}

} // namespace tp
