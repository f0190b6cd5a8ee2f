// SPDX-License-Identifier: Apache-2.0
#include "core/servo/servo_loop.hpp"
#include "device_double.hpp"
#include "loop_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <sched.h>
#include <sys/prctl.h>
#include <thread>
#include <vector>

namespace servo_loop_test {

using namespace tp;
using tp::testing::DeviceDouble;
using tp::testing::line_scene;
using Bench = tp::testing::LoopBench;

namespace {

/// Time that moves on only where the loop's own thread works or sleeps.
class LoopClock final : public Clock {
public:
    double now() noexcept override { return now_.load(); }
    void sleep_until(double time) noexcept override {
        const bool loop = std::this_thread::get_id() == loop_.load();
        if (!loop) // time may have moved on since it was looked at
            watch_pause_.store(std::max(time - now_.load(), watch_pause_.load()));
        else
            now_.store(std::max(time, now_.load()));
        sched_param priority{};
        sched_getparam(0, &priority);
        (loop ? loop_priority_ : watch_priority_).store(priority.sched_priority);
        if (loop)
            slack_.store(prctl(PR_GET_TIMERSLACK));
        std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
    /// The calling thread is the loop's; its tick takes so many seconds.
    void work(double seconds) {
        loop_.store(std::this_thread::get_id());
        now_.store(now_.load() + seconds);
    }
    int loop_priority() const { return loop_priority_; }
    int slack() const { return slack_; }                   ///< ns by which the system may wake the loop later
    int watch_priority() const { return watch_priority_; } ///< -1 before it has slept
    double watch_pause() const { return watch_pause_; }    ///< s, the watchdog's longest

private:
    std::atomic<double> now_{0.0};
    std::atomic<std::thread::id> loop_{};
    std::atomic<int> loop_priority_{-1};
    std::atomic<int> watch_priority_{-1};
    std::atomic<int> slack_{-1};
    std::atomic<double> watch_pause_{0.0};
};

} // namespace

class ServoLoopTest : public QObject {
    Q_OBJECT
private slots:
    void pulls_the_finger_to_the_line() {
        Bench bench;
        bench.device.place = [](double) { return Vec2(10.0, 2.0); };
        bench.loop.render(line_scene(0.0));
        bench.loop.engage();
        bench.run(1.0);
        const ServoSnapshot view = bench.loop.snapshot();
        QVERIFY(length(bench.device.last_force() - Vec2(0.0, -0.4)) < 1e-6);
        QVERIFY(length(view.force() - Vec2(0.0, -0.4)) < 1e-6);
        QVERIFY(std::abs(view.distance - 2.0) < 1e-9);
        QVERIFY(std::abs(view.nearest_x - 10.0) < 1e-9 && std::abs(view.nearest_y) < 1e-9);
        QCOMPARE(view.contour, 0);
        QCOMPARE(view.scene, std::uint64_t(1));
        QVERIFY(view.engaged);
        QCOMPARE(view.fault, Fault::none);
    }

    void nothing_pulls_aside_while_the_first_scene_fades_in() {
        Bench bench;
        bench.device.place = [](double) { return Vec2(10.0, 2.0); };
        bench.loop.render(line_scene(0.0));
        bench.loop.engage();
        for (int i = 0; i < 200; ++i) {
            bench.run(0.001);
            QCOMPARE(bench.device.last_force().x, 0.0);
            QVERIFY(bench.device.last_force().y <= 0.0);
        }
    }

    void no_force_goes_to_a_device_that_has_told_no_place() {
        Bench bench;
        bench.device.silent = true;
        bench.loop.render(line_scene(2.0)); // 0.4 N at the origin
        bench.loop.engage();
        for (int i = 0; i < 50; ++i) {
            bench.run(0.001);
            QVERIFY(bench.device.last_force() == Vec2(0.0));
        }
    }

    void a_limit_that_is_lowered_holds_with_the_next_tick() {
        Bench bench;
        bench.device.place = [](double) { return Vec2(10.0, 4.0); };
        bench.loop.render(line_scene(0.0)); // 0.8 N
        bench.loop.engage();
        bench.run(1.0);
        bench.loop.set_max_force(0.1);
        for (int i = 0; i < 50; ++i) {
            bench.run(0.001);
            QVERIFY(length(bench.device.last_force()) <= 0.1 + 1e-12);
        }
    }

