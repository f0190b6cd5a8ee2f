// SPDX-License-Identifier: Apache-2.0
#include "core/servo/far_look.hpp"
#include "test_program.hpp"

#include <QTest>

namespace far_look_test {

using namespace tp;

namespace {

/// Pulls left of x = 0; what is nearest lies at (-10, 0). Counts what it is asked.
class CountingLaw final : public GuidanceLaw {
public:
    mutable int all = 0, felt = 0;

    Guidance at(Vec2 finger) const noexcept override {
        ++all;
        return answer(finger);
    }
    Guidance felt_at(Vec2 finger) const noexcept override {
        ++felt;
        return finger.x < 0.0 ? answer(finger) : Guidance{};
    }

private:
    static Guidance answer(Vec2 finger) {
        Guidance guidance;
        guidance.nearest = Vec2(-10, 0);
        guidance.towards = guidance.nearest - finger;
        guidance.distance = length(guidance.towards);
        guidance.contour = 3;
        guidance.force = finger.x < 0.0 ? Vec2(-1, 0) : Vec2(0);
        return guidance;
    }
};

} // namespace

class FarLookTest : public QObject {
    Q_OBJECT
private slots:
    void where_the_law_pulls_nothing_else_is_asked() {
        const CountingLaw law;
        FarLook look;
        for (int k = 0; k < 100; ++k)
            QVERIFY(look.at(law, {-1.0 - k, 0}).force == Vec2(-1, 0));
        QVERIFY(law.felt == 100 && law.all == 0);
    }

    void elsewhere_what_is_nearest_is_looked_for_fifty_times_a_second() {
        const CountingLaw law;
        FarLook look;
        for (int k = 0; k < 1000; ++k) {
            const Vec2 finger(0.01 * k, 5);
            const Guidance guidance = look.at(law, finger);
            QVERIFY(guidance.contour == 3 && guidance.nearest == Vec2(-10, 0) && guidance.force == Vec2(0));
            QCOMPARE(guidance.distance, length(finger - Vec2(-10, 0)));
        }
        QVERIFY(law.felt == 1000 && law.all == 50);
    }

    void the_first_tick_outside_and_that_of_a_new_law_look_at_once() {
        const CountingLaw law;
        FarLook look;
        look.at(law, {1, 0});
        look.at(law, {-1, 0});
        look.at(law, {1, 0});
        QCOMPARE(law.all, 2);
        look.reset();
        look.at(law, {1, 0});
        QCOMPARE(law.all, 3);
    }
};

} // namespace far_look_test

TP_TEST(far_look_test, FarLookTest, nothing)
#include "far_look_test.moc"
