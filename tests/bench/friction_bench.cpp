// SPDX-License-Identifier: Apache-2.0
// What a bare finger's friction and ticks cost beside the force law, per sample of a hand that wanders over a face:
// friction_bench --benchmark_repetitions=5
#include "app/figures/bench/bench_scene.hpp"
#include "core/friction/friction_finger.hpp"
#include "core/guidance/exact_law.hpp"

#include <benchmark/benchmark.h>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace tp;

namespace {

void force_law(benchmark::State& state) {
    const ExactLaw exact(bench_scene(static_cast<std::size_t>(state.range(0))).flat, {});
    const std::vector<Vec2> path = hand_path(100'000);
    for (auto _ : state)
        for (const Vec2 place : path)
            benchmark::DoNotOptimize(exact.at(place));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(path.size()));
}

/// With `textured`, stripes in all features.
void force_law_and_friction(benchmark::State& state, bool textured) {
    const FlatScene scene = bench_scene(static_cast<std::size_t>(state.range(0))).flat;
    const std::vector<Vec2> path = hand_path(100'000);
    FrictionChoices choices;
    if (textured)
        choices.textured = scene.names;
    const ExactLaw exact(scene, {});
    const FrictionLaw law(scene, choices);
    FrictionFinger finger(law);
    std::size_t events = 0;
    for (auto _ : state) {
        finger.lift();
        for (const Vec2 place : path) {
            const Friction friction = finger.step(place, {80.0, 0.0}, exact.at(place));
            benchmark::DoNotOptimize(friction.level);
            events += friction.events.size();
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(path.size()));
    state.counters["events"] = static_cast<double>(events) / static_cast<double>(state.iterations());
}

void force_law_and_ridges(benchmark::State& state) { force_law_and_friction(state, false); }
void force_law_and_texture(benchmark::State& state) { force_law_and_friction(state, true); }

} // namespace

BENCHMARK(force_law)->Arg(256)->Arg(1000);
BENCHMARK(force_law_and_ridges)->Arg(256)->Arg(1000);
BENCHMARK(force_law_and_texture)->Arg(256)->Arg(1000);
BENCHMARK_MAIN();