    void nothing_to_render_and_not_engaged_mean_no_force() {
        Bench bench;
        bench.device.place = [](double) { return Vec2(10.0, 2.0); };
        bench.loop.engage();
        bench.run(0.5);
        QVERIFY(bench.device.last_force() == Vec2(0.0));
        bench.loop.disengage();
        bench.loop.render(line_scene(0.0));
        bench.run(0.5);
        QVERIFY(bench.device.last_force() == Vec2(0.0));
        bench.loop.engage();
        bench.run(1.0);
        bench.loop.render(nullptr);
        bench.run(0.5);
        QVERIFY(bench.device.last_force() == Vec2(0.0));
    }

    void a_scene_swapped_in_mid_touch_fades_over() {
        Bench bench;
        bench.device.place = [](double) { return Vec2(0.0, 2.0); };
        bench.loop.render(line_scene(0.0)); // pulls down with 0.4 N
        bench.loop.engage();
        bench.run(1.0);
        bench.loop.render(line_scene(5.0)); // pulls up with 0.6 N
        Vec2 last = bench.device.last_force();
        for (int i = 0; i < 200; ++i) {
            bench.run(0.001);
            QVERIFY(length(bench.device.last_force() - last) < 0.02);
            last = bench.device.last_force();
            if (i == 40) // ms, of the fade's 80
                QVERIFY(std::abs(last.y - 0.1) < 0.03);
            if (i == 81)
                QVERIFY(std::abs(last.y - 0.6) < 1e-6);
        }
        QVERIFY(length(last - Vec2(0.0, 0.6)) < 1e-6);
        QCOMPARE(bench.loop.snapshot().scene, std::uint64_t(2));
    }

    void with_hysteresis_the_finger_keeps_its_line_until_the_other_is_clearly_nearer() {
        const Scene two{200.0,
                        150.0,
                        {contour_through("upper", {{-80.0, 3.0}, {80.0, 3.0}}, false),
                         contour_through("lower", {{-80.0, -3.0}, {80.0, -3.0}}, false)}};
        Bench bench;
        double y = 1.0;
        bench.device.place = [&](double) { return Vec2(0.0, y); };
        auto made = make_haptic_scene(two, {}, LawKind::exact, {0.4, 0.0, false});
        bench.loop.render(std::move(made).value());
        bench.loop.engage();
        bench.run(1.0);
        QCOMPARE(bench.loop.snapshot().contour, 0);
        y = -0.15;
        bench.run(0.5);
        QCOMPARE(bench.loop.snapshot().contour, 0);
        QVERIFY(bench.device.last_force().y > 0.5);
        y = -0.3;
        bench.run(0.5);
        QCOMPARE(bench.loop.snapshot().contour, 1);
        QVERIFY(bench.device.last_force().y < -0.5);
        bench.loop.render(line_scene(0.0)); // another scene knows of no branch
        bench.run(0.5);
        QCOMPARE(bench.loop.snapshot().contour, 0);
    }

    /// Without hysteresis the force goes by the place alone, also where two lines are equally near.
    void without_hysteresis_it_does_not_matter_where_the_finger_came_from() {
        const Scene two{200.0,
                        150.0,
                        {contour_through("upper", {{-80.0, 3.0}, {80.0, 3.0}}, false),
                         contour_through("lower", {{-80.0, -3.0}, {80.0, -3.0}}, false)}};
        const auto felt_between_coming_from = [&](double from) {
            Bench bench;
            double y = from;
            bench.device.place = [&](double) { return Vec2(0.0, y); };
            bench.loop.render(std::move(make_haptic_scene(two)).value());
            bench.run(0.010);
            y = 0.0;
            bench.run(0.010);
            return bench.loop.snapshot().contour;
        };
        QCOMPARE(felt_between_coming_from(1.0), felt_between_coming_from(-1.0));
    }

