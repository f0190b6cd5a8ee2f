// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/firmware/cables.hpp"
#include "device/force_pad/firmware/five_bar.hpp"
#include "device/force_pad/firmware/pad_firmware.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

using namespace tp::pad;

namespace {

template <typename Real>
CableFrame<Real> frame_of() {
    const CableFrame<float> made = cable_pad().cables;
    CableFrame<Real> frame;
    for (int i = 0; i < cable_count; ++i)
        frame.exits[i] = {Real(made.exits[i].x), Real(made.exits[i].y)};
    frame.least_tension = Real(0.3);
    frame.greatest_tension = Real(4.0);
    frame.rest_tension = Real(0.6);
    return frame;
}

struct Lengths {
    double mm[cable_count];
};

Lengths lengths_at(const CableFrame<double>& frame, Vec<double> place) {
    Lengths lengths;
    for (int i = 0; i < cable_count; ++i)
        lengths.mm[i] = std::hypot(frame.exits[i].x - place.x, frame.exits[i].y - place.y);
    return lengths;
}

double apart(Vec<double> a, Vec<double> b) { return std::hypot(a.x - b.x, a.y - b.y); }

Vec<double> random_place(std::mt19937& random, double half_x, double half_y) {
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    const double x = half_x * share(random);
    return {x, half_y * share(random)};
}

double distance_to_rest(const CableFrame<double>& frame, const double (&t)[cable_count]) {
    double squares = 0.0;
    for (const double tension : t)
        squares += (tension - frame.rest_tension) * (tension - frame.rest_tension);
    return squares;
}

/// The smallest distance to rest over all choices of cables held at a bound, each with the least-norm rest:
/// another way to the same minimum. Infinity where none makes the force.
double least_distance_by_trying(const CableFrame<double>& frame, Vec<double> place, Vec<double> wanted) {
    Vec<double> unit[cable_count];
    for (int i = 0; i < cable_count; ++i) {
        const double distance = apart(frame.exits[i], place);
        unit[i] = {(frame.exits[i].x - place.x) / distance, (frame.exits[i].y - place.y) / distance};
    }
    double best = std::numeric_limits<double>::infinity();
    for (int choice = 0; choice < 81; ++choice) {
        double t[cable_count];
        bool free[cable_count];
        Vec<double> missing = wanted;
        double xx = 0, xy = 0, yy = 0;
        for (int i = 0, rest = choice; i < cable_count; ++i, rest /= 3) {
            free[i] = rest % 3 == 0;
            t[i] =
                free[i] ? frame.rest_tension : (rest % 3 == 1 ? frame.least_tension : frame.greatest_tension);
            missing = missing - t[i] * unit[i];
            if (free[i]) {
                xx += unit[i].x * unit[i].x;
                xy += unit[i].x * unit[i].y;
                yy += unit[i].y * unit[i].y;
            }
        }
        const double determinant = xx * yy - xy * xy;
        if (determinant < 1e-9)
            continue;
        const Vec<double> pull{(yy * missing.x - xy * missing.y) / determinant,
                               (xx * missing.y - xy * missing.x) / determinant};
        bool within = true;
        for (int i = 0; i < cable_count; ++i) {
            if (free[i])
                t[i] += dot(pull, unit[i]);
            within = within && t[i] > frame.least_tension - 1e-9 && t[i] < frame.greatest_tension + 1e-9;
        }
        if (within)
            best = std::min(best, distance_to_rest(frame, t));
    }
    return best;
}

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

class ForcePadKinematicsTest : public QObject {
    Q_OBJECT
private slots:
    void the_small_mathematics_is_as_good_as_the_library() {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> exponent(-30.0, 30.0);
        std::uniform_real_distribution<double> angle(-7.0, 7.0);
        for (int i = 0; i < 20000; ++i) {
            const double v = std::exp(exponent(random));
            QVERIFY(std::abs(square_root(v) / std::sqrt(v) - 1.0) < 4e-16);
            const auto f = static_cast<float>(v);
            QVERIFY(std::abs(square_root(f) / std::sqrt(f) - 1.0f) < 2.5e-7f);
            const double a = angle(random);
            const SineCosine<double> turn = sine_cosine(a);
            QVERIFY(std::abs(turn.sine - std::sin(a)) < 2e-15);
            QVERIFY(std::abs(turn.cosine - std::cos(a)) < 2e-15);
            const SineCosine<float> small = sine_cosine(static_cast<float>(a));
            QVERIFY(std::abs(static_cast<double>(small.sine) - std::sin(double(static_cast<float>(a)))) <
                    3e-7);
            QVERIFY(std::abs(static_cast<double>(small.cosine) - std::cos(double(static_cast<float>(a)))) <
                    3e-7);
        }
        QCOMPARE(square_root(0.0f), 0.0f);
        QCOMPARE(square_root(-1.0), 0.0);
        QCOMPARE(square_root(std::numeric_limits<double>::quiet_NaN()), 0.0);
    }

