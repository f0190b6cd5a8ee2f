// SPDX-License-Identifier: Apache-2.0
#include "core/servo/servo_loop.hpp"
#include "core/servo/watchdog.hpp"
#include "device_double.hpp"
#include "test_program.hpp"

#include <QScopeGuard>
#include <QTest>

#include <functional>
#include <thread>
#include <utility>

namespace watchdog_test {

using namespace tp;
using tp::testing::DeviceDouble;

namespace {

/// A loop in simulated time that pulls with 0.4 N, its watchdog called by hand.
struct Bench {
    DeviceDouble device;
    VirtualClock clock;
    ServoLoop loop{device, DeviceDouble::capabilities(), clock, ServoSettings{}};

    Bench() {
        device.place = [](double) { return Vec2(0.0, 2.0); };
        auto made = make_haptic_scene({200.0, 150.0, {contour_through("line", {{-80, 0}, {80, 0}}, false)}});
        loop.render(std::move(made).value());
        loop.engage();
        run(1.0);
    }
    void run(double seconds) {
        const double end = clock.now() + seconds;
        while (clock.now() < end - 1e-9) {
            clock.sleep_until(clock.now() + 0.001);
            loop.tick();
            loop.check();
        }
    }
    /// The loop hangs; only the watchdog lives.
    void hang(double seconds) {
        const double end = clock.now() + seconds;
        while (clock.now() < end - 1e-9) {
            clock.sleep_until(clock.now() + 0.001);
            loop.check();
        }
    }
    double force() const { return length(device.last_force()); }
};

/// A device that lets another thread have its turn in the middle of a read or a write, and counts whom it met
/// there.
class CrowdedDevice final : public ForceDevice {
public:
    std::function<void()> meanwhile = [] {};
    int met = 0;
    int written = 0;
    int halts = 0;
    bool obeys = false; ///< what was written last, not a halt
    Result<Capabilities> open() override { return DeviceDouble::capabilities(); }
    std::optional<DeviceState> read(double now) noexcept override {
        visit();
        return DeviceState{now, {0.0, 2.0}, 0};
    }
    bool write(const SafeForce&) noexcept override {
        ++written;
        visit();
        obeys = true;
        return true;
    }
    void halt() noexcept override {
        ++halts;
        obeys = false;
    }
    void stop() noexcept override {}
    bool motors_off() const noexcept override { return true; }

private:
    void visit() {
        if (inside_)
            ++met;
        else {
            inside_ = true;
            meanwhile();
            inside_ = false;
        }
    }
    bool inside_ = false;
};

/// A device whose read or write does not come back until it is told to.
class HangingDevice final : public ForceDevice {
public:
    std::atomic<bool> hang{false};
    std::atomic<bool> hang_reading{false};
    std::atomic<bool> inside{false};
    std::atomic<bool> halted{false};
    Result<Capabilities> open() override { return DeviceDouble::capabilities(); }
    std::optional<DeviceState> read(double now) noexcept override {
        wait_while(hang_reading);
        return DeviceState{now, {0.0, 2.0}, 0};
    }
    bool write(const SafeForce&) noexcept override {
        wait_while(hang);
        return true;
    }
    void halt() noexcept override { halted = true; }
    void stop() noexcept override {}

private:
    void wait_while(const std::atomic<bool>& told) {
        while (told) {
            inside = true;
            std::this_thread::yield();
        }
    }
};

} // namespace

class WatchdogTest : public QObject {
    Q_OBJECT
private slots:
    void a_ticking_loop_is_left_alone() {
        Bench bench;
        QVERIFY(std::abs(bench.force() - 0.4) < 1e-6);
        const std::size_t writes = bench.device.written.size();
        bench.run(0.1);
        QCOMPARE(bench.device.written.size(), writes + 100);
        QCOMPARE(bench.device.halts, 0);
    }

