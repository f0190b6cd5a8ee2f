// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/firmware/five_bar.hpp"
#include "kinematics_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

namespace five_bar_test {

using namespace tp::pad;

namespace {

FiveBar<double> bars() { return {70.0, 90.0, 38.0}; }

/// Motor angles that bring the knob to a place, by the law of cosines; elbows outwards.
bool angles_for(const FiveBar<double>& b, Vec<double> place, double (&angles)[2]) {
    for (int i = 0; i < 2; ++i) {
        const double x = place.x - (i == 1 ? b.base : 0.0);
        const double reach = std::hypot(x, place.y);
        const double c =
            (b.proximal * b.proximal + reach * reach - b.distal * b.distal) / (2.0 * b.proximal * reach);
        if (!(std::abs(c) <= 1.0))
            return false;
        angles[i] = std::atan2(place.y, x) + (i == 0 ? 1.0 : -1.0) * std::acos(c);
    }
    return true;
}

} // namespace

class FiveBarTest : public QObject {
    Q_OBJECT
private slots:
    void the_pantograph_finds_its_knob() {
        std::mt19937 random(6);
        int reached = 0;
        for (int i = 0; i < 5000; ++i) {
            const Vec<double> place = Vec<double>{19.0, 90.0} + random_place(random, 90.0, 60.0);
            double angles[2];
            if (!angles_for(bars(), place, angles))
                continue;
            const auto pose = locate(bars(), angles);
            QVERIFY(pose.reachable);
            const Vec<double> elbows[2] = {pose.place - pose.link[0], pose.place - pose.link[1]};
            const Vec<double> between = elbows[1] - elbows[0];
            if (cross(between, place - elbows[0]) < 1e-3)
                continue; // the knob is on the other side of its elbows: another assembly
            ++reached;
            QVERIFY(apart(pose.place, place) < 1e-8);
        }
        QVERIFY(reached > 3000);
    }

    void the_whole_outline_has_the_force_that_is_promised() {
        const PadConfig bar = pantograph_pad();
        for (float x = bar.outline[0].x; x <= bar.outline[2].x; x += 5)
            for (float y = bar.outline[0].y; y <= bar.outline[2].y; y += 5) {
                double exact[2];
                QVERIFY(angles_for(bars(), {double(x), double(y)}, exact));
                const float angles[2] = {static_cast<float>(exact[0]), static_cast<float>(exact[1])};
                const FiveBarPose<float> pose = locate(bar.bars, angles);
                QVERIFY(pose.spread > bar.least_spread);
                for (int k = 0; k < 16; ++k) {
                    const double turn = std::numbers::pi * k / 8.0;
                    const auto made = torques(
                        pose,
                        {static_cast<float>(1.2 * std::cos(turn)), static_cast<float>(1.2 * std::sin(turn))},
                        bar.greatest_torque, bar.least_spread);
                    QVERIFY2(!made.limited, qPrintable(QString("%1 %2").arg(x).arg(y)));
                }
            }
    }

    /// Virtual work: the torques on a small turn of the motors do what the force does on the knob's way.
    void the_pantographs_torques_do_the_work_of_the_force() {
        std::mt19937 random(7);
        for (int i = 0; i < 2000; ++i) {
            const Vec<double> place = Vec<double>{19.0, 105.0} + random_place(random, 60.0, 30.0);
            double angles[2];
            QVERIFY(angles_for(bars(), place, angles));
            const auto pose = locate(bars(), angles);
            const Vec<double> wanted = random_place(random, 1.0, 1.0);
            const auto made = torques(pose, wanted, 1e9, 0.0);
            for (int motor = 0; motor < 2; ++motor) {
                constexpr double turn = 1e-6;
                double ahead[2] = {angles[0], angles[1]};
                double behind[2] = {angles[0], angles[1]};
                ahead[motor] += turn;
                behind[motor] -= turn;
                const Vec<double> way = locate(bars(), ahead).place - locate(bars(), behind).place;
                QVERIFY(std::abs(dot(wanted, way) / (2.0 * turn) - made.newton_mm[motor]) < 1e-5);
            }
        }
    }

    void singular_poses_of_the_pantograph_make_no_force_data() {
        QTest::addColumn<double>("distal");
        QTest::addColumn<double>("first");
        QTest::addColumn<double>("second");
        QTest::addColumn<bool>("reachable");
        const double pi = std::numbers::pi;
        const double inwards = std::acos(19.0 / 70.0);
        QTest::newRow("distal links in one line") << 89.0 << pi << 0.0 << true;
        QTest::newRow("a hair from one line") << 89.0000001 << pi << 0.0 << true;
        QTest::newRow("nearly in one line") << 90.0 << pi << 0.0 << true;
        QTest::newRow("elbows too far apart") << 85.0 << pi << 0.0 << false;
        QTest::newRow("elbows in one place") << 90.0 << inwards << pi - inwards << false;
        QTest::newRow("not a number") << 90.0 << std::numeric_limits<double>::quiet_NaN() << 0.0 << false;
    }
    void singular_poses_of_the_pantograph_make_no_force() {
        QFETCH(double, distal);
        QFETCH(double, first);
        QFETCH(double, second);
        QFETCH(bool, reachable);
        const double angles[2] = {first, second};
        const auto pose = locate(FiveBar<double>{70.0, distal, 38.0}, angles);
        QCOMPARE(pose.reachable, reachable);
        const auto made = torques(pose, Vec<double>{0.5, 0.5}, 123.0, 0.3);
        QVERIFY(made.limited);
        for (const double torque : made.newton_mm)
            QCOMPARE(torque, 0.0);
        QVERIFY(made.force.x == 0.0 && made.force.y == 0.0);
        QVERIFY(!torques(pose, Vec<double>{0.0, 0.0}, 123.0, 0.3).limited); // nothing is missing
    }

