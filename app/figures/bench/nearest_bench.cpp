// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/nearest_bench.hpp"

#include "app/figures/bench/bench_clock.hpp"
#include "app/figures/bench/nearest_method.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace tp {

namespace {

using Clock = std::chrono::steady_clock;

double ns_since(Clock::time_point start) {
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

long double true_distance(const FlatScene& scene, Vec2 p) {
    using Wide = long double;
    Wide best = std::numeric_limits<Wide>::infinity();
    for (const Polyline& line : scene.lines)
        for (std::size_t i = 0; i < line.segment_count(); ++i) {
            const Vec2 a = line.segment_start(i);
            const Vec2 b = line.segment_end(i);
            const Wide ux = Wide(b.x) - Wide(a.x), uy = Wide(b.y) - Wide(a.y);
            const Wide ax = Wide(p.x) - Wide(a.x), ay = Wide(p.y) - Wide(a.y);
            const Wide way = (ux * ax + uy * ay) / (ux * ux + uy * uy);
            const Wide clamped = way > 0 ? std::min(way, Wide(1)) : Wide(0);
            const Wide x = ax - clamped * ux, y = ay - clamped * uy;
            best = std::min(best, x * x + y * y);
        }
    return std::sqrt(best);
}

struct Contender {
    std::string name;
    std::unique_ptr<NearestMethod> method;
    double build_ms = 0.0;
    std::size_t batch = 0; ///< questions
    std::vector<double> ns;
};

Contender build(const std::string& name, const FlatScene& scene, std::size_t segments) {
    Contender contender{name, nullptr, 0.0, 0, {}};
    std::vector<double> took;
    for (int turn = 0; turn < (segments > 20'000 ? 1 : segments > 2'000 ? 5 : 25); ++turn) {
        contender.method.reset();
        const BusyClock clock;
        contender.method = NearestMethod::make(name, scene);
        took.push_back(1e-6 * clock.ns());
    }
    contender.build_ms = quantile(took, 0.5);
    return contender;
}

std::span<const Vec2> batch_at(const std::vector<Vec2>& places, std::size_t round, std::size_t count) {
    const std::size_t room = places.size() - count;
    return {places.data() + (room > 0 ? round * count % room : 0), count};
}

/// As many questions as fill a batch.
std::size_t batch_size(const NearestMethod& method, const std::vector<Vec2>& places, double batch_ms) {
    std::size_t count = 4;
    for (;;) {
        const auto start = Clock::now();
        keep(method.ask(batch_at(places, 0, count)));
        const double took = ns_since(start);
        if (took > 1e5 || count >= 4000)
            return std::clamp<std::size_t>(
                static_cast<std::size_t>(1e6 * batch_ms / took * static_cast<double>(count)), 4, 20'000);
        count *= 4;
    }
}

double slow_ns(const Contender& contender, const std::vector<Vec2>& places, double budget_ms) {
    std::vector<double> clock, single;
    for (int i = 0; i < 1001; ++i) {
        const auto start = Clock::now();
        clock.push_back(ns_since(start));
    }
    const double cost = quantile(clock, 0.5);
    const auto begin = Clock::now();
    for (const Vec2 place : places) {
        const auto start = Clock::now();
        keep(contender.method->nearest(place).distance);
        single.push_back(std::max(0.0, ns_since(start) - cost));
        if (single.size() > 100 && ns_since(begin) > 1e6 * budget_ms)
            break;
    }
    return quantile(single, 0.999);
}

double largest_error(const NearestMethod& method, const std::vector<Vec2>& places,
                     const std::vector<long double>& truths) {
    double worst = 0.0;
    for (std::size_t i = 0; i < truths.size(); ++i) {
        const double distance = method.nearest(places[i * (places.size() / truths.size())]).distance;
        if (distance == std::numeric_limits<double>::infinity() && truths[i] > method.reach() - 1e-9)
            continue;
        const double error = static_cast<double>(std::abs(distance - truths[i]));
        worst = std::isfinite(error) ? std::max(worst, error) : std::numeric_limits<double>::infinity();
    }
    return worst;
}

} // namespace

BenchPlan BenchPlan::whole() {
    return {
        {64, 256, 1000, 10'000, 100'000, 1'000'000}, 41, 5.0, [](const std::string& method, std::size_t n) {
            return n <= 100'000 || (method != "plain_loop" && method != "published_scan");
        }};
}

BenchPlan BenchPlan::quick() {
    return {{1000, 10'000, 1'000'000}, 21, 3.0, [](const std::string& method, std::size_t n) {
                return n <= 10'000 || (method != "plain_loop" && method != "published_scan");
            }};
}

std::vector<BenchRow> run_nearest_bench(const BenchPlan& plan,
                                        const std::function<void(const std::string&)>& progress) {
    constexpr std::size_t asked = 100'000;
    const std::pair<const char*, std::vector<Vec2>> questions[] = {{"hand_path", hand_path(asked)},
                                                                   {"random", random_places(asked)}};
    std::vector<BenchRow> rows;
    for (const std::size_t size : plan.sizes) {
        const BenchScene scene = bench_scene(size);
        progress(scene.name + " of " + std::to_string(size) + " segments");
        std::vector<Contender> contenders;
        for (const std::string_view name : NearestMethod::names)
            if (plan.wanted(std::string(name), size))
                contenders.push_back(build(std::string(name), scene.flat, size));
        for (const auto& [kind, places] : questions) {
            std::vector<long double> truths;
            const std::size_t sample = std::clamp<std::size_t>(2'000'000 / size, 8, 400);
            for (std::size_t i = 0; i < sample; ++i)
                truths.push_back(true_distance(scene.flat, places[i * (places.size() / sample)]));
            for (Contender& contender : contenders) {
                contender.batch = batch_size(*contender.method, places, plan.batch_ms);
                contender.ns.clear();
            }
            for (int round = 0; round < plan.rounds; ++round)
                for (Contender& contender : contenders) {
                    const auto batch = batch_at(places, static_cast<std::size_t>(round), contender.batch);
                    const BusyClock clock;
                    keep(contender.method->ask(batch));
                    contender.ns.push_back(clock.ns() / static_cast<double>(batch.size()));
                }
            for (const Contender& it : contenders)
                rows.push_back({scene.name, size, kind, it.name, std::string(it.method->query()),
                                quantile(it.ns, 0.5), slow_ns(it, places, 50.0 * plan.batch_ms), it.build_ms,
                                it.method->bytes(), largest_error(*it.method, places, truths)});
        }
    }
    return rows;
}

} // namespace tp