    void three_missed_ticks_are_ramped_to_zero_within_20_ms() {
        Bench bench;
        bench.hang(0.004);
        QVERIFY(bench.force() > 0.39);
        double last = bench.force();
        for (int i = 0; i < 20; ++i) {
            bench.hang(0.001);
            QVERIFY(bench.force() <= last);
            last = bench.force();
        }
        QVERIFY(bench.force() < 1e-9);
        QCOMPARE(bench.device.halts, 0);
        bench.run(0.001);
        QCOMPARE(bench.loop.snapshot().fault, Fault::late_ticks);
        QVERIFY(bench.force() < 1e-9);
        bench.run(1.0);
        QVERIFY(std::abs(bench.force() - 0.4) < 1e-6);
    }

    void a_loop_that_comes_back_halfway_goes_on_from_what_was_left() {
        Bench bench;
        bench.hang(0.014); // half of the ramp
        const double left = bench.force();
        QVERIFY(left > 0.1 && left < 0.3);
        bench.run(0.001);
        QVERIFY(bench.force() <= left);

        Bench other;
        other.hang(0.009); // a quarter of it
        QVERIFY(std::abs(other.force() - 0.3) < 1e-3);
        other.run(0.001); // 10 ms since its last tick: half of the chain's own ramp
        QVERIFY(std::abs(other.force() - 0.1) < 1e-3);
    }

    void a_loop_that_stands_still_for_50_ms_costs_it_the_device_until_engaged_again() {
        Bench bench;
        bench.hang(0.060);
        QCOMPARE(bench.device.halts, 1);
        bench.run(0.5);
        QCOMPARE(bench.loop.snapshot().fault, Fault::stalled);
        QVERIFY(bench.force() < 1e-9);
        bench.loop.disengage();
        bench.run(0.01);
        bench.loop.engage();
        bench.run(1.0);
        QVERIFY(std::abs(bench.force() - 0.4) < 1e-6);
    }

    /// Before the first force there is nothing to take away.
    void nothing_happens_before_the_first_write() {
        CrowdedDevice device;
        Watchdog watchdog(device, {});
        watchdog.check(5.0);
        QCOMPARE(device.written, 0);
        QCOMPARE(device.halts, 0);
        QVERIFY(!watchdog.halted());
        const Watchdog::Reading nothing_read;
        QVERIFY(!nothing_read.state && !nothing_read.lost && !nothing_read.motors_off);
    }

    void a_loop_that_has_ended_is_not_waited_for_until_it_writes_again() {
        CrowdedDevice device;
        Watchdog watchdog(device, {});
        watchdog.write(SafeForce{}, 1.0);
        watchdog.rest();
        watchdog.check(100.0);
        QCOMPARE(device.written, 1);
        QCOMPARE(device.halts, 0);
        QCOMPARE(watchdog.take_share_left(), 1.0);
        watchdog.write(SafeForce{}, 100.0);
        watchdog.check(101.0);
        QCOMPARE(device.halts, 1);
        watchdog.rest();
        QVERIFY(watchdog.halted()); // only a person's engaging forgets that
    }

    /// The loop hangs after a rest before it has written once: what is taken away is not the force of before.
    void a_force_from_before_a_rest_never_comes_again() {
        DeviceDouble device;
        Watchdog watchdog(device, {});
        SafetyChain chain(SafetyLimits{}, DeviceDouble::capabilities(), 0.001);
        SafetyInput input;
        input.fresh = true;
        input.force = {1.0, 0.0};
        chain.engage(0.0);
        for (int i = 0; i < 600; ++i) {
            input.now += 0.001;
            watchdog.write(chain.pass(input), input.now);
        }
        QVERIFY(device.last_force() != Vec2(0.0));
        watchdog.write(SafeForce{}, input.now);
        watchdog.write(chain.pass(input), input.now);
        watchdog.rest();
        watchdog.rearm(2.0);
        watchdog.check(2.015); // late, and not so late that it halts
        QVERIFY(!watchdog.halted());
        QVERIFY(device.last_force() == Vec2(0.0));
    }

    void what_was_read_before_a_rest_is_not_read_again() {
        CrowdedDevice device;
        Watchdog watchdog(device, {});
        QVERIFY(watchdog.read(1.0).motors_off);
        watchdog.rest();
        Watchdog::Reading reading{{}, true, true};
        device.meanwhile = [&] { reading = watchdog.read(2.0); }; // nobody may come to the device meanwhile
        watchdog.write(SafeForce{}, 2.0);
        QVERIFY(!reading.state && !reading.lost && !reading.motors_off);
    }

