// SPDX-License-Identifier: Apache-2.0
#include "core/touch/touch_loop.hpp"
#include "device/touch_output/drawn/drawn_touch.hpp"

#include <QTest>

#include <cmath>
#include <limits>
#include <vector>

using namespace tp;

namespace {

struct Heard final : TickListener {
    std::vector<std::pair<Tick, double>> ticks;
    int hushes = 0;
    bool listens = false;
    void begin() override { listens = true; }
    void end() override { listens = false; }
    void ticked(const Tick& tick, double time) noexcept override { ticks.emplace_back(tick, time); }
    void hush() noexcept override { ++hushes; }
};

/// Where the finger is once the hand has gone 20 mm to the right at 100 mm/s.
double finger_after_a_way(DrawnTouch& touch, double level) {
    touch.set_down({0.0, 0.0});
    double time = 0.0;
    for (int i = 0; i <= 200; ++i, time += 0.001) {
        touch.move_hand({0.1 * i, 0.0});
        touch.read(time);
        touch.resist(level);
    }
    return touch.read(time)->place.x;
}

} // namespace

class DrawnTouchTest : public QObject {
    Q_OBJECT
private slots:
    void friction_makes_the_finger_lag_and_no_friction_lets_it_follow() {
        const auto lag = [](double level) {
            DrawnTouch touch(200.0, 150.0, nullptr);
            return 20.0 - finger_after_a_way(touch, level);
        };
        QVERIFY(lag(0.0) < 1.0);
        QVERIFY(lag(0.3) > lag(0.0) + 2.0);
        QVERIFY(lag(1.0) > lag(0.3) + 4.0);
        QCOMPARE(lag(5.0), lag(1.0));
        QCOMPARE(lag(std::numeric_limits<double>::quiet_NaN()), lag(0.0));
    }

    void a_finger_joysticks_behind_a_resting_hand_by_the_dry_friction_alone() {
        BrakedFinger finger;
        for (int i = 0; i < 10'000; ++i)
            finger.step({100.0, 0.0}, 0.5, 0.001);
        QVERIFY(std::abs(finger.place.x - (100.0 - finger.slack_mm(0.5))) < 1e-6);
        finger.step({100.0, 0.0}, 1.0, 1.0);
        QVERIFY(std::abs(finger.place.x - (100.0 - finger.slack_mm(0.5))) < 1e-6);
    }

    void a_step_of_any_length_is_the_same_as_many_short_ones() {
        BrakedFinger once, often;
        once.step({30.0, 40.0}, 0.4, 0.05);
        for (int i = 0; i < 50; ++i)
            often.step({30.0, 40.0}, 0.4, 0.001);
        QVERIFY(length(once.place - often.place) < 1e-9);
    }

    void friction_ends_by_itself_and_by_halt() {
        DrawnTouch touch(200.0, 150.0, nullptr);
        const double behind = 20.0 - finger_after_a_way(touch, 1.0);
        QVERIFY(20.0 - touch.read(0.25)->place.x > BrakedFinger{}.slack_mm(1.0) - 1e-9);
        QVERIFY(20.0 - touch.read(0.5)->place.x < 0.1);
        QVERIFY(20.0 - finger_after_a_way(touch, 1.0) > 5.0);
        touch.halt();
        QVERIFY(20.0 - touch.read(0.26)->place.x < 0.5 * behind);
    }

    void set_down_elsewhere_it_is_there_at_once_and_lifted_it_is_up() {
        DrawnTouch touch(200.0, 150.0, nullptr);
        touch.set_down({10.0, 5.0});
        touch.read(0.0);
        QVERIFY(touch.read(0.001)->touched);
        touch.set_down({-50.0, 5.0});
        const PadTouch between = *touch.read(0.002);
        QVERIFY(between.place == Vec2(-50.0, 5.0) && !between.touched);
        QVERIFY(touch.read(0.003)->touched);
        touch.lift();
        QVERIFY(!touch.read(0.004)->touched);
    }

    void no_hand_is_outside_of_the_surface_or_nowhere() {
        DrawnTouch touch(200.0, 150.0, nullptr);
        touch.set_down({500.0, -500.0});
        QVERIFY(touch.read(0.0)->place == Vec2(100.0, -75.0));
        touch.set_down({std::numeric_limits<double>::quiet_NaN(), 0.0});
        QVERIFY(touch.read(0.001)->place == Vec2(100.0, -75.0));
    }

    void ticks_are_told_with_their_time_and_hushed() {
        const auto heard = std::make_shared<Heard>();
        DrawnTouch touch(200.0, 150.0, heard);
        touch.read(3.0);
        QVERIFY(touch.tick({0.5, 0.5, 0.01}));
        touch.tick({});
        QCOMPARE(heard->ticks.size(), std::size_t(1));
        QVERIFY(heard->ticks[0].first == Tick(0.5, 0.5, 0.01));
        QCOMPARE(heard->ticks[0].second, 3.0);
        touch.halt();
        QCOMPARE(heard->hushes, 1);
        QVERIFY(touch.open());
        QVERIFY(heard->listens);
        touch.stop();
        QVERIFY(!heard->listens);
        QCOMPARE(heard->hushes, 2);
    }

    void through_the_loop_a_line_brakes_and_ticks() {
        const auto heard = std::make_shared<Heard>();
        DrawnTouch touch(200.0, 150.0, heard);
        const TouchCapabilities can = touch.open().value();
        VirtualClock clock;
        TouchLoop loop(touch, can, clock, {});
        FlatScene scene;
        scene.names = {"line"};
        scene.lines = {Polyline{{{0.0, -50.0}, {0.0, 50.0}}, false}};
        loop.render(make_touch_scene(scene).value());
        loop.engage();
        touch.set_down({-20.0, 0.0});
        double beside = 0.0, on_it = 0.0;
        for (int i = 0; i < 400; ++i) {
            clock.sleep_until(clock.now() + loop.period());
            const double hand = -20.0 + 0.1 * i;
            touch.move_hand({hand, 0.0});
            loop.tick();
            const double finger = loop.snapshot().x;
            double& lag = std::abs(finger) < 0.5 ? on_it : beside;
            if (std::abs(finger) < 0.5 || finger < -2.0)
                lag = std::max(lag, hand - finger);
        }
        QVERIFY(on_it > beside + 2.0);
        QCOMPARE(heard->ticks.size(), std::size_t(1));
    }
};

QTEST_APPLESS_MAIN(DrawnTouchTest)
#include "drawn_touch_test.moc"
