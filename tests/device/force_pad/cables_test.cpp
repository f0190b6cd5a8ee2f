// SPDX-License-Identifier: Apache-2.0
// What the four cables pull, and which force that makes.
#include "device/force_pad/firmware/cables.hpp"
#include "kinematics_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace cables_test {

using namespace tp::pad;

namespace {

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
        if (distance > 0.0)
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

/// No random tensions come nearer to the force that is wanted than the force that was made.
void judge_nearest(const CableFrame<double>& frame, Vec<double> place, Vec<double> wanted, Vec<double> made,
                   std::mt19937& random) {
    std::uniform_real_distribution<double> tension(0.0, 1.0);
    for (int trial = 0; trial < 50; ++trial) {
        Vec<double> other;
        for (const Vec<double> exit : frame.exits) {
            const double share = std::clamp(1.6 * tension(random) - 0.3, 0.0, 1.0);
            const double t = frame.least_tension + share * (frame.greatest_tension - frame.least_tension);
            if (const double distance = apart(exit, place); distance > 0.0)
                other = other + (t / distance) * (exit - place);
        }
        QVERIFY(apart(other, wanted) > apart(made, wanted) - 1e-9);
    }
}

} // namespace

class CablesTest : public QObject {
    Q_OBJECT
private slots:
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
                judge_nearest(frame, place, wanted, found.force, random);
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

    /// A cable whose exit the knob stands on pulls nowhere, and those beside it must do.
    void on_an_exit_and_beside_it_the_other_cables_make_the_force() {
        const auto frame = frame_of<double>();
        std::mt19937 random(9);
        int feasible = 0;
        for (int exit = 0; exit < cable_count; ++exit)
            for (const double off : {0.0, 1e-9, 1e-3, 0.1})
                for (int i = 0; i < 200; ++i) {
                    const Vec<double> place = frame.exits[exit] + random_place(random, off, off);
                    const Vec<double> wanted = random_place(random, 4.0, 4.0);
                    const auto found = distribute(frame, place, wanted);
                    const double best = least_distance_by_trying(frame, place, wanted);
                    QCOMPARE(found.feasible, std::isfinite(best));
                    if (found.feasible) {
                        ++feasible;
                        QVERIFY(apart(found.force, wanted) < 1e-9);
                        QVERIFY(distance_to_rest(frame, found.newtons) < best + 1e-7);
                    }
                    if (off == 0.0 && !found.feasible) { // it only pulls the knob against its exit
                        QCOMPARE(found.newtons[exit], frame.least_tension);
                        judge_nearest(frame, place, wanted, found.force, random);
                    }
                }
        QVERIFY(feasible > 500);
    }

    /// Whatever rounding does, no cable goes slack and none is pulled harder than it bears.
    void in_float_too_tensions_keep_to_their_bounds() {
        const auto frame = frame_of<float>();
        std::mt19937 random(10);
        for (int i = 0; i < 20000; ++i) {
            const Vec<double> place = random_place(random, 149.0, 109.0);
            const Vec<double> wanted = random_place(random, 3.0, 3.0);
            const auto found = distribute(frame, {static_cast<float>(place.x), static_cast<float>(place.y)},
                                          {static_cast<float>(wanted.x), static_cast<float>(wanted.y)});
            for (const float tension : found.newtons)
                QVERIFY(tension >= frame.least_tension && tension <= frame.greatest_tension);
        }
    }

    /// Along that line too, so that nobody is told of a force that is not there.
    void cables_in_one_line_make_no_force_that_is_wanted() {
        const CableFrame<double> frame = nearly_in_one_line(0.0);
        for (const Vec<double> wanted : {Vec<double>{1, 0}, {0, 1}, {-3, 2}, {0, 0}}) {
            const auto found = distribute(frame, Vec<double>{0, 0}, wanted);
            QVERIFY(!found.feasible);
            QVERIFY(std::abs(found.force.x) < 8.0 && std::abs(found.force.y) < 1e-9);
            for (const double tension : found.newtons)
                QVERIFY(tension >= frame.least_tension && tension <= frame.greatest_tension);
        }
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
    }

    /// The microcontroller reckons in float: what that costs against double.
    void float_is_accurate_enough() {
        const auto fine = frame_of<double>();
        const auto coarse = frame_of<float>();
        std::mt19937 random(8);
        double force_mn = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const Vec<double> place = random_place(random, 100.0, 75.0);
            const Lengths lengths = lengths_at(fine, place);
            const Vec<double> wanted = random_place(random, 1.0, 1.0);
            const auto t = distribute(coarse, {static_cast<float>(place.x), static_cast<float>(place.y)},
                                      {static_cast<float>(wanted.x), static_cast<float>(wanted.y)});
            Vec<double> made;
            for (int k = 0; k < cable_count; ++k)
                made = made + (double(t.newtons[k]) / lengths.mm[k]) * (fine.exits[k] - place);
            force_mn = std::max(force_mn, 1e3 * apart(made, wanted));
        }
        qInfo("float against double: %.4f mN", force_mn);
        QVERIFY(force_mn < 0.01);
    }
};

} // namespace cables_test

TP_TEST(cables_test, CablesTest, nothing)
#include "cables_test.moc"
