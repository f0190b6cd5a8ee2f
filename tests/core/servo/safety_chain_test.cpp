// SPDX-License-Identifier: Apache-2.0
#include "chain_bench.hpp"
#include "core/geometry/polyline.hpp"
#include "core/servo/safety_chain.hpp"
#include "device_double.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace tp;
using tp::testing::DeviceDouble;

class SafetyChainTest : public QObject {
    Q_OBJECT
private slots:
    void what_a_device_adds_comes_and_goes_with_the_ramp() {
        ChainBench bench;
        QCOMPARE(SafeForce().share(), 0.0);
        bench.input.force = Vec2(0.0); // even where the law wants nothing
        double last = 0.0;
        for (int i = 0; i < 600; ++i) {
            bench.input.now += 0.001;
            const SafeForce safe = bench.chain.pass(bench.input);
            QCOMPARE(safe.share(), bench.chain.gain());
            QCOMPARE(safe.scaled(0.5).share(), 0.5 * safe.share());
            QVERIFY(safe.share() - last < 0.0021);
            last = safe.share();
        }
        QCOMPARE(last, 1.0);
        QCOMPARE(bench.chain.pass(bench.input).scaled(0.25).share(), 0.25);
        QCOMPARE(bench.chain.pass(bench.input).scaled(1.0).share(), 1.0);
        QCOMPARE(bench.chain.pass(bench.input).scaled(7.0).share(), 1.0); // never larger
        QCOMPARE(bench.chain.pass(bench.input).scaled(std::numeric_limits<double>::quiet_NaN()).share(), 0.0);
        bench.chain.disengage();
        for (int i = 0; i < 21; ++i) {
            bench.input.now += 0.001;
            last = bench.chain.pass(bench.input).share();
        }
        QCOMPARE(last, 0.0);
    }

    void lets_the_force_in_by_a_ramp() {
        ChainBench bench;
        double last = 0.0;
        for (int i = 0; i < 480; ++i) {
            const double force = bench.tick().x;
            QVERIFY(force >= last && force - last < 0.0021);
            last = force;
        }
        QVERIFY(std::abs(bench.run(0.1).x - 1.0) < 1e-9);
        QCOMPARE(bench.chain.fault(), Fault::none);
    }

    void engaging_in_the_middle_of_a_touch_begins_from_no_force() {
        ChainBench bench;
        bench.run(1.0);
        bench.chain.engage(bench.input.now);
        QVERIFY(bench.tick(0.0) == Vec2(0.0));
        QVERIFY(bench.tick().x < 0.0021);
    }

    /// Nobody is told of a stall only because the device had been at rest.
    void engaging_after_any_time_begins_anew() {
        ChainBench bench;
        bench.chain.engage(100.0);
        bench.input.now = 100.0;
        bench.tick();
        QCOMPARE(bench.chain.fault(), Fault::none);
        QVERIFY(bench.run(1.0).x > 0.99);
    }

    void gives_nothing_before_it_is_engaged() {
        SafetyChain chain({}, DeviceDouble::capabilities(), 0.001);
        SafetyInput input;
        input.force = {1.0, 0.0};
        input.fresh = true;
        for (int i = 0; i < 1000; ++i) {
            input.now += 0.001;
            QVERIFY(chain.pass(input).newtons() == Vec2(0.0));
        }
    }

    void clamps_to_the_smallest_of_the_limits() {
        ChainBench bench;
        bench.input.force = {30.0, 40.0};
        QVERIFY(std::abs(length(bench.run(1.0)) - 1.5) < 1e-9);
        bench.chain.set_max_force(0.3);
        QVERIFY(std::abs(length(bench.run(1.0)) - 0.3) < 1e-9);
        bench.chain.set_max_force(100.0); // the device's own limit of 3 N holds
        QVERIFY(std::abs(length(bench.run(1.0)) - 3.0) < 1e-9);
        bench.chain.set_max_force(std::nan(""));
        QVERIFY(bench.run(0.2) == Vec2(0.0));
    }