    /// K = 0.2 N/mm and 0.1 kg at 1 kHz: a quarter more than K (T/2 + T/4) = 0.1875 N·s/m at any speed, and
    /// 2·0.1·√(mK) = 0.894 N·s/m up to 20 mm/s.
    void damps_across_the_line_and_not_along_it() {
        const auto force_at_speed = [](Vec2 velocity, double distance = 1.0, double told = 0.0) {
            DeviceDouble device;
            VirtualClock clock;
            Capabilities can = DeviceDouble::capabilities();
            can.damping = told;
            ServoLoop loop(device, can, clock, ServoSettings{});
            // at rest until the ramp is over
            device.place = [=](double now) {
                return Vec2(0.0, distance) + (std::max(now, 0.8) - 1.0) * velocity;
            };
            loop.render(line_scene(0.0));
            loop.engage();
            for (int i = 1; i <= 1000; ++i) {
                clock.sleep_until(0.001 * i);
                loop.tick();
            }
            return device.last_force();
        };
        const auto damped_at = [&](double speed, double distance, double told = 0.0) {
            return force_at_speed({0.0, speed}, distance, told).y -
                   force_at_speed({0.0, 0.0}, distance, told).y;
        };
        QVERIFY(length(force_at_speed({50.0, 0.0}) - force_at_speed({0.0, 0.0})) < 1e-6);
        const double settling = 0.2 * std::sqrt(0.1 * 200.0);
        const double told = 0.1;
        const double leak = 0.1875 - told;
        QVERIFY(std::abs(damped_at(10.0, 1.0, told) + 0.010 * (leak + 0.75 * settling)) < 1e-4);
        QVERIFY(std::abs(damped_at(50.0, 1.0, told) + 0.050 * leak + 0.020 * 0.75 * settling) < 1e-4);
        QVERIFY(std::abs(damped_at(-50.0, 1.0, told) - 0.050 * leak - 0.020 * 0.75 * settling) < 1e-4);
        QVERIFY(std::abs(damped_at(50.0, 3.0, told) + 0.050 * leak * 0.5 + 0.020 * 0.25 * settling) < 1e-4);
        QVERIFY(std::abs(damped_at(50.0, 5.0, told)) < 1e-6); // no damping where the pull falls off
        // A device that damps enough by itself is given none but a slow swing's, and one that damps much none at all.
        QVERIFY(std::abs(damped_at(100.0, 1.0, 0.1875) + 0.020 * 0.75 * settling) < 1e-4);
        QVERIFY(std::abs(damped_at(100.0, 1.0, 0.3) + 0.020 * 0.75 * (settling + 0.1875 - 0.3)) < 1e-4);
        QVERIFY(std::abs(damped_at(100.0, 1.0, 1.2)) < 1e-6);
        // One that tells of none may be 4 ms later than it tells.
        QVERIFY(std::abs(damped_at(50.0, 1.0) + 0.050 * (0.1875 + 1.0) + 0.020 * 0.75 * settling) < 1e-4);
    }

    /// Above 40 N/s, which is K v at 200 mm/s: the law as it is where the finger is, in every tick.
    void the_spring_is_not_late_at_any_speed() {
        for (const double speed : {100.0, 300.0, 1000.0}) {
            DeviceDouble device;
            VirtualClock clock;
            Capabilities can = DeviceDouble::capabilities();
            can.damping = 5.0;
            ServoLoop loop(device, can, clock, ServoSettings{});
            double y = 3.5;
            device.place = [&](double) { return Vec2(0.0, y); };
            loop.render(line_scene(0.0));
            loop.engage();
            const auto tick = [&] {
                clock.sleep_until(clock.now() + 0.001);
                loop.tick();
            };
            for (int i = 0; i < 1000; ++i)
                tick();
            double velocity = 0.0;
            bool down = true;
            for (int i = 0; i < 1000; ++i) {
                velocity += std::clamp((down ? -speed : speed) - velocity, -300.0, 300.0);
                y += 0.001 * velocity;
                down = y < -2.5 ? false : y > 2.5 ? true : down;
                tick();
                const double exact =
                    std::abs(y) <= 4.0 ? -0.2 * y : std::copysign(0.2 * (8.0 - std::abs(y)), -y);
                QVERIFY(std::abs(device.last_force().y - exact) < 1e-9);
            }
            QCOMPARE(loop.snapshot().fault, Fault::none);
        }
    }

