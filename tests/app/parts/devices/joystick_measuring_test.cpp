// SPDX-License-Identifier: Apache-2.0
#include "../../../device/hid_pid/joystick_bench.hpp"
#include "app/parts/devices/calibration_steps.hpp"
#include "app/parts/devices/joystick_measuring.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

namespace joystick_measuring_test {

using namespace tp;
using tp::testing::JoystickBench;
using tp::testing::sidewinder;
using Step = JoystickTrial::Step;

namespace {

struct OfAStick {
    double newtons_at_full = 8.0;
    Vec2 sign{-1.0, -1.0};
    JoystickWire wire = open_controller();
    double friction = 0.02; ///< N
    unsigned delay_ms = 4;
};

HandlePlant plant_of(const OfAStick& stick) {
    HandlePlant plant;
    plant.mass = 0.3;
    plant.damping = 4.0;
    plant.coulomb = stick.friction;
    return plant;
}

/// A stick of which nobody knows anything, measured in simulated time.
struct Trial : JoystickBench {
    JoystickMeasuring measuring;
    double strongest = 0.0; ///< N, that the grip felt while it stood free
    std::vector<Step> steps;

    explicit Trial(const OfAStick& stick)
        : JoystickBench(stick.wire, plant_of(stick), stick.delay_ms), measuring(device, *loop) {
        device.assume(JoystickScale{}.newtons_at_full, JoystickScale{}.sign);
        model.newtons_at_full = stick.newtons_at_full;
        model.sign = stick.sign;
        after_tick = [this] {
            if (measuring.trial().step() == Step::right || measuring.trial().step() == Step::away)
                strongest = std::max(strongest, length(model.force()));
        };
    }
    Step step() const { return measuring.trial().step(); }
    void poll_for(double seconds) {
        for (double t = 0.0; t < seconds; t += 0.016) {
            run(0.016);
            if (measuring.poll(clock.now()))
                steps.push_back(step());
        }
    }
    /// Until it is to be weighed, or failed.
    void find_the_signs() {
        for (int i = 0; i < 60 && step() != Step::weigh && step() != Step::failed; ++i)
            poll_for(0.5);
    }
    /// What a scale shows in the hand that holds the grip back.
    double grams() { return 1e3 * model.force().y / JoystickTrial::standard_gravity; }
    void weigh() {
        model.hold(0.5, 5.0);
        for (int i = 0; i < 12 && step() == Step::weigh; ++i) {
            poll_for(1.5);
            if (const Result<bool> done = measuring.weighed(grams(), clock.now()); !done)
                error = done.error();
        }
    }
    JoystickScale found() const { return measuring.trial().assumed(); }
};

} // namespace

class JoystickMeasuringTest : public QObject {
    Q_OBJECT
private slots:
    void a_joystick_is_measured_data() {
        QTest::addColumn<double>("newtons");
        QTest::addColumn<double>("friction");
        QTest::addColumn<Vec2>("sign");
        QTest::addColumn<bool>("eight_bits");
        for (const double newtons : {3.0, 8.0, 20.0, 60.0})
            for (const Vec2 sign : {Vec2(-1, -1), Vec2(1, 1), Vec2(-1, 1), Vec2(1, -1)})
                QTest::addRow("%g_N_%g_%g", newtons, sign.x, sign.y)
                    << newtons << 0.03 * newtons << sign << false;
        QTest::newRow("sidewinder") << 8.0 << 0.3 << Vec2(1, -1) << true;
    }
    void a_joystick_is_measured() {
        QFETCH(double, newtons);
        QFETCH(double, friction);
        QFETCH(Vec2, sign);
        QFETCH(bool, eight_bits);
        Trial trial({newtons, sign, eight_bits ? sidewinder() : open_controller(), friction});
        QVERIFY2(trial.error.empty(), trial.error.c_str());
        trial.find_the_signs();
        QCOMPARE(trial.step(), Step::weigh);
        QVERIFY(trial.found().sign == sign);
        QVERIFY2(trial.strongest <= std::max(1.05, 4.0 * friction),
                 qPrintable(QString::number(trial.strongest)));
        trial.weigh();
        QCOMPARE(trial.step(), Step::measured);
        QVERIFY(trial.found().measured);
        const double off = trial.found().newtons_at_full / newtons - 1.0;
        QVERIFY2(std::abs(off) < (eight_bits ? 0.1 : 0.03), qPrintable(QString::number(off)));
        trial.poll_for(0.5);
        QVERIFY(length(trial.model.force()) < 1e-9);
        QCOMPARE(trial.steps, (std::vector{Step::away, Step::weigh}));
    }