    /// Nobody feels more than the limit, also where the law wants only a little more.
    void a_pull_just_above_the_limit_is_felt_as_the_limit() {
        for (const double wanted : {1.4999, 1.5001, 1.51, 1.6, 1.649, 3.0}) {
            ChainBench bench;
            bench.input.force = {0.0, wanted};
            QVERIFY(std::abs(bench.run(1.0).y - std::min(wanted, 1.5)) < 1e-9);
        }
    }

    void never_changes_the_force_faster_than_the_rate_limit() {
        ChainBench bench;
        bench.run(1.0);
        Vec2 last = bench.tick();
        for (int i = 0; i < 400; ++i) {
            bench.input.force = (i / 50) % 2 == 0 ? Vec2(-1.4, 0.3) : Vec2(1.4, -0.3);
            const Vec2 force = bench.tick();
            QVERIFY(length(force - last) <= 40.0 * 0.001 + 1e-12);
            last = force;
        }
    }

    /// As where a place that was wrong is told as the last one before the readings stop, and then the right
    /// one.
    void a_force_that_turns_round_during_a_fault_is_not_turned_at_once() {
        for (const Vec2 turned : {Vec2(-0.9, 0.0), Vec2(0.0, 0.9), Vec2(-0.3, 0.2)}) {
            ChainBench bench;
            bench.run(1.0);
            bench.input.fresh = false;
            while (bench.chain.fault() == Fault::none)
                bench.tick();
            QCOMPARE(bench.chain.fault(), Fault::stale_input);
            Vec2 last = bench.tick();
            QVERIFY(last.x > 0.5);
            bench.input.force = turned;
            for (int i = 0; i < 25; ++i) {
                const Vec2 force = bench.tick();
                const double share = std::clamp(glm::dot(force, last) / glm::dot(last, last), 0.0, 1.0);
                QVERIFY(length(force - (last == Vec2(0.0) ? last : share * last)) <= 40.0 * 0.001 + 1e-12);
                last = force;
            }
            QVERIFY(last == Vec2(0.0)); // and it is gone in time
        }
    }

    /// Whatever law, device, clock and person do: finite, within the limit, and never rising or turning
    /// faster than the rate limit.
    void any_input_keeps_the_limits() {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        const auto one_of = [&](const std::vector<double>& values) {
            return values[static_cast<std::size_t>(random() % values.size())];
        };
        const double nan = std::nan("");
        const double inf = std::numeric_limits<double>::infinity();
        for (int round = 0; round < 200; ++round) {
            ChainBench bench;
            Vec2 last(0.0);
            double felt = 0.0;
            for (int i = 0; i < 2000; ++i) {
                const bool wild = random() % 50 == 0;
                const double size = wild ? one_of({nan, inf, 1e308, -1e300, 1e-320, 0.0}) : 2.0;
                bench.input.force = {size * unit(random), size * unit(random)};
                const double far = random() % 200 == 0 ? one_of({nan, 1e9, 300.0}) : 50.0;
                bench.input.position = {far * unit(random), far * unit(random)};
                bench.input.velocity = {unit(random) * (random() % 200 == 0 ? 1e5 : 100.0), 0.0};
                bench.input.fresh = random() % 10 != 0;
                bench.input.device_lost = random() % 1000 == 0;
                if (random() % 100 == 0)
                    bench.chain.engage(bench.input.now);
                if (random() % 300 == 0)
                    bench.chain.disengage();
                const double dt = random() % 100 == 0 ? one_of({0.0, 0.0045, 0.03, 0.2, 1e-9}) : 0.001;
                const Vec2 force = bench.tick(dt);
                QVERIFY(is_finite(force));
                QVERIFY(length(force) <= 1.5 + 1e-12);
                QVERIFY(bench.chain.gain() > 0.0 || force == Vec2(0.0));
                const double allowed = 40.0 * std::min(dt, 0.003) + 1e-12;
                const bool calm =
                    bench.chain.fault() == Fault::none && bench.chain.engaged() && bench.chain.gain() > 0.0;
                const bool falls = length(force) <= length(last) + 1e-12;
                QVERIFY((falls && !calm) || length(force - last) <= allowed);
                QVERIFY(length(force - nearest_on_segment(Vec2(0.0), last, force)) <= allowed);
                felt = std::max(felt, length(force));
                last = force;
            }
            QVERIFY(round > 0 || felt > 0.01); // or nothing would have been tested
        }
    }

