// SPDX-License-Identifier: Apache-2.0
// The finger's servo in a test's own time; in the machine's it is tried by the Explore page's tests.
#include "app/parts/finger/finger_servo.hpp"
#include "core/geometry/contour.hpp"

#include <QTest>

#include <cmath>

using namespace tp;

namespace {

Scene with_a_line() {
    return {200.0, 200.0, {contour_through("line", {{-60.0, 10.0}, {60.0, 10.0}}, false)}};
}

struct Bench {
    VirtualClock time;
    FingerServo servo{{200.0, 200.0}, settings_for_a_drawn_finger(), {}, &time};
};

} // namespace

class FingerInVirtualTimeTest : public QObject {
    Q_OBJECT
private slots:
    void nothing_ticks_but_by_pass() {
        Bench bench;
        QVERIFY(bench.servo.show(with_a_line()).empty());
        bench.servo.engage();
        const auto before = bench.servo.snapshot().ticks;
        QTest::qWait(30);
        QCOMPARE(bench.servo.snapshot().ticks, before);
        bench.servo.pass(0.25);
        QCOMPARE(bench.servo.snapshot().ticks, before + 250);
        QVERIFY(std::abs(bench.time.now() - 0.25) < 1e-9);
    }

    void another_range_and_another_law_are_felt() {
        Bench bench;
        const auto force_at_8_mm = [&](TentProfile profile, LawKind law) {
            bench.servo.render([=] { return make_haptic_scene(with_a_line(), profile, law); });
            bench.servo.place({0.0, 18.0});
            bench.servo.engage();
            bench.servo.pass(1.0);
            bench.servo.place({0.0, 18.0});
            bench.servo.pass(0.002);
            return length(bench.servo.snapshot().force());
        };
        QVERIFY(force_at_8_mm({0.2, 2.0}, LawKind::exact) < 1e-9); // its pull ends 4 mm away
        QVERIFY(force_at_8_mm({0.2, 8.0}, LawKind::exact) > 0.5);
        QVERIFY(force_at_8_mm({0.2, 8.0}, LawKind::published) > 0.5);
    }

    void a_finger_is_led_to_a_place_and_then_feels_the_same_again() {
        Bench bench;
        bench.servo.render([] { return make_haptic_scene(with_a_line(), {0.2, 8.0}); });
        bench.servo.place({-70.0, -70.0});
        bench.servo.engage();
        bench.servo.lead_to({20.0, 40.0});
        QVERIFY(bench.servo.leads());
        for (int i = 0; i < 100 && !bench.servo.has_led(); ++i)
            bench.servo.pass(0.1);
        QVERIFY(bench.servo.has_led());
        const double away = length(bench.servo.finger() - Vec2(20.0, 40.0));
        QVERIFY2(away < 5.0, qPrintable(QString::number(away)));
        bench.servo.let_go();
        bench.servo.place({0.0, 18.0});
        bench.servo.pass(0.1);
        QVERIFY(bench.servo.snapshot().fy < -0.1);
    }
};

QTEST_GUILESS_MAIN(FingerInVirtualTimeTest)
#include "finger_in_virtual_time_test.moc"
