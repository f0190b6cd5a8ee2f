// SPDX-License-Identifier: Apache-2.0
#include "chain_bench.hpp"
#include "core/servo/safety_chain.hpp"
#include "device_double.hpp"
#include "test_program.hpp"

#include <QTest>

#include <limits>
#include <set>
#include <string>
#include <utility>

namespace chain_faults_test {

using namespace tp;
using tp::testing::DeviceDouble;

/// What the chain finds wrong, what it does then, and how it comes back.
class ChainFaultsTest : public QObject {
    Q_OBJECT
private slots:
    void nothing_is_wrong_before_the_first_reading_is_due() {
        SafetyChain chain({}, DeviceDouble::capabilities(), 0.001);
        SafetyInput input;
        input.now = 100.0;
        chain.pass(input);
        QCOMPARE(chain.fault(), Fault::none);
        input.now += 0.001;
        chain.pass(input);
        QCOMPARE(chain.fault(), Fault::none);
    }

    void a_device_that_tells_nothing_of_itself_gets_no_force() {
        const Capabilities can;
        QVERIFY(can.max_force == 0.0 && can.continuous_force == 0.0 && can.resolution == 0.0 &&
                can.delay == 0.0);
        QVERIFY(!can.calibrated);
        SafetyChain chain({}, can, 0.001);
        chain.engage(0.0);
        SafetyInput input;
        input.force = {1.0, 0.0};
        for (int i = 0; i < 1000; ++i) {
            input.now += 0.001;
            input.fresh = true;
            QVERIFY(chain.pass(input).newtons() == Vec2(0.0));
        }
    }

    void not_a_number_in_means_no_force_at_once() {
        const double nan = std::nan("");
        for (const Vec2 bad : {Vec2(nan, 0.0), Vec2(0.0, std::numeric_limits<double>::infinity())}) {
            ChainBench bench;
            bench.run(1.0);
            bench.input.force = bad;
            QVERIFY(bench.tick() == Vec2(0.0));
            QCOMPARE(bench.chain.fault(), Fault::not_a_number);
            bench.input.force = {1.0, 0.0};
            bench.input.position = bad;
            QVERIFY(bench.tick() == Vec2(0.0));
            QCOMPARE(bench.chain.fault(), Fault::not_a_number);
            bench.input.position = {0.0, 0.0};
            bench.run(1.0);
            bench.input.velocity = bad;
            QVERIFY(bench.until_zero() <= 0.020 + 1e-9);
            QCOMPARE(bench.chain.fault(), Fault::not_a_number);
            bench.input.velocity = {0.0, 0.0};
            QVERIFY(bench.run(1.0).x > 0.99); // heals
        }
    }

    void stale_input_is_ramped_to_zero() {
        ChainBench bench;
        bench.run(1.0);
        bench.input.fresh = false;
        double t = 0.0;
        while (bench.chain.fault() == Fault::none && t < 1.0) {
            bench.tick();
            t += 0.001;
        }
        QCOMPARE(bench.chain.fault(), Fault::stale_input);
        QVERIFY(t <= 0.0225);
        QVERIFY(bench.until_zero() <= 0.020 + 1e-9);
    }

    void a_late_loop_is_ramped_to_zero_and_comes_back() {
        ChainBench bench;
        bench.run(1.0);
        bench.tick(0.010);
        QCOMPARE(bench.chain.fault(), Fault::late_ticks);
        QVERIFY(bench.tick().x < 0.6);
        QVERIFY(bench.run(1.0).x > 0.99);
    }

    /// At a limit nothing is wrong yet; beyond it something is. In parts of a power of two, which add up
    /// exactly.
    void each_limit_is_the_last_value_that_is_let_through() {
        SafetyLimits limits;
        limits.max_speed = 1024.0;
        limits.stale_after = 0.03125;
        limits.stall = 0.0625;
        limits.workspace_margin = 4.0;
        const double period = 1.0 / 1024.0;
        const auto fault_of = [&](double elapsed, const SafetyInput& changed, double stale = 0.0) {
            SafetyChain chain(limits, DeviceDouble::capabilities(), period);
            SafetyInput input;
            input.fresh = true;
            chain.engage(0.0);
            for (double t = period; t <= stale; t += period) {
                SafetyInput silent;
                silent.now = t;
                chain.pass(silent);
                input.now = t;
                input.fresh = false;
            }
            SafetyInput last = changed;
            last.now = input.now + elapsed;
            last.fresh = input.fresh;
            chain.pass(last);
            return chain.fault();
        };
        const double next = 1e-9;
        SafetyInput calm;
        QCOMPARE(fault_of(4.0 * period, calm), Fault::none);
        QCOMPARE(fault_of(4.0 * period + next, calm), Fault::late_ticks);
        QCOMPARE(fault_of(limits.stall, calm), Fault::late_ticks);
        QCOMPARE(fault_of(limits.stall + next, calm), Fault::stalled);
        QCOMPARE(fault_of(period, calm, limits.stale_after - period), Fault::none);
        QCOMPARE(fault_of(period + next, calm, limits.stale_after - period), Fault::stale_input);
        SafetyInput fast;
        fast.velocity = {0.0, 1024.0};
        QCOMPARE(fault_of(period, fast), Fault::none);
        fast.velocity = {0.0, 1024.001};
        QCOMPARE(fault_of(period, fast), Fault::over_speed);
        for (const auto& [x, y] : {std::pair{104.0, 10.0}, {-104.0, 10.0}, {10.0, 79.0}, {10.0, -79.0}}) {
            SafetyInput far;
            far.position = {x, y};
            QCOMPARE(fault_of(period, far), Fault::none);
            far.position *= 1.001;
            QCOMPARE(fault_of(period, far), Fault::outside_workspace);
        }
    }