    /// 1.2 N turn round where the finger crosses from one line to the other.
    void another_contour_is_felt_by_the_rate() {
        const Scene two{200.0,
                        150.0,
                        {contour_through("upper", {{-80.0, 3.0}, {80.0, 3.0}}, false),
                         contour_through("lower", {{-80.0, -3.0}, {80.0, -3.0}}, false)}};
        Bench bench;
        double y = 1.0;
        bench.device.place = [&](double) { return Vec2(0.0, y); };
        bench.loop.render(std::move(make_haptic_scene(two)).value());
        bench.loop.engage();
        bench.run(1.0);
        double last = bench.device.last_force().y;
        double lowest = last;
        for (int i = 0; i < 60; ++i) {
            y -= 0.03; // 30 mm/s
            bench.run(0.001);
            const double force = bench.device.last_force().y;
            QVERIFY(std::abs(force - last) <= 0.040 + 0.2 * 0.03 + 0.002);
            last = force;
            lowest = std::min(lowest, force);
        }
        QVERIFY(lowest < -0.3);
    }

    /// The observer knows what the whole field should do, not what a ramp, a fade or a tour does.
    void what_sampling_leaks_is_paid_back_only_while_the_whole_field_is_felt() {
        struct Felt {
            double ramp = 0.0, whole = 0.0, fade = 0.0, tour = 0.0;
        };
        const auto felt = [](bool observer) {
            ServoSettings settings;
            settings.line_damping_ratio = 0.0;
            settings.energy_observer = observer;
            Capabilities can = DeviceDouble::capabilities();
            can.delay = 0.002;
            DeviceDouble device;
            VirtualClock clock;
            ServoLoop loop(device, can, clock, settings);
            device.place = [](double now) { return Vec2(0.0, 1.0 + std::sin(60.0 * now)); };
            const auto work = [&](double seconds) { // the sum of all forces tells one run from another
                double sum = 0.0;
                for (const double end = clock.now() + seconds; clock.now() < end - 1e-9;) {
                    clock.sleep_until(clock.now() + 0.001);
                    loop.tick();
                    sum += std::abs(device.last_force().y);
                }
                return sum;
            };
            Felt sums;
            loop.render(line_scene(0.0));
            work(0.2);
            loop.engage();
            sums.ramp = work(0.495);
            work(0.1);
            sums.whole = work(0.5);
            loop.render(nullptr); // which fades out
            work(0.2);
            loop.render(line_scene(0.5));
            sums.fade = work(0.075);
            loop.render(line_scene(0.0, true));
            work(0.2);
            sums.tour = work(0.5);
            return sums;
        };
        const Felt with = felt(ServoSettings{}.energy_observer);
        const Felt without = felt(false);
        QVERIFY(std::abs(with.whole - without.whole) > 0.1);
        QCOMPARE(with.ramp, without.ramp);
        QVERIFY(std::abs(with.fade - without.fade) < 1e-9);
        QVERIFY(std::abs(with.tour - without.tour) < 1e-9);
    }

    void the_watchdog_goes_before_the_loop_that_it_watches() {
        DeviceDouble device;
        LoopClock clock;
        device.place = [&](double) {
            clock.work(0.0001);
            return Vec2(0.0);
        };
        ServoLoop loop(device, DeviceDouble::capabilities(), clock, ServoSettings{});
        QVERIFY(!loop.real_time() && !loop.memory_locked() && !loop.running() &&
                loop.missed_periods() == 0); // not before there is a thread
        loop.start();
        QVERIFY(loop.running());
        QTRY_VERIFY_WITH_TIMEOUT(loop.snapshot().ticks > 0 && clock.watch_priority() >= 0, 20000);
        loop.stop();
        QVERIFY(clock.slack() <= 1);
        QVERIFY(clock.watch_pause() < 0.00101); // it looks every millisecond
        QCOMPARE(loop.real_time(), clock.loop_priority() > 0);
        if (!loop.real_time())
            QSKIP("The system gives no real-time priority here.");
        QCOMPARE(clock.loop_priority(), 20);
        QCOMPARE(clock.watch_priority(), 21);
    }