    void four_lengths_give_the_place_from_anywhere() {
        const auto frame = frame_of<double>();
        std::mt19937 random(2);
        for (int i = 0; i < 5000; ++i) {
            const Vec<double> place = random_place(random, 149.0, 109.0);
            const Vec<double> start = random_place(random, 149.0, 109.0);
            const auto found = locate(frame, lengths_at(frame, place).mm, start);
            QVERIFY(found.converged);
            QVERIFY(apart(found.place, place) < 1e-8);
            QVERIFY(found.residual < 1e-8);
        }
    }

    void hard_places_of_the_cable_frame_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("corner of the workspace") << 100.0 << 75.0;
        QTest::newRow("on an exit") << 150.0 << 110.0;
        QTest::newRow("on the frame between two exits") << 0.0 << 110.0;
        QTest::newRow("centre, on both diagonals") << 0.0 << 0.0;
        QTest::newRow("a hair from an exit") << -149.9999 << -110.0;
        QTest::newRow("outside the frame") << 170.0 << 0.0;
    }
    void hard_places_of_the_cable_frame() {
        QFETCH(double, x);
        QFETCH(double, y);
        const auto frame = frame_of<double>();
        const auto found = locate(frame, lengths_at(frame, {x, y}).mm, {3.0, -2.0});
        QVERIFY(found.converged);
        QVERIFY(apart(found.place, {x, y}) < 1e-6);
        for (const Vec<double> wanted : {Vec<double>{0, 0}, Vec<double>{1, 0}, Vec<double>{-2, 9}}) {
            const auto tensions = distribute(frame, Vec<double>{x, y}, wanted);
            for (const double t : tensions.newtons)
                QVERIFY(t >= frame.least_tension - 1e-12 && t <= frame.greatest_tension + 1e-12);
            if (tensions.feasible)
                QVERIFY(apart(tensions.force, wanted) < 1e-9);
        }
    }

    /// What four encoders are for: one that slipped, or a cable that went slack, cannot hide.
    void a_slipped_encoder_shows_in_the_residual() {
        const auto frame = frame_of<double>();
        std::mt19937 random(3);
        double least = std::numeric_limits<double>::infinity();
        double farthest = 0.0;
        for (int i = 0; i < 4000; ++i) {
            const Vec<double> place = random_place(random, 100.0, 75.0);
            for (int cable = 0; cable < cable_count; ++cable)
                for (const double slip : {-2.0, 2.0}) {
                    Lengths lengths = lengths_at(frame, place);
                    lengths.mm[cable] += slip;
                    const auto found = locate(frame, lengths.mm, place);
                    QVERIFY(found.converged);
                    least = std::min(least, found.residual / std::abs(slip));
                    farthest = std::max(farthest, apart(found.place, place) / std::abs(slip));
                }
        }
        qInfo("a slip of 1 mm: residual at least %.3f mm, place at most %.3f mm off", least, farthest);
        QVERIFY(least > 0.2);
        // So a slip is noticed before it moves the finger by more than this:
        QVERIFY(farthest * static_cast<double>(cable_pad().greatest_residual) / least < 2.5);
    }