    /// A tick between 4 and 50 ms late is forgiven; a longer one costs the device.
    void only_a_loop_that_stood_still_for_50_ms_must_be_engaged_again() {
        for (const double late : {0.0045, 0.030, 0.049, 0.051}) {
            ChainBench bench;
            bench.run(1.0);
            bench.tick(late);
            QCOMPARE(bench.chain.fault(), late < 0.050 ? Fault::late_ticks : Fault::stalled);
        }
    }

    void a_tick_100_ms_late_disables_the_device_until_it_is_engaged_again() {
        ChainBench bench;
        bench.run(1.0);
        QVERIFY(bench.tick(0.100) == Vec2(0.0));
        QCOMPARE(bench.chain.fault(), Fault::stalled);
        QVERIFY(!bench.chain.engaged());
        QVERIFY(bench.run(1.0) == Vec2(0.0));
        QCOMPARE(bench.chain.fault(), Fault::stalled);
        bench.chain.engage(bench.input.now);
        QVERIFY(bench.run(1.0).x > 0.99);
    }

    void over_speed_and_a_place_outside_are_ramped_to_zero_and_heal() {
        ChainBench bench;
        bench.run(1.0);
        bench.input.velocity = {2000.0, 0.0};
        bench.tick();
        QCOMPARE(bench.chain.fault(), Fault::over_speed);
        QVERIFY(bench.until_zero() <= 0.020 + 1e-9);
        bench.input.velocity = {100.0, 0.0};
        bench.run(1.0);
        bench.input.position = {104.0, 0.0}; // within the margin
        QVERIFY(bench.tick().x > 0.9);
        bench.input.position = {106.0, 0.0};
        bench.tick();
        QCOMPARE(bench.chain.fault(), Fault::outside_workspace);
        QVERIFY(bench.until_zero() <= 0.020 + 1e-9);
        bench.input.position = {0.0, 0.0};
        QVERIFY(bench.run(1.0).x > 0.99);
    }

    void a_lost_device_gets_nothing_more() {
        ChainBench bench;
        bench.run(1.0);
        bench.input.device_lost = true;
        QVERIFY(bench.tick() == Vec2(0.0));
        QCOMPARE(bench.chain.fault(), Fault::device_lost);
        bench.input.device_lost = false;
        QVERIFY(bench.run(1.0) == Vec2(0.0));
    }

    void motors_that_the_device_switched_off_come_back_by_the_ramp() {
        ChainBench bench;
        bench.run(1.0);
        bench.input.motors_off = true;
        QVERIFY(bench.until_zero() <= 0.020 + 1e-9);
        QCOMPARE(bench.chain.fault(), Fault::motors_off);
        bench.input.motors_off = false;
        QVERIFY(bench.run(0.1).x < 0.25);
        QCOMPARE(bench.chain.fault(), Fault::none);
        QVERIFY(bench.run(0.5).x > 0.99);
    }

    void every_fault_has_a_sentence_of_its_own() {
        std::set<std::string> sentences;
        for (const Fault fault :
             {Fault::not_a_number, Fault::outside_workspace, Fault::over_speed, Fault::motors_off,
              Fault::stale_input, Fault::late_ticks, Fault::stalled, Fault::device_lost}) {
            const std::string text = sentence(fault);
            QVERIFY(text.size() > 20 && text.back() == '.');
            sentences.insert(text);
        }
        QCOMPARE(sentences.size(), std::size_t(8));
        QCOMPARE(std::string(sentence(Fault::none)), std::string());
    }
};

} // namespace chain_faults_test

TP_TEST(chain_faults_test, ChainFaultsTest, nothing)
#include "chain_faults_test.moc"
