// SPDX-License-Identifier: Apache-2.0
#include "explore_parts.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstdint>
#include <functional>

namespace finger_servo_test {

using namespace tp;

namespace {

/// Whether the loop ticks on within a time in which it would thousands of times.
bool ticks(const FingerServo& servo) {
    const std::uint64_t before = servo.snapshot().ticks;
    return QTest::qWaitFor([&] { return servo.snapshot().ticks > before + 20; }, 3000);
}

bool stands_still(const FingerServo& servo) {
    const std::uint64_t before = servo.snapshot().ticks;
    QTest::qWait(100);
    return servo.snapshot().ticks == before;
}

bool stands_at(const FingerServo& servo, Vec2 place) {
    QTest::qWait(100);
    return length(servo.finger() - place) < 0.5;
}

} // namespace

/// Resting and waking; what is felt is the tests' of the parts.
class FingerServoTest : public QObject {
    Q_OBJECT
private slots:
    void where_nobody_feels_nothing_ticks_and_the_finger_stays() {
        ExploreParts bench;
        const Vec2 beside = bench.view.line(left_eye).points[0] + Vec2(3.0, 0.0);
        bench.servo.place(beside);
        QTRY_VERIFY(distance_to(bench.view.line(left_eye), bench.servo.finger()) <
                    2.0); // the line has drawn it
        const Vec2 drawn = bench.servo.finger();
        bench.servo.rest();
        QVERIFY(stands_still(bench.servo));
        QVERIFY(!bench.servo.engaged());
        QVERIFY(length(bench.servo.finger() - drawn) < 0.5);

        bench.servo.wake();
        QVERIFY(ticks(bench.servo));
        QVERIFY(length(bench.servo.finger() - drawn) < 0.5); // nothing pulls before the person wants it
        bench.servo.place(beside);
        bench.servo.engage();
        QTRY_VERIFY(distance_to(bench.view.line(left_eye), bench.servo.finger()) < 2.0);
    }

    void another_scene_while_it_rests_is_felt_when_it_wakes() {
        ExploreParts bench;
        bench.servo.rest();
        bench.view.show(drawn_photo(2));
        QVERIFY(stands_still(bench.servo));
        bench.servo.wake();
        QVERIFY(ticks(bench.servo));
        bench.servo.engage();
        const Polyline& eye = bench.view.line(4); // of the second face
        bench.servo.place(eye.points[0] + Vec2(2.0, 0.0));
        QTRY_VERIFY(distance_to(eye, bench.servo.finger()) < 1.5);
    }

    void a_parked_finger_stands_still_without_force_and_goes_on_at_a_touch() {
        ExploreParts bench;
        const Vec2 beside = bench.view.line(left_eye).points[0] + Vec2(3.0, 0.0);
        bench.servo.place(beside);
        QTRY_VERIFY(distance_to(bench.view.line(left_eye), bench.servo.finger()) < 2.0);
        int stirred = 0;
        bench.servo.when_stirred([&] { ++stirred; });
        QVERIFY(bench.servo.park());
        const Vec2 drawn = bench.servo.finger();
        QVERIFY(bench.servo.parked());
        QVERIFY(stands_still(bench.servo));
        QVERIFY(bench.servo.snapshot().force() == Vec2(0.0));
        QVERIFY(bench.servo.finger() == drawn);
        QVERIFY(bench.servo.engaged()); // whoever wanted the force still does
        QVERIFY(bench.servo.park());
        QCOMPARE(stirred, 0);

        bench.servo.place(beside);
        QCOMPARE(stirred, 1);
        QVERIFY(!bench.servo.parked());
        QVERIFY(ticks(bench.servo));
        QTRY_VERIFY(distance_to(bench.view.line(left_eye), bench.servo.finger()) < 2.0);
        QCOMPARE(bench.servo.snapshot().fault, Fault::none);
    }

    void whatever_is_done_with_it_lets_a_parked_finger_go_on() {
        ExploreParts bench;
        const std::function<void()> all[] = {[&] {
                                                 bench.servo.place({0.0, 0.0});
                                             },
                                             [&] {
                                                 bench.servo.move({1.0, 1.0});
                                             },
                                             [&] { bench.servo.lead_along(left_eye); },
                                             [&] { bench.servo.engage(); },
                                             [&] { bench.servo.disengage(); },
                                             [&] { bench.view.show(drawn_photo(2)); },
                                             [&] { bench.servo.stir(); },
                                             [&] { bench.servo.wake(); }};
        for (const auto& each : all) {
            bench.servo.park();
            QVERIFY(bench.servo.parked());
            each();
            QVERIFY(!bench.servo.parked());
            QVERIFY(ticks(bench.servo));
        }
    }

    void a_page_that_is_left_while_it_is_parked_has_no_force_when_one_comes_back() {
        ExploreParts bench;
        const Vec2 beside = bench.view.line(left_eye).points[0] + Vec2(3.0, 0.0);
        bench.servo.place(beside);
        QTRY_VERIFY(distance_to(bench.view.line(left_eye), bench.servo.finger()) < 2.0);
        bench.servo.park();
        const Vec2 drawn = bench.servo.finger();
        bench.servo.rest();
        QVERIFY(!bench.servo.parked() && !bench.servo.engaged());
        bench.servo.move(beside); // nobody is there
        QVERIFY(stands_still(bench.servo));
        bench.servo.wake();
        QVERIFY(ticks(bench.servo));
        bench.servo.place(drawn);
        QVERIFY(stands_at(bench.servo, drawn));
    }

    void with_nothing_to_feel_any_more_it_does_not_tick() {
        ExploreParts bench;
        QVERIFY(ticks(bench.servo));
        bench.servo.clear();
        bench.servo.disengage();
        bench.servo.engage();
        QVERIFY(stands_still(bench.servo));
        bench.view.show(drawn_photo());
        QVERIFY(ticks(bench.servo));
    }

    void with_nothing_to_feel_it_does_not_tick() {
        ExploreParts bench(0);
        bench.servo.rest();
        bench.servo.wake();
        QVERIFY(stands_still(bench.servo));
    }
};

} // namespace finger_servo_test

TP_TEST(finger_servo_test, FingerServoTest, event_loop)
#include "finger_servo_test.moc"