    /// So that a pad that has lost its pose says a place that is near where it was.
    void out_of_reach_its_place_is_between_its_elbows() {
        const double angles[2] = {2.5, 0.4};
        const auto pose = locate(FiveBar<double>{70.0, 60.0, 38.0}, angles);
        QVERIFY(!pose.reachable);
        const Vec<double> middle{19.0 + 35.0 * (std::cos(2.5) + std::cos(0.4)),
                                 35.0 * (std::sin(2.5) + std::sin(0.4))};
        QVERIFY(apart(pose.place, middle) < 1e-9);
        QCOMPARE(pose.spread, 0.0);
    }

    /// Its elbows a thousandth of a link apart tell where the knob is, and nearer ones do not.
    void elbows_that_nearly_meet_do_not_tell_the_place() {
        for (const auto& [share, told] : {std::pair{0.0012, true}, {0.0008, false}}) {
            const double turn = std::acos((38.0 - share * 90.0) / 140.0);
            const double angles[2] = {turn, std::numbers::pi - turn};
            QCOMPARE(locate(bars(), angles).reachable, told);
        }
    }

    /// The least spread itself and the greatest torque itself are allowed.
    void at_its_limits_it_makes_the_whole_force() {
        double angles[2];
        QVERIFY(angles_for(bars(), {60.0, 110.0}, angles));
        const auto pose = locate(bars(), angles);
        const Vec<double> wanted{0.6, -0.8};
        const auto free = torques(pose, wanted, 1e9, 0.0);
        const double greatest = std::max(std::abs(free.newton_mm[0]), std::abs(free.newton_mm[1]));
        const auto at_limits = torques(pose, wanted, greatest, pose.spread);
        QVERIFY(!at_limits.limited);
        QVERIFY(at_limits.force.x == wanted.x && at_limits.force.y == wanted.y);
        QVERIFY(at_limits.newton_mm[0] == free.newton_mm[0] && at_limits.newton_mm[1] == free.newton_mm[1]);
        QVERIFY(torques(pose, wanted, 0.999 * greatest, pose.spread).limited);
        QVERIFY(torques(pose, wanted, greatest, 1.001 * pose.spread).limited);
    }

    void a_weak_motor_keeps_the_direction() {
        double angles[2];
        QVERIFY(angles_for(bars(), {19.0, 100.0}, angles));
        const auto pose = locate(bars(), angles);
        const Vec<double> wanted{3.0, 4.0};
        const auto made = torques(pose, wanted, 60.0, 0.3);
        QVERIFY(made.limited);
        const double most = std::max(std::abs(made.newton_mm[0]), std::abs(made.newton_mm[1]));
        QVERIFY(most <= 60.0 && most > 59.999999); // and no weaker than it must
        QVERIFY(std::abs(cross(made.force, wanted)) < 1e-9);
        QVERIFY(made.force.x > 0.1 && made.force.x < 3.0);
        const auto of_that = torques(pose, made.force, 1e9, 0.3);
        for (int motor = 0; motor < 2; ++motor)
            QVERIFY(std::abs(of_that.newton_mm[motor] - made.newton_mm[motor]) < 1e-9);
    }

    /// Whatever rounding does, no motor is asked for more than it bears.
    void in_float_too_torques_keep_to_their_bound() {
        const PadConfig pad = pantograph_pad();
        std::mt19937 random(11);
        for (int i = 0; i < 20000; ++i) {
            double exact[2];
            const Vec<double> place = Vec<double>{19.0, 105.0} + random_place(random, 60.0, 30.0);
            QVERIFY(angles_for(bars(), place, exact));
            const float angles[2] = {static_cast<float>(exact[0]), static_cast<float>(exact[1])};
            const Vec<double> wanted = random_place(random, 9.0, 9.0);
            const auto made =
                torques(locate(pad.bars, angles),
                        {static_cast<float>(wanted.x), static_cast<float>(wanted.y)}, 70.1f, 0.3f);
            for (const float torque : made.newton_mm)
                QVERIFY(std::abs(torque) <= 70.1f);
        }
    }

    /// The microcontroller reckons in float: what that costs against double.
    void float_is_accurate_enough() {
        std::mt19937 random(8);
        double place_um = 0.0;
        double torque_share = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const Vec<double> wanted = random_place(random, 1.0, 1.0);
            const Vec<double> knob = Vec<double>{19.0, 105.0} + random_place(random, 60.0, 30.0);
            double angles[2];
            QVERIFY(angles_for(bars(), knob, angles));
            const float turned[2] = {static_cast<float>(angles[0]), static_cast<float>(angles[1])};
            const auto pose = locate(pantograph_pad().bars, turned);
            place_um = std::max(place_um, 1e3 * apart({double(pose.place.x), double(pose.place.y)}, knob));
            const auto exact = torques(locate(bars(), angles), wanted, 1e9, 0.0);
            const auto small =
                torques(pose, {static_cast<float>(wanted.x), static_cast<float>(wanted.y)}, 1e9f, 0.0f);
            for (int k = 0; k < 2; ++k)
                torque_share =
                    std::max(torque_share, std::abs(double(small.newton_mm[k]) - exact.newton_mm[k]));
        }
        qInfo("float against double: %.3f um and %.5f mNm", place_um, torque_share);
        QVERIFY(place_um < 0.2);
        QVERIFY(torque_share < 0.001);
    }
};

} // namespace five_bar_test

TP_TEST(five_bar_test, FiveBarTest, nothing)
#include "five_bar_test.moc"
