// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/blended_law.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

namespace blended_law_test {

using namespace tp;
using namespace tp::testing;

namespace {

FlatScene two_level_lines(double gap) {
    FlatScene scene;
    scene.names = {"upper", "lower"};
    scene.lines = {{{{-50, 0.5 * gap}, {50, 0.5 * gap}}, false},
                   {{{-50, -0.5 * gap}, {50, -0.5 * gap}}, false}};
    return scene;
}

/// The largest change of the force from one place to the next on a way across, 0.1 mm apart.
double largest_step(const GuidanceLaw& law) {
    double largest = 0.0;
    Vec2 last = law.at({3.0, -1.0}).force;
    for (double y = -0.9; y <= 1.0; y += 0.1) {
        const Vec2 force = law.at({3.0, y}).force;
        largest = std::max(largest, length(force - last));
        last = force;
    }
    return largest;
}

} // namespace

class BlendedLawTest : public QObject {
    Q_OBJECT
private slots:
    void beside_a_straight_line_nothing_changes() {
        const FlatScene scene = two_level_lines(60.0);
        const TentProfile tent;
        const BlendedLaw blended(scene, tent, 0.5);
        for (const double r : {0.0, 0.3, 1.0, 2.0, 3.4}) {
            const Guidance at = blended.at({3.0, 30.0 + r});
            QVERIFY(std::abs(at.force.x) < 1e-12);
            QVERIFY(std::abs(at.force.y + tent.force(r)) < 1e-12);
            QCOMPARE(at.contour, 0);
            QVERIFY(std::abs(at.distance - r) < 1e-12);
        }
    }

    void the_jump_between_two_lines_becomes_a_slope() {
        const FlatScene scene = two_level_lines(8.0);
        const TentProfile tent;
        const double jump = largest_step(ExactLaw(scene, tent));
        QVERIFY(jump > 1.5); // the worst there is: 2 K d
        double wider = jump;
        for (const double radius : {0.25, 0.5, 1.0}) {
            const double step = largest_step(BlendedLaw(scene, tent, radius));
            qInfo("radius %.2f mm: at most %.2f N in 0.1 mm instead of %.2f N", radius, step, jump);
            QVERIFY(step < 0.5 * wider);
            wider = step / 0.9;
        }
    }

    void force_is_minus_the_gradient_of_the_energy() {
        std::mt19937 random(6);
        const BlendedLaw law(face_scene(), {}, 0.5);
        const double h = 1e-5;
        int compared = 0;
        for (int k = 0; k < 5000; ++k) {
            const Vec2 p = random_point(random, 70.0);
            const auto U = [&](double dx, double dy) { return law.at(p + Vec2(dx, dy)).energy; };
            const Vec2 gradient((U(h, 0) - U(-h, 0)) / (2 * h), (U(0, h) - U(0, -h)) / (2 * h));
            const Vec2 one_sided((U(h, 0) - U(0, 0)) / h, (U(0, h) - U(0, 0)) / h);
            if (length(one_sided - gradient) > 1e-4)
                continue; // one of the places sits on a ridge
            ++compared;
            QVERIFY2(length(law.at(p).force + gradient) < 1e-3,
                     qPrintable(QString("at %1, %2").arg(p.x).arg(p.y)));
        }
        QVERIFY(compared > 3500);
    }

    /// 4/(3π)·K·radius, the mean distance from a line through the middle of a disc of even weight; the places
    /// of the disc come close to it, in the mean over the line's directions closer still.
    void the_top_of_the_tent_loses_what_an_even_disc_takes_from_it() {
        const TentProfile tent;
        for (const double radius : {0.25, 1.0}) {
            const double promised = 4.0 / (3.0 * std::numbers::pi) * tent.stiffness * radius;
            constexpr int directions = 12;
            double mean = 0.0;
            for (int i = 0; i < directions; ++i) {
                const double angle = std::numbers::pi * i / directions;
                const Vec2 along(std::cos(angle), std::sin(angle));
                const Vec2 beside(-along.y, along.x);
                const BlendedLaw law({{"line"}, {{{-50.0 * along, 50.0 * along}, false}}}, tent, radius);
                const double lost = tent.peak() - length(law.at(tent.range * beside).force);
                QVERIFY(std::abs(lost - promised) < 0.1 * promised);
                mean += lost / directions;
            }
            QVERIFY2(std::abs(mean - promised) < 0.025 * promised,
                     qPrintable(QString::number(mean / promised)));
        }
    }

    void at_a_pull_s_end_the_disc_still_feels_what_reaches_into_it() {
        const TentProfile tent;
        const BlendedLaw law(two_level_lines(60.0), tent, 1.0);
        for (const double r : {8.0, 8.5, 8.9}) {
            QVERIFY(law.at({3.0, 30.0 + r}).force.y < 0.0);
            QVERIFY(law.force_at({3.0, 30.0 + r}) == law.at({3.0, 30.0 + r}).force);
        }
        QVERIFY(law.at({3.0, 39.1}).force == Vec2(0.0));
    }

    void out_of_reach_there_is_no_force_but_a_distance() {
        const TentProfile tent;
        const BlendedLaw law(two_level_lines(8.0), tent, 0.5);
        const Guidance far = law.at({0.0, 40.0});
        QVERIFY(far.force == Vec2(0.0));
        QCOMPARE(far.distance, 36.0);
        QCOMPARE(far.energy, tent.stiffness * tent.range * tent.range);
        QVERIFY(is_finite(law.at({std::nan(""), 0.0}).force));
    }
};

} // namespace blended_law_test

TP_TEST(blended_law_test, BlendedLawTest, nothing)
#include "blended_law_test.moc"