    void a_rest_forgets_what_it_has_taken_away() {
        CrowdedDevice device;
        Watchdog watchdog(device, {});
        watchdog.write(SafeForce{}, 1.0);
        watchdog.check(1.020);
        watchdog.rest();
        QCOMPARE(watchdog.take_share_left(), 1.0);
    }

    /// In parts of a power of two, which add up exactly.
    void each_of_its_times_is_the_last_moment_before_it_acts() {
        const auto share_after = [](double seconds, bool& halted) {
            CrowdedDevice device;
            Watchdog watchdog(device, {1.0 / 256.0, 1.0 / 16.0, 1.0 / 64.0});
            watchdog.write(SafeForce{}, 1.0);
            watchdog.check(1.0 + seconds);
            halted = device.halts > 0;
            const double share = watchdog.take_share_left();
            if (watchdog.take_share_left() != 1.0) // told once
                return -1.0;
            return share;
        };
        bool halted = false;
        QCOMPARE(share_after(1.0 / 256.0, halted), 1.0);
        QCOMPARE(share_after(1.0 / 256.0 + 1.0 / 256.0, halted), 0.75);
        QCOMPARE(share_after(1.0 / 256.0 + 3.0 / 256.0, halted), 0.25);
        QCOMPARE(share_after(1.0 / 16.0, halted), 0.0);
        QVERIFY(!halted);
        QCOMPARE(share_after(1.0 / 16.0 + 1e-9, halted), 0.0);
        QVERIFY(halted);
    }

    void by_itself_it_acts_after_4_ms_and_has_taken_all_within_20() {
        for (const auto& [seconds, share] : {std::pair{0.0039, 1.0},
                                             {0.009, 0.75},
                                             {0.014, 0.5},
                                             {0.0235, 0.025},
                                             {0.0241, 0.0},
                                             {0.049, 0.0}}) {
            CrowdedDevice device;
            Watchdog watchdog(device, {});
            watchdog.write(SafeForce{}, 0.0);
            watchdog.check(seconds);
            QVERIFY(std::abs(watchdog.take_share_left() - share) < 1e-9);
            QCOMPARE(device.halts, 0);
        }
    }

    /// The chain hears of the halt; a device that refused would be taken for unplugged.
    void once_it_has_halted_nothing_is_written_until_rearmed() {
        CrowdedDevice device;
        Watchdog watchdog(device, {});
        watchdog.write(SafeForce{}, 0.0);
        watchdog.check(0.051);
        QVERIFY(watchdog.halted());
        QVERIFY(watchdog.write(SafeForce{}, 0.052));
        watchdog.check(0.2);
        QCOMPARE(device.written, 1);
        QCOMPARE(device.halts, 1);
        watchdog.rearm(0.3);
        QCOMPARE(watchdog.take_share_left(), 1.0);
        watchdog.check(0.3039); // its time begins anew
        QVERIFY(watchdog.write(SafeForce{}, 0.304));
        QCOMPARE(device.written, 2);
        QCOMPARE(device.halts, 1);
    }

    void a_read_or_write_that_hangs_is_halted_by_the_other_thread_data() {
        QTest::addColumn<bool>("reading");
        QTest::newRow("read") << true;
        QTest::newRow("write") << false;
    }
    void a_read_or_write_that_hangs_is_halted_by_the_other_thread() {
        QFETCH(bool, reading);
        HangingDevice device;
        std::atomic<bool>& hang = reading ? device.hang_reading : device.hang;
        SteadyClock clock;
        ServoLoop loop(device, DeviceDouble::capabilities(), clock, ServoSettings{});
        loop.engage();
        loop.start();
        QTRY_VERIFY_WITH_TIMEOUT(loop.snapshot().ticks > 20, 20000);
        hang = true;
        const auto over = qScopeGuard([&] { hang = false; });
        QTRY_VERIFY_WITH_TIMEOUT(device.halted.load(), 20000);
        QVERIFY(device.inside);
        hang = false;
        QTRY_COMPARE_WITH_TIMEOUT(loop.snapshot().fault, Fault::stalled, 20000);
    }