    /// A device whose reach is no rectangle: the finger may be wherever it reaches, and nowhere else.
    void a_workspace_of_any_shape_is_known_inside_and_out() {
        Capabilities can = DeviceDouble::capabilities();
        can.workspace = {{0, 0},   {90, 0},  {90, 60}, {60, 60},
                         {60, 30}, {30, 30}, {30, 90}, {0, 90}}; // like a U
        SafetyLimits limits;
        limits.workspace_margin = 1.0;
        const auto believed = [&](Vec2 position) {
            SafetyChain chain(limits, can, 0.001);
            SafetyInput input;
            input.fresh = true;
            input.position = position;
            chain.engage(0.0);
            chain.pass(input);
            return chain.fault() == Fault::none;
        };
        for (const Vec2 inside : {Vec2(10, 10), Vec2(15, 85), Vec2(45, 15), Vec2(80, 50), Vec2(80, 10),
                                  Vec2(-0.9, 45), Vec2(10, 30), Vec2(10, 60), Vec2(80, 30), Vec2(70, 30)})
            QVERIFY(believed(inside));
        for (const Vec2 outside :
             {Vec2(45, 45), Vec2(45, 80), Vec2(75, 75), Vec2(-2, 45), Vec2(100, 10), Vec2(45, -10),
              Vec2(15, 95), Vec2(-5, 30), Vec2(-5, 60), Vec2(45, 60), Vec2(-5, 0), Vec2(95, 30)})
            QVERIFY(!believed(outside));
        can.workspace.resize(2); // a device that tells no area is believed everywhere
        QVERIFY(believed({1e4, 1e4}));
        can.workspace = {{0, 0}, {90, 0}, {0, 90}};
        QVERIFY(believed({20, 20}) && !believed({80, 80}));
    }

    /// The hand holds what the watchdog has left: going on from more would be a jerk.
    void what_the_watchdog_took_away_comes_back_by_the_ramp() {
        ChainBench bench;
        bench.run(1.0);
        bench.chain.lowered_to(0.25);
        double last = 0.25;
        for (int i = 0; i < 370; ++i) {
            const double force = bench.tick().x;
            QVERIFY(force >= last && force - last < 0.0021);
            last = force;
        }
        QVERIFY(std::abs(bench.run(0.1).x - 1.0) < 1e-9);

        bench.chain.lowered_to(0.25);
        bench.input.force = {-1.0, 0.0}; // meanwhile the finger has crossed the line
        QVERIFY(std::abs(bench.tick().x - (0.25 - 0.040)) < 1e-9);
    }

    void letting_go_takes_the_force_away_within_20_ms() {
        ChainBench bench;
        bench.run(1.0);
        bench.chain.disengage();
        QVERIFY(bench.until_zero() <= 0.020 + 1e-9);
    }

    void after_a_rest_it_is_as_at_first_but_for_a_disabling_fault() {
        ChainBench bench, fresh;
        bench.run(1.0);
        bench.chain.rest();
        QVERIFY(!bench.chain.engaged() && bench.chain.gain() == 0.0);
        QVERIFY(bench.tick(50.0) == Vec2(0.0)); // it may have lasted
        QCOMPARE(bench.chain.fault(), Fault::none);
        bench.chain.engage(bench.input.now);
        for (int i = 0; i < 600; ++i)
            QVERIFY(length(bench.tick() - fresh.tick()) < 1e-9);

        bench.tick(0.1);
        QCOMPARE(bench.chain.fault(), Fault::stalled);
        bench.chain.rest();
        bench.run(1.0);
        QCOMPARE(bench.chain.fault(), Fault::stalled);
    }
};

QTEST_APPLESS_MAIN(SafetyChainTest)
#include "safety_chain_test.moc"