    /// A page that asks before the device has told anything.
    void a_silent_device_is_shown_as_at_rest() {
        Bench bench;
        bench.device.silent = true;
        bench.run(0.010);
        const ServoSnapshot view = bench.loop.snapshot();
        QVERIFY(view.finger() == Vec2(0.0) && view.force() == Vec2(0.0));
        QVERIFY(view.buttons == 0 && view.scene == 0 && view.contour == -1 && view.tour_progress == 0.0);
        QVERIFY(!view.engaged && !view.touring && !view.tour_finished);
        QCOMPARE(view.ticks, std::uint64_t(10));
    }

    void the_force_goes_back_through_the_transpose_of_the_calibration() {
        ServoSettings settings;
        settings.line_damping_ratio = 0.0;
        settings.device_to_surface = {glm::dmat2(0.0, 2.0, -1.0, 0.0),
                                      {3.0, 4.0}}; // turned, stretched, shifted
        DeviceDouble device;
        VirtualClock clock;
        ServoLoop loop(device, DeviceDouble::capabilities(), clock, settings);
        device.place = [](double) { return Vec2(-1.0, 5.0); }; // surface: (-5 + 3, -2 + 4) = (-2, 2)
        loop.render(line_scene(0.0));
        loop.engage();
        for (int i = 0; i < 1000; ++i) {
            clock.sleep_until(clock.now() + 0.001);
            loop.tick();
        }
        QVERIFY(length(loop.snapshot().finger() - Vec2(-2.0, 2.0)) < 1e-12);
        QVERIFY(length(loop.snapshot().force() - Vec2(0.0, -0.4)) < 1e-6);
        // A step of the device (1, 0) moves the finger by (0, 2): the work must be the same in both frames.
        QVERIFY(std::abs(device.last_force().x * 1.0 - (-0.4) * 2.0) < 1e-6);
    }

    void a_tour_leads_the_finger_and_says_when_it_has_finished() {
        Bench bench;
        Vec2 finger(-70.0, 3.0);
        bench.device.place = [&](double) {
            finger += 0.001 * 200.0 * bench.device.last_force();
            return finger;
        };
        bench.loop.render(line_scene(0.0, true));
        bench.loop.engage();
        double seconds = 0.0;
        while (!bench.loop.snapshot().tour_finished && seconds < 30.0) {
            bench.run(0.1);
            seconds += 0.1;
        }
        QVERIFY(bench.loop.snapshot().tour_finished);
        QVERIFY(length(finger - Vec2(80.0, 0.0)) < 3.0);
        QVERIFY(!bench.loop.snapshot().touring);
    }

    /// Whoever presses Escape in the middle of a tour finds it where it stopped.
    void a_tour_waits_while_the_force_is_off() {
        Bench bench;
        Vec2 finger(-80.0, 0.0);
        bench.device.place = [&](double) {
            finger += 0.001 * 200.0 * bench.device.last_force();
            return finger;
        };
        bench.loop.render(line_scene(0.0, true));
        bench.run(1.0);
        QCOMPARE(bench.loop.snapshot().tour_progress, 0.0);
        bench.loop.engage();
        bench.run(2.0);
        bench.loop.disengage();
        bench.run(0.050);
        const double reached = bench.loop.snapshot().tour_progress;
        QVERIFY(reached > 0.2 && reached < 0.5);
        QVERIFY(bench.loop.snapshot().touring && !bench.loop.snapshot().tour_finished);
        for (int i = 0; i < 100; ++i) {
            finger.x += 0.5; // the hand goes on by itself
            bench.run(0.010);
        }
        QCOMPARE(bench.loop.snapshot().tour_progress, reached);
        bench.loop.engage();
        bench.run(1.0);
        QVERIFY(bench.loop.snapshot().tour_progress > reached);
    }

