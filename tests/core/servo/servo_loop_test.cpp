// SPDX-License-Identifier: Apache-2.0
#include "core/servo/servo_loop.hpp"
#include "device_double.hpp"

#include <QTest>

using namespace tp;
using tp::testing::DeviceDouble;

namespace {

std::unique_ptr<const HapticScene> line_scene(double y, bool tour = false) {
    Scene scene{200.0, 150.0, {contour_through("line", {{-80.0, y}, {80.0, y}}, false)}};
    auto made = make_haptic_scene(scene);
    std::unique_ptr<HapticScene> haptic = std::move(made).value();
    if (tour)
        haptic->tour = haptic->flat.lines.front();
    return haptic;
}

struct Bench {
    DeviceDouble device;
    VirtualClock clock;
    ServoLoop loop{device, DeviceDouble::capabilities(), clock, ServoSettings{}};

    void run(double seconds) {
        const double end = clock.now() + seconds;
        while (clock.now() < end - 1e-9) {
            clock.sleep_until(clock.now() + 0.001);
            loop.tick();
        }
    }
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
        QCOMPARE(view.contour, 0);
        QCOMPARE(view.scene, std::uint64_t(1));
        QVERIFY(view.engaged);
        QCOMPARE(view.fault, Fault::none);
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

    void damps_across_the_line_and_not_along_it() {
        const auto force_at_speed = [](Vec2 velocity) {
            Bench bench;
            bench.device.place = [=](double now) { return Vec2(0.0, 1.0) + (now - 1.0) * velocity; };
            bench.loop.render(line_scene(0.0));
            bench.loop.engage();
            // far from the place until the last moment, so that the ramp is over
            auto place = bench.device.place;
            bench.device.place = [=](double now) { return now < 0.8 ? place(0.8) : place(now); };
            bench.run(1.0);
            return bench.device.last_force();
        };
        const Vec2 still = force_at_speed({0.0, 0.0});
        QVERIFY(length(force_at_speed({50.0, 0.0}) - still) < 1e-3);
        const double damped = force_at_speed({0.0, 50.0}).y - still.y;
        QVERIFY(std::abs(damped + 0.1677) < 0.01); // √(0.1 kg · 200 N/m) · (1 − 1/4) · 50 mm/s
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

QTEST_GUILESS_MAIN(ServoLoopTest)
#include "servo_loop_test.moc"
