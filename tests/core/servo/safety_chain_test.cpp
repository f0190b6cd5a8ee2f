// SPDX-License-Identifier: Apache-2.0
#include "chain_bench.hpp"
#include "core/geometry/polyline.hpp"
#include "core/servo/safety_chain.hpp"
#include "device_double.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace safety_chain_test {

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

    /// A spring that lags behind the finger feeds it energy: 40 N/s is K · v at 80 mm/s and K = 0.5 N/mm.
    void a_change_that_the_motion_explains_passes_at_once() {
        for (const double speed : {20.0, 200.0, 1000.0}) { // mm/s
            ChainBench bench;
            bench.input.force = Vec2(0.0);
            bench.input.stiffness = 0.5;
            bench.run(1.0);
            double velocity = 0.0;
            for (int i = 0; i < 2000; ++i) { // to and fro, at no more than 300 m/s²
                const double wanted = (i / 40) % 2 == 0 ? speed : -speed;
                velocity += std::clamp(wanted - velocity, -300.0, 300.0);
                bench.input.position.x += 0.001 * velocity;
                bench.input.force.x = -0.5 * std::clamp(bench.input.position.x, -2.9, 2.9);
                QVERIFY(std::abs(bench.tick().x - bench.input.force.x) < 1e-12);
            }
            QVERIFY(bench.chain.fault() == Fault::none);
        }
    }

    /// Whatever the finger does meanwhile, what no motion explains goes at 40 N/s, and the spring is not late.
    void a_jump_on_a_moving_finger_is_slowed_and_the_spring_beneath_it_is_not() {
        ChainBench bench;
        bench.input.force = Vec2(0.0);
        bench.input.stiffness = 0.2;
        bench.run(1.0);
        double offset = 0.0;
        for (int i = 0; i < 200; ++i) {
            bench.input.position.x = 2.0 * std::sin(0.05 * i); // 100 mm/s
            const double spring = -0.2 * bench.input.position.x;
            const double jump = i >= 50 ? 0.9 : 0.0; // N, as of another scene
            bench.input.force.x = spring + jump;
            if (i == 50)
                offset = -0.9;
            offset = std::min(0.0, offset + 0.040);
            const double force = bench.tick().x;
            // At the jump itself the spring's own change may be taken for part of it, either way.
            QVERIFY(std::abs(force - (spring + jump + offset)) <=
                    (i < 50 || i > 75 ? 1e-12 : 0.2 * 0.1 * 2.0));
        }
    }

    /// A step may hide in a motion only as far as the spring itself would have changed.
    void a_jump_is_bounded_by_the_rate_and_by_the_motion() {
        ChainBench bench;
        bench.input.stiffness = 0.3;
        bench.run(1.0);
        Vec2 last = bench.tick();
        for (int i = 0; i < 400; ++i) {
            const Vec2 step(0.05 * std::cos(0.1 * i), 0.05 * std::sin(0.1 * i));
            bench.input.position += step;
            bench.input.force = (i / 50) % 2 == 0 ? Vec2(-1.4, 0.3) : Vec2(1.4, -0.3);
            const Vec2 force = bench.tick();
            QVERIFY(length(force - last) <= 40.0 * 0.001 + 0.3 * length(step) + 1e-12);
            last = force;
        }
    }

    /// A counter that slipped, one reading beside all others: no hand moves so, and no force goes with it.
    void a_reading_that_jumps_explains_no_jump_of_the_force() {
        ChainBench bench;
        bench.input.stiffness = 0.2;
        bench.input.force = Vec2(0.0);
        bench.run(1.0);
        Vec2 last(0.0);
        for (int i = 0; i < 20; ++i) {
            bench.input.position.x = i == 10 ? 4.0 : 0.0;
            bench.input.force.x = i == 10 ? -0.8 : 0.0;
            const Vec2 force = bench.tick();
            QVERIFY(length(force - last) <= 0.040 + 0.2 * 0.4 + 1e-12); // 400 m/s² for a millisecond
            last = force;
        }
        QVERIFY(last == Vec2(0.0));
    }

    void nothing_is_explained_without_a_fresh_reading_or_by_a_law_that_claims_too_much() {
        for (const double claimed : {0.0, -5.0, std::nan(""), 1e9, std::numeric_limits<double>::infinity()}) {
            ChainBench bench;
            bench.run(1.0);
            bench.input.stiffness = claimed;
            bench.input.position.x += 0.1;
            bench.input.force.x = -1.0;
            const double step = 1.0 - bench.tick().x;
            QVERIFY(step <= 0.040 + (claimed > 0.0 ? 3.0 * 0.1 : 0.0) + 1e-12);
            bench.input.stiffness = 3.0;
            bench.input.fresh = false;
            const double before = bench.tick().x;
            bench.input.position.x += 0.1; // an old reading, told again as another
            QVERIFY(before - bench.tick().x <= 0.040 + 1e-12);
        }
    }

    void a_lowered_limit_holds_with_the_next_tick() {
        ChainBench bench;
        bench.input.force = {30.0, 40.0};
        QVERIFY(std::abs(length(bench.run(1.0)) - 1.5) < 1e-9);
        bench.chain.set_max_force(0.1);
        for (int i = 0; i < 50; ++i)
            QVERIFY(length(bench.tick() - 0.1 * Vec2(0.6, 0.8)) < 1e-12);
        bench.chain.set_max_force(1.5); // and a raised one comes at the rate
        QVERIFY(std::abs(length(bench.tick()) - 0.140) < 1e-9);
    }

    /// A law asked for the origin, before the device has told a place, would pull there.
    void gives_nothing_before_the_first_reading() {
        ChainBench bench;
        bench.input.fresh = false;
        for (int i = 0; i < 100; ++i)
            QVERIFY(bench.tick() == Vec2(0.0));
        QCOMPARE(bench.chain.fault(), Fault::stale_input);
        bench.input.fresh = true;
        QVERIFY(bench.run(0.010).x < 0.021); // by the ramp
        QVERIFY(bench.run(1.0).x > 0.99);
    }

    /// The same with motion that explains: never more than the rate and the spring over the way allow, by the
    /// numbers of the limits.
    void any_input_that_moves_keeps_the_limits() {
        std::mt19937_64 random(6);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        const auto one_of = [&](const std::vector<double>& values) {
            return values[static_cast<std::size_t>(random() % values.size())];
        };
        const double nan = std::nan("");
        double most = 0.0;
        for (int round = 0; round < 200; ++round) {
            ChainBench bench;
            Vec2 last(0.0);
            Vec2 last_place(0.0);
            double last_fresh = -1.0;
            double limit = 1.5;
            for (int i = 0; i < 2000; ++i) {
                const bool wild = random() % 50 == 0;
                const double size = wild ? one_of({nan, 1e308, 0.0}) : 2.0;
                bench.input.force = {size * unit(random), size * unit(random)};
                const double far = random() % 100 == 0 ? 40.0 : 0.5;
                bench.input.position = glm::clamp(
                    bench.input.position + far * Vec2(unit(random), unit(random)), Vec2(-60.0), Vec2(60.0));
                bench.input.fresh = random() % 5 != 0;
                bench.input.stiffness = one_of({0.0, 0.2, 0.5, 1e6, nan, -1.0});
                bench.input.motors_off = random() % 1000 == 0;
                if (random() % 200 == 0)
                    bench.chain.engage(bench.input.now);
                if (random() % 500 == 0)
                    bench.chain.set_max_force(limit = one_of({0.1, 0.7, 1.5}));
                const double dt = random() % 100 == 0 ? one_of({0.0, 0.0045, 0.015, 1e-9}) : 0.001;
                const Vec2 force = bench.tick(dt);
                const double since = bench.input.now - last_fresh;
                double explained = 0.0;
                if (bench.input.fresh && last_fresh >= 0.0) {
                    const double stiffness =
                        bench.input.stiffness > 0.0 ? std::min(bench.input.stiffness, 3.0) : 0.0;
                    const double way = std::min(length(bench.input.position - last_place), 1500.0 * since);
                    explained = stiffness * way;
                }
                if (bench.input.fresh && (dt > 0.0 || last_fresh < 0.0)) {
                    last_place = bench.input.position;
                    last_fresh = bench.input.now;
                }
                QVERIFY(is_finite(force));
                QVERIFY(length(force) <= limit + 1e-12);
                const bool calm =
                    bench.chain.fault() == Fault::none && bench.chain.engaged() && bench.chain.gain() > 0.0;
                const double allowed = 40.0 * std::min(dt, 0.003) + (calm ? explained : 0.0) + 1e-12;
                // Where the limit was lowered the force is shorter, and no more than that.
                const Vec2 from = length(last) > limit ? (limit / length(last)) * last : last;
                if (calm)
                    QVERIFY(length(force - from) <= allowed);
                QVERIFY(length(force - nearest_on_segment(Vec2(0.0), from, force)) <= allowed);
                most = std::max(most, length(force - last));
                last = force;
            }
        }
        QVERIFY(most > 0.2); // or nothing would have been explained
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

} // namespace safety_chain_test

TP_TEST(safety_chain_test, SafetyChainTest, nothing)
#include "safety_chain_test.moc"
