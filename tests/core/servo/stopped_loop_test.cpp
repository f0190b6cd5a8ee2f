// SPDX-License-Identifier: Apache-2.0
// A loop that is stopped leaves no force, and one that goes on begins as at first.
#include "core/servo/servo_loop.hpp"
#include "device_double.hpp"
#include "loop_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstddef>
#include <cstdint>

namespace stopped_loop_test {

using namespace tp;
using tp::testing::DeviceDouble;
using tp::testing::line_scene;
using Bench = tp::testing::LoopBench;

class StoppedLoopTest : public QObject {
    Q_OBJECT

private slots:
    /// A page at rest: the loop is stopped, and started again when a finger comes.
    void a_stopped_loop_leaves_no_force_and_its_watchdog_lets_it_rest() {
        Bench bench;
        bench.device.place = [](double) { return Vec2(10.0, 2.0); };
        bench.loop.render(line_scene(0.0));
        bench.loop.engage();
        bench.run(1.0);
        bench.loop.stop();
        QVERIFY(bench.device.last_force() == Vec2(0.0));
        QCOMPARE(bench.device.stops, 1);
        const ServoSnapshot view = bench.loop.snapshot();
        QVERIFY(view.force() == Vec2(0.0) && view.gain == 0.0 && !view.engaged);
        QVERIFY(view.finger() == Vec2(10.0, 2.0));
        QCOMPARE(view.scene, std::uint64_t(1));
        const std::size_t writes = bench.device.written.size();
        for (int i = 0; i < 1000; ++i) {
            bench.clock.sleep_until(bench.clock.now() + 0.001);
            bench.loop.check();
        }
        QCOMPARE(bench.device.written.size(), writes);
        QCOMPARE(bench.device.halts, 0);
    }

    void a_loop_that_goes_on_lets_the_force_in_as_at_first() {
        const auto place = [](double) { return Vec2(10.0, 2.0); };
        Bench fresh, woken;
        for (Bench* bench : {&fresh, &woken}) {
            bench->device.place = place;
            bench->loop.render(line_scene(0.0));
            bench->loop.engage();
        }
        woken.run(1.0);
        woken.loop.stop();
        woken.clock.sleep_until(woken.clock.now() + 100.0);
        woken.loop.check();
        const std::size_t before = woken.device.written.size();
        for (int i = 0; i < 1000; ++i) {
            fresh.run(0.001);
            woken.run(0.001);
            woken.loop.check();
            QCOMPARE(woken.loop.snapshot().fault, Fault::none);
            if (i < 100) // a scene fades in once
                QVERIFY(length(woken.device.last_force()) < 0.4 * 0.002 * (i + 2));
            else
                QVERIFY(length(woken.device.last_force() - fresh.device.last_force()) < 1e-3);
        }
        QCOMPARE(woken.device.written.size(), before + 1000);
        QCOMPARE(woken.device.halts, 0);
        QVERIFY(length(woken.device.last_force() - Vec2(0.0, -0.4)) < 1e-6);
    }

    /// Whatever was on its way when it was stopped: what is felt from then on is the scene of now alone.
    void what_was_felt_before_is_not_felt_again() {
        const auto above_a_line = [](Bench& bench) {
            bench.device.place = [](double) { return Vec2(10.0, 2.0); };
            bench.loop.engage();
        };
        Bench settled, fading, fresh, changed;
        for (Bench* bench : {&settled, &fading, &fresh, &changed})
            above_a_line(*bench);
        settled.loop.render(line_scene(4.0)); // up to it
        settled.run(1.0);
        for (Bench* bench : {&fading, &changed}) {
            bench->loop.render(line_scene(0.0)); // down to it
            bench->run(1.0);
        }
        fading.loop.render(line_scene(4.0));
        fading.run(0.01); // half of the old force is still there
        for (Bench* bench : {&settled, &fading, &changed})
            bench->loop.stop();
        for (Bench* bench : {&fresh, &changed})
            bench->loop.render(line_scene(4.0)); // comes by its own fade
        for (int i = 0; i < 300; ++i) {
            for (Bench* bench : {&settled, &fading, &fresh, &changed})
                bench->run(0.001);
            QVERIFY(length(fading.device.last_force() - settled.device.last_force()) < 1e-9);
            QVERIFY(length(changed.device.last_force() - fresh.device.last_force()) < 1e-3);
            QVERIFY(changed.device.last_force().y >= 0.0 && fading.device.last_force().y >= 0.0);
        }
        QVERIFY(fading.device.last_force().y > 0.2);
    }