    void lengths_that_fit_no_place_end_and_say_so() {
        const auto frame = frame_of<double>();
        for (const double length : {0.0, -50.0, 1e6, std::numeric_limits<double>::quiet_NaN()}) {
            const double lengths[cable_count] = {length, length, 100.0, 100.0};
            const auto found = locate(frame, lengths, Vec<double>{0, 0});
            QVERIFY(!(found.residual < 10.0));
        }
    }

    void tensions_make_the_force_and_stay_nearest_to_rest() {
        const auto frame = frame_of<double>();
        std::mt19937 random(4);
        int at_bounds = 0;
        int infeasible = 0;
        for (int i = 0; i < 4000; ++i) {
            const Vec<double> place = random_place(random, 145.0, 105.0);
            const Vec<double> wanted = random_place(random, 4.0, 4.0);
            const auto found = distribute(frame, place, wanted);
            Vec<double> made;
            for (int k = 0; k < cable_count; ++k) {
                QVERIFY(found.newtons[k] >= frame.least_tension - 1e-12);
                QVERIFY(found.newtons[k] <= frame.greatest_tension + 1e-12);
                at_bounds += found.newtons[k] < frame.least_tension + 1e-9;
                const double distance = apart(frame.exits[k], place);
                made = made + (found.newtons[k] / distance) * (frame.exits[k] - place);
            }
            QVERIFY(apart(made, found.force) < 1e-9);
            const double best = least_distance_by_trying(frame, place, wanted);
            QCOMPARE(found.feasible, std::isfinite(best));
            if (found.feasible) {
                QVERIFY(apart(found.force, wanted) < 1e-9);
                QVERIFY(distance_to_rest(frame, found.newtons) < best + 1e-7);
            } else {
                ++infeasible;
                // The nearest: no random tensions come nearer.
                std::uniform_real_distribution<double> tension(0.0, 1.0);
                for (int trial = 0; trial < 50; ++trial) {
                    Vec<double> other;
                    for (int k = 0; k < cable_count; ++k) {
                        const double share = std::clamp(1.6 * tension(random) - 0.3, 0.0, 1.0);
                        const double t =
                            frame.least_tension + share * (frame.greatest_tension - frame.least_tension);
                        other = other + (t / apart(frame.exits[k], place)) * (frame.exits[k] - place);
                    }
                    QVERIFY(apart(other, wanted) > apart(found.force, wanted) - 1e-9);
                }
            }
        }
        QVERIFY(at_bounds > 500);
        QVERIFY(infeasible > 200);
    }

    /// On the diagonals two cables pull in one line: there an edge of what is feasible is made by both of
    /// them.
    void on_a_diagonal_the_nearest_feasible_force_lies_on_the_whole_edge() {
        const auto frame = frame_of<double>();
        const double length = std::hypot(150.0, 110.0);
        const Vec<double> along{150.0 / length, 110.0 / length};
        const Vec<double> across{-along.y, along.x};
        for (const double share : {-5.0, -2.0, 0.0, 1.0, 5.0}) {
            const Vec<double> wanted = 20.0 * across + share * along;
            const auto found = distribute(frame, Vec<double>{0, 0}, wanted);
            QVERIFY(!found.feasible);
            const double other = dot(found.force, along) - share;
            // As far as tensions reach, nothing along the diagonal is missing.
            if (std::abs(share) <= 1.0)
                QVERIFY(std::abs(other) < 1e-9);
        }
    }