    void a_watchdog_that_hangs_in_its_own_write_is_halted_by_the_loop() {
        HangingDevice device;
        Watchdog watchdog(device, {1.0 / 256.0, 1.0 / 16.0, 1.0 / 64.0});
        QVERIFY(watchdog.write(SafeForce{}, 0.0));
        device.hang = true;
        std::thread watch([&] { watchdog.check(1.0 / 64.0); });
        const auto over = qScopeGuard([&] {
            device.hang = false;
            watch.join();
        });
        QTRY_VERIFY_WITH_TIMEOUT(device.inside.load(), 20000);
        for (const double now : {0.016, 0.030, 1.0 / 64.0 + 1.0 / 16.0}) {
            QVERIFY(watchdog.write(SafeForce{}, now));
            QVERIFY(!device.halted && !watchdog.halted());
        }
        QVERIFY(watchdog.write(SafeForce{}, 0.079));
        QVERIFY(device.halted && watchdog.halted());
        QCOMPARE(watchdog.take_share_left(), 0.0);
    }

    void loop_and_watchdog_are_never_in_the_device_together() {
        CrowdedDevice device;
        Watchdog watchdog(device, {});
        QVERIFY(watchdog.write(SafeForce{}, 0.0));
        device.meanwhile = [&] {
            watchdog.check(0.010);
        }; // in the middle of the loop's read, then of its write
        QVERIFY(watchdog.read(0.001).state.has_value());
        QVERIFY(watchdog.write(SafeForce{}, 0.0));
        QCOMPARE(device.written, 2);

        Watchdog::Reading meanwhile;
        device.meanwhile = [&] { meanwhile = watchdog.read(0.010); }; // in the middle of the watchdog's write
        watchdog.check(0.010);
        QCOMPARE(device.written, 3);
        QVERIFY(!meanwhile.state);
        QVERIFY(meanwhile.motors_off); // as the device said last
        QCOMPARE(device.met, 0);
    }

    void a_force_written_while_the_other_side_halts_does_not_stay() {
        CrowdedDevice device;
        Watchdog watchdog(device, {});
        QVERIFY(watchdog.write(SafeForce{}, 0.0));
        QVERIFY(device.obeys);
        device.meanwhile = [&] { watchdog.check(0.100); }; // the loop comes back at the last moment
        QVERIFY(watchdog.write(SafeForce{}, 0.0));
        QVERIFY(watchdog.halted() && !device.obeys);

        watchdog.rearm(1.0);
        device.meanwhile = [&] { watchdog.write(SafeForce{}, 1.100); }; // the watchdog does
        watchdog.check(1.010);
        QVERIFY(watchdog.halted() && !device.obeys);
        QCOMPARE(device.met, 0);
        QCOMPARE(device.written, 3);
    }

    void a_loop_that_comes_back_in_the_moment_of_the_halt_is_told() {
        Bench bench;
        bool once = true;
        bench.device.place = [&](double) { // in the middle of a tick
            if (std::exchange(once, false)) {
                bench.clock.sleep_until(bench.clock.now() + 0.0495);
                bench.loop.check();
            }
            return Vec2(0.0, 2.0);
        };
        bench.clock.sleep_until(bench.clock.now() + 0.001);
        bench.loop.tick();
        QCOMPARE(bench.device.halts, 1);
        bench.clock.sleep_until(bench.clock.now() + 0.0003); // when its next period begins
        bench.loop.tick();
        bench.run(0.5);
        QCOMPARE(bench.loop.snapshot().fault, Fault::stalled);
        QVERIFY(!bench.loop.snapshot().engaged);
    }

    void makes_forces_smaller_and_never_larger() {
        Bench bench;
        bench.hang(0.030);
        for (const auto& [time, force] : bench.device.written)
            QVERIFY(length(force) <= 0.4 + 1e-9);
    }
};

} // namespace watchdog_test

TP_TEST(watchdog_test, WatchdogTest, event_loop)
#include "watchdog_test.moc"