    void a_joystick_in_a_firm_hand_is_not_measured() {
        Trial trial({});
        trial.model.hold(2.0, 5.0);
        trial.find_the_signs();
        QCOMPARE(trial.step(), Step::failed);
        QCOMPARE(trial.measuring.trial().failure(), JoystickTrial::Failure::not_moved);
        QVERIFY(trial.measuring.words().startsWith("The stick did not move."));
        trial.poll_for(0.2);
        QVERIFY(length(trial.model.force()) < 1e-9);
        QVERIFY(trial.strongest < 2.0 + 1e-6); // a quarter of the whole force is the most
    }

    void a_joystick_in_a_restless_hand_never_pulls() {
        Trial trial({});
        trial.model.hold(0.5, 5.0);
        for (int i = 0; i < 800 && trial.step() == Step::right; ++i) {
            trial.model.move_hand({20.0 * std::sin(0.5 * i), 0.0});
            trial.poll_for(0.016);
        }
        QCOMPARE(trial.measuring.trial().failure(), JoystickTrial::Failure::not_still);
        QVERIFY(trial.strongest < 1e-9);
    }

    void a_push_to_the_side_is_no_answer() {
        JoystickTrial trial;
        double now = 0.0;
        while (trial.pull() == Vec2(0.0))
            trial.sample({0.0, 0.0}, now += 0.016);
        trial.sample({3.0, 3.0}, now += 0.016);
        QCOMPARE(trial.failure(), JoystickTrial::Failure::other_axis);
        QVERIFY(trial.pull() == Vec2(0.0));
        QVERIFY(!trial.sample({9.0, 0.0}, now += 0.016));
    }

    void a_way_back_that_is_none_is_no_answer() {
        JoystickTrial trial;
        double now = 0.0;
        Vec2 place(0.0);
        for (int pulls = 0; pulls < 2; ++pulls) {
            while (trial.pull() == Vec2(0.0) && trial.failure() == JoystickTrial::Failure::none)
                trial.sample(place, now += 0.016);
            place += Vec2(4.0, 0.0); // to the right, whatever pulls: somebody pushes
            trial.sample(place, now += 0.016);
        }
        QCOMPARE(trial.failure(), JoystickTrial::Failure::changes_mind);
    }

    void what_no_scale_shows_is_refused_and_asked_again() {
        Trial trial({});
        trial.find_the_signs();
        trial.model.hold(0.5, 5.0);
        trial.poll_for(1.0);
        for (const double grams : {-1.0, 1e9, std::nan("")})
            QVERIFY(!trial.measuring.weighed(grams, trial.clock.now()));
        QVERIFY(!trial.measuring.weighed(90000.0, trial.clock.now())); // 900 N for a pull of about 1 N
        QCOMPARE(trial.step(), Step::weigh);
        trial.weigh();
        QCOMPARE(trial.step(), Step::measured);
        QVERIFY(std::abs(trial.found().newtons_at_full - 8.0) < 0.3);
    }

    void a_joystick_that_nobody_weighs_stops_pulling() {
        Trial trial({});
        trial.find_the_signs();
        trial.model.hold(0.5, 5.0);
        trial.poll_for(JoystickTrial::weigh_s - 1.0);
        QCOMPARE(trial.step(), Step::weigh);
        QVERIFY(length(trial.model.force()) > 0.05);
        trial.poll_for(2.0);
        QCOMPARE(trial.measuring.trial().failure(), JoystickTrial::Failure::not_weighed);
        QVERIFY(trial.measuring.words().startsWith("The stick was not weighed for three minutes"));
        QVERIFY(length(trial.model.force()) < 1e-9);
    }

    void a_joystick_that_does_not_pull_is_not_weighed() {
        Trial trial({});
        trial.find_the_signs();
        trial.loop->disengage();
        trial.run(0.2);
        const Result<bool> none = trial.measuring.weighed(100.0, trial.clock.now());
        QVERIFY(!none);
        QVERIFY(QString::fromStdString(none.error()).startsWith("The stick does not pull now."));
    }
};

} // namespace joystick_measuring_test

TP_TEST(joystick_measuring_test, JoystickMeasuringTest, event_loop)
#include "joystick_measuring_test.moc"