    void tensions_change_continuously() {
        const auto frame = frame_of<double>();
        std::mt19937 random(5);
        double most = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const Vec<double> place = random_place(random, 100.0, 75.0);
            const Vec<double> wanted = random_place(random, 3.0, 3.0);
            const auto here = distribute(frame, place, wanted);
            const auto there = distribute(frame, place + random_place(random, 1e-4, 1e-4),
                                          wanted + random_place(random, 1e-4, 1e-4));
            for (int k = 0; k < cable_count; ++k)
                most = std::max(most, std::abs(here.newtons[k] - there.newtons[k]));
        }
        QVERIFY2(most < 5e-3, qPrintable(QString::number(most)));
    }

    void the_whole_outline_has_the_force_that_is_promised() {
        const PadConfig pad = cable_pad();
        for (float x = -100; x <= 100; x += 10)
            for (float y = -75; y <= 75; y += 7.5f)
                for (int k = 0; k < 16; ++k) {
                    const double turn = std::numbers::pi * k / 8.0;
                    const Vec<float> wanted{static_cast<float>(1.2 * std::cos(turn)),
                                            static_cast<float>(1.2 * std::sin(turn))};
                    QVERIFY(distribute(pad.cables, {x, y}, wanted).feasible);
                    QVERIFY(distribute(pad.cables, {x, y}, {0, 0}).feasible);
                }
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
        QTest::newRow("distal links in one line") << 89.0000001 << pi << 0.0 << true;
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
    }

    void a_weak_motor_keeps_the_direction() {
        double angles[2];
        QVERIFY(angles_for(bars(), {19.0, 100.0}, angles));
        const auto made = torques(locate(bars(), angles), Vec<double>{3.0, 4.0}, 60.0, 0.3);
        QVERIFY(made.limited);
        QVERIFY(std::max(std::abs(made.newton_mm[0]), std::abs(made.newton_mm[1])) <= 60.0);
        QVERIFY(std::abs(cross(made.force, Vec<double>{3.0, 4.0})) < 1e-9);
        QVERIFY(made.force.x > 0.1 && made.force.x < 3.0);
    }

    /// The microcontroller reckons in float: what that costs against double.
    void float_is_accurate_enough() {
        const auto fine = frame_of<double>();
        const auto coarse = frame_of<float>();
        std::mt19937 random(8);
        double place_um = 0.0;
        double force_mn = 0.0;
        double bar_um = 0.0;
        double torque_share = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const Vec<double> place = random_place(random, 100.0, 75.0);
            const Lengths lengths = lengths_at(fine, place);
            float rounded[cable_count];
            for (int k = 0; k < cable_count; ++k)
                rounded[k] = static_cast<float>(lengths.mm[k]);
            const auto found = locate(coarse, rounded, {0, 0});
            place_um = std::max(place_um, 1e3 * apart({double(found.place.x), double(found.place.y)}, place));
            const Vec<double> wanted = random_place(random, 1.0, 1.0);
            const auto t = distribute(coarse, {static_cast<float>(place.x), static_cast<float>(place.y)},
                                      {static_cast<float>(wanted.x), static_cast<float>(wanted.y)});
            Vec<double> made;
            for (int k = 0; k < cable_count; ++k)
                made = made + (double(t.newtons[k]) / lengths.mm[k]) * (fine.exits[k] - place);
            force_mn = std::max(force_mn, 1e3 * apart(made, wanted));

            const Vec<double> knob = Vec<double>{19.0, 105.0} + random_place(random, 60.0, 30.0);
            double angles[2];
            QVERIFY(angles_for(bars(), knob, angles));
            const float turned[2] = {static_cast<float>(angles[0]), static_cast<float>(angles[1])};
            const auto pose = locate(pantograph_pad().bars, turned);
            bar_um = std::max(bar_um, 1e3 * apart({double(pose.place.x), double(pose.place.y)}, knob));
            const auto exact = torques(locate(bars(), angles), wanted, 1e9, 0.0);
            const auto small =
                torques(pose, {static_cast<float>(wanted.x), static_cast<float>(wanted.y)}, 1e9f, 0.0f);
            for (int k = 0; k < 2; ++k)
                torque_share =
                    std::max(torque_share, std::abs(double(small.newton_mm[k]) - exact.newton_mm[k]));
        }
        qInfo("float against double: cables %.3f um and %.4f mN, pantograph %.3f um and %.5f mNm", place_um,
              force_mn, bar_um, torque_share);
        QVERIFY(place_um < 0.2);
        QVERIFY(force_mn < 0.01);
        QVERIFY(bar_um < 0.2);
        QVERIFY(torque_share < 0.001);
    }
};

QTEST_APPLESS_MAIN(ForcePadKinematicsTest)
#include "kinematics_test.moc"
