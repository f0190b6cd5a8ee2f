// SPDX-License-Identifier: Apache-2.0
// Nearest contour, every method at every size: guidance_bench --benchmark_filter='hand_path/.*/1000$'
#include "app/figures/bench/bench_scene.hpp"
#include "app/figures/bench/nearest_method.hpp"

#include <benchmark/benchmark.h>

using namespace tp;

namespace {

constexpr std::size_t batch = 1000;

void ask(benchmark::State& state, std::string_view method_name, const std::vector<Vec2>& places) {
    const BenchScene scene = bench_scene(static_cast<std::size_t>(state.range(0)));
    const auto method = NearestMethod::make(method_name, scene.flat);
    std::size_t at = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(method->ask({places.data() + at, batch}));
        at = at + 2 * batch <= places.size() ? at + batch : 0;
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batch));
    state.counters["bytes"] = static_cast<double>(method->bytes());
}

void build(benchmark::State& state, std::string_view method_name) {
    const BenchScene scene = bench_scene(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(NearestMethod::make(method_name, scene.flat));
}

} // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    const auto path = hand_path(100'000);
    const auto places = random_places(100'000);
    for (const std::string_view name : NearestMethod::names) {
        const bool slow = name == "plain_loop" || name == "published_scan";
        const std::string method(name);
        for (const std::int64_t size : {64, 256, 1000, 10'000, 100'000, 1'000'000}) {
            if (slow && size > 10'000)
                continue;
            benchmark::RegisterBenchmark((std::string("hand_path/") + method).c_str(),
                                         [&path, name](benchmark::State& state) { ask(state, name, path); })
                ->Arg(size);
            benchmark::RegisterBenchmark(
                (std::string("random/") + method).c_str(),
                [&places, name](benchmark::State& state) { ask(state, name, places); })
                ->Arg(size);
            benchmark::RegisterBenchmark((std::string("build/") + method).c_str(),
                                         [name](benchmark::State& state) { build(state, name); })
                ->Arg(size)
                ->Unit(benchmark::kMillisecond);
        }
    }
    benchmark::RunSpecifiedBenchmarks();
}
