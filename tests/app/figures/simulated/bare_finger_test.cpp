// SPDX-License-Identifier: Apache-2.0
#include "app/figures/simulated/bare_finger.hpp"
#include "test_program.hpp"

#include <QTest>

namespace bare_finger_test {

using namespace tp;

namespace {

const Polyline line{{{-40, 0}, {40, 0}}, false};

struct Crossing {
    int ticks = 0;
    double friction = 0.0;   ///< the highest
    double behind_mm = 0.0;  ///< how far it was behind a finger that nothing holds, at most
    double felt_at_mm = 0.0; ///< y where the first of it was felt
};

/// Across the line, at 60 mm/s.
Crossing crossing(TouchManner manner, double latency_s) {
    BareFinger finger(line, Person{}, manner, latency_s, {0, -20});
    Vec2 meant(0, -20), free = meant;
    Crossing seen;
    bool felt = false;
    while (meant.y < 20.0) {
        meant.y += 60.0 * BareFinger::step_s;
        const BareTouch touch = finger.move(meant);
        for (int i = 0; i < BareFinger::ticks_a_step; ++i)
            free += BareFinger::tick_s / BareFinger::lag_s * (meant - free);
        seen.ticks += touch.ticked ? 1 : 0;
        seen.friction = std::max(seen.friction, touch.friction);
        seen.behind_mm = std::max(seen.behind_mm, free.y - finger.place().y);
        if (!felt && (touch.ticked || touch.friction >= 0.5)) {
            felt = true;
            seen.felt_at_mm = finger.place().y;
        }
    }
    return seen;
}

} // namespace

class BareFingerTest : public QObject {
    Q_OBJECT
private slots:
    void ticks_do_not_hold_it() {
        const Crossing seen = crossing(TouchManner::ticks, 0.005);
        QVERIFY(seen.ticks == 1 && seen.friction == 0.0 && seen.behind_mm < 1e-9);
    }

    void friction_holds_it_back_by_less_than_the_spring_that_it_takes() {
        const Crossing seen = crossing(TouchManner::resistance, 0.005);
        const double most = BareFinger::strongest_friction_n / Person{}.stiffness_n_per_mm;
        QVERIFY(seen.ticks == 0 && seen.friction > 0.9);
        QVERIFY(seen.behind_mm > 0.2 && seen.behind_mm <= most + 1e-9);
    }

    void what_is_felt_comes_late() {
        const double soon = crossing(TouchManner::ticks, 0.0).felt_at_mm;
        const double late = crossing(TouchManner::ticks, 0.1).felt_at_mm;
        QVERIFY(std::abs(soon) < 0.7);
        QVERIFY(std::abs(late - soon - 6.0) < 0.7); // 60 mm/s for 0.1 s
    }

    void it_stays_as_near_to_the_line_as_it_is() {
        QCOMPARE(BareFinger(line, Person{}, TouchManner::ticks, 0.0, {3, 4}).distance(), 4.0);
    }
};

} // namespace bare_finger_test

TP_TEST(bare_finger_test, BareFingerTest, nothing)
#include "bare_finger_test.moc"