    /// Whoever has taken the finger elsewhere meanwhile is not too fast.
    void a_finger_that_was_set_down_elsewhere_meanwhile_has_not_moved() {
        Bench bench;
        bench.loop.render(line_scene(0.0));
        bench.loop.engage();
        bench.run(1.0);
        bench.loop.stop();
        bench.device.place = [](double) { return Vec2(60.0, 2.0); };
        for (int i = 0; i < 20; ++i) {
            bench.run(0.001);
            QCOMPARE(bench.loop.snapshot().fault, Fault::none);
        }
    }

    void who_has_taken_the_force_away_gets_none_from_a_loop_that_goes_on() {
        Bench bench;
        bench.device.place = [](double) { return Vec2(10.0, 2.0); };
        bench.loop.render(line_scene(0.0));
        bench.loop.engage();
        bench.run(1.0);
        bench.loop.stop();
        bench.loop.disengage();
        bench.run(1.0);
        QVERIFY(bench.device.last_force() == Vec2(0.0));
        QVERIFY(!bench.loop.snapshot().engaged);
    }

    void a_fault_that_disables_outlives_a_stop_until_a_person_engages_again() {
        Bench bench;
        bench.device.place = [](double) { return Vec2(10.0, 2.0); };
        bench.loop.render(line_scene(0.0));
        bench.loop.engage();
        bench.run(1.0);
        bench.device.unplugged = true;
        bench.run(0.001);
        bench.loop.stop(); // before a page has seen it
        QCOMPARE(bench.loop.snapshot().fault, Fault::device_lost);
        bench.device.unplugged = false;
        bench.run(1.0);
        QCOMPARE(bench.loop.snapshot().fault, Fault::device_lost);
        QVERIFY(bench.device.last_force() == Vec2(0.0));
        bench.loop.disengage();
        bench.run(0.001);
        bench.loop.engage();
        bench.run(1.0);
        QVERIFY(length(bench.device.last_force() - Vec2(0.0, -0.4)) < 1e-6);
    }

    void a_fault_that_heals_does_not_outlive_a_stop() {
        Bench bench;
        bench.loop.engage();
        bench.device.silent = true;
        bench.run(0.1);
        QCOMPARE(bench.loop.snapshot().fault, Fault::stale_input);
        bench.loop.stop();
        QCOMPARE(bench.loop.snapshot().fault, Fault::none);
        bench.run(0.019); // silent still, but not for long
        QCOMPARE(bench.loop.snapshot().fault, Fault::none);
        bench.run(0.003);
        QCOMPARE(bench.loop.snapshot().fault, Fault::stale_input);
    }

    void its_threads_end_and_come_again_with_the_scene_of_then() {
        DeviceDouble device;
        SteadyClock clock;
        device.place = [](double) { return Vec2(0.0, 2.0); };
        ServoSettings patient; // on a busy machine
        patient.limits.stall = 60.0;
        patient.limits.late_periods = 60'000.0;
        ServoLoop loop(device, DeviceDouble::capabilities(), clock, patient);
        loop.render(line_scene(0.0));
        loop.engage();
        for (std::uint64_t round = 1; round <= 20; ++round) {
            loop.start();
            const std::uint64_t before = loop.snapshot().ticks;
            QTRY_VERIFY_WITH_TIMEOUT(loop.snapshot().ticks > before + 5, 20000);
            QTRY_COMPARE_WITH_TIMEOUT(loop.snapshot().scene, round, 20000);
            QCOMPARE(loop.snapshot().fault, Fault::none);
            loop.stop();
            QVERIFY(!loop.running());
            QVERIFY(device.last_force() == Vec2(0.0));
            const std::uint64_t ticks = loop.snapshot().ticks;
            loop.render(line_scene(1.0));
            QCOMPARE(loop.snapshot().ticks, ticks);
        }
        QCOMPARE(device.halts, 0);
    }
};

} // namespace stopped_loop_test

TP_TEST(stopped_loop_test, StoppedLoopTest, event_loop)
#include "stopped_loop_test.moc"
