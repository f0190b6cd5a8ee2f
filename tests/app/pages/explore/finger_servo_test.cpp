// SPDX-License-Identifier: Apache-2.0
#include "explore_parts.hpp"

#include <QTest>

#include <cstdint>

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

    void with_nothing_to_feel_it_does_not_tick() {
        ExploreParts bench(0);
        bench.servo.rest();
        bench.servo.wake();
        QVERIFY(stands_still(bench.servo));
    }
};

QTEST_GUILESS_MAIN(FingerServoTest)
#include "finger_servo_test.moc"