    /// What a researcher reads as "no tick in so many periods", and nobody feels as a burst of ticks. No tick is so late
    /// that the watchdog touches the device, which a loop then leaves alone for a tick.
    void periods_that_a_busy_machine_missed_are_counted_and_not_made_up_for() {
        DeviceDouble device;
        LoopClock clock;
        std::vector<double> begun;
        device.place = [&](double now) {
            const std::size_t tick = begun.size();
            begun.push_back(now);
            clock.work(tick == 5 ? 0.0024 : tick == 9 ? 0.0012 : 0.0001);
            return Vec2(0.0);
        };
        ServoLoop loop(device, DeviceDouble::capabilities(), clock, ServoSettings{});
        loop.start();
        QTRY_VERIFY_WITH_TIMEOUT(loop.snapshot().ticks > 20, 20000);
        loop.stop();
        QCOMPARE(loop.missed_periods(), std::uint64_t(3)); // two in the sixth tick, one in the tenth
        const int period_of[] = {0, 1, 2, 3, 4, 5, 8, 9, 10, 11, 13, 14};
        for (std::size_t i = 0; i < std::size(period_of); ++i)
            QVERIFY(std::abs(begun[i] - 0.001 * period_of[i]) < 1e-9);
        QVERIFY(loop.lateness().max() < 1e-6); // each begins when its own period does
        QVERIFY(std::abs(loop.compute().max() - 0.0024) < 1e-9);
    }

    /// In parts of a power of two, which add up exactly.
    void a_tick_that_takes_its_whole_period_costs_no_other() {
        DeviceDouble device;
        LoopClock clock;
        const double period = 1.0 / 1024.0;
        std::vector<double> begun;
        device.place = [&](double now) {
            begun.push_back(now);
            clock.work(begun.size() % 3 == 0 ? period : 0.25 * period);
            return Vec2(0.0);
        };
        ServoSettings settings;
        settings.rate = 1024.0;
        ServoLoop loop(device, DeviceDouble::capabilities(), clock, settings);
        loop.start();
        QTRY_VERIFY_WITH_TIMEOUT(loop.snapshot().ticks > 20, 20000);
        loop.stop();
        QCOMPARE(loop.missed_periods(), std::uint64_t(0));
        for (std::size_t i = 0; i < 20; ++i)
            QCOMPARE(begun[i], period * static_cast<double>(i));
    }

    void unplugged_refusing_and_jumping_devices_end_in_zero_force() {
        for (const int what : {0, 1, 2}) {
            Bench bench;
            bench.device.place = [](double) { return Vec2(0.0, 2.0); };
            bench.loop.render(line_scene(0.0));
            bench.loop.engage();
            bench.run(1.0);
            if (what == 0)
                bench.device.unplugged = true;
            else if (what == 1)
                bench.device.refuses_writes = true;
            else
                bench.device.place = [](double) { return Vec2(50.0, 2.0); };
            bench.run(what == 2 ? 0.020 : 0.002);
            QVERIFY(bench.loop.snapshot().fault == (what == 2 ? Fault::over_speed : Fault::device_lost));
            QVERIFY(length(bench.device.last_force()) < 0.03);
        }
    }

    void its_thread_runs_and_stopping_leaves_zero_force() {
        DeviceDouble device;
        SteadyClock clock;
        device.place = [](double) { return Vec2(0.0, 2.0); };
        {
            ServoLoop loop(device, DeviceDouble::capabilities(), clock, ServoSettings{});
            loop.render(line_scene(0.0));
            loop.engage();
            loop.start();
            for (int i = 0; i < 50; ++i)
                loop.render(line_scene(i % 2 == 0 ? 1.0 : 0.0));
            QTRY_VERIFY_WITH_TIMEOUT(loop.snapshot().ticks > 200, 20000);
            QTRY_VERIFY_WITH_TIMEOUT(loop.snapshot().scene == 51, 20000);
        }
        QVERIFY(device.last_force() == Vec2(0.0));
        QVERIFY(device.stops >= 1);
    }
};

} // namespace servo_loop_test

TP_TEST(servo_loop_test, ServoLoopTest, event_loop)
#include "servo_loop_test.moc"
