// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/exact_law.hpp"
#include "core/guidance/haptic_scene.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

namespace exact_law_test {

using namespace tp;
using namespace tp::testing;

class ExactLawTest : public QObject {
    Q_OBJECT
private slots:
    void pulls_straight_to_the_line_with_the_force_of_the_tent() {
        FlatScene scene;
        scene.names = {"line"};
        scene.lines = {{{{-50, 0}, {50, 0}}, false}};
        const ExactLaw law(scene, {0.2, 4.0});
        const Guidance at = law.at({3, 2});
        QCOMPARE(at.force.x, 0.0);
        QVERIFY(std::abs(at.force.y + 0.4) < 1e-12);
        QCOMPARE(at.distance, 2.0);
        QCOMPARE(at.contour, 0);
        QVERIFY(law.at({3, 8}).force == Vec2(0.0));
        QCOMPARE(law.at({3, 9}).distance, 9.0);
    }

    void finger_exactly_on_line_and_vertex_feels_nothing() {
        FlatScene scene;
        scene.names = {"corner"};
        scene.lines = {{{{0, 0}, {10, 0}, {10, 10}}, false}};
        const ExactLaw law(scene, {});
        for (const Vec2 p : {Vec2(0, 0), Vec2(10, 0), Vec2(5, 0), Vec2(10, 3)})
            QVERIFY(law.at(p).force == Vec2(0.0));
    }

    /// Where coordinates are coarse, the way from the finger is not.
    void far_from_the_origin_the_force_points_straight_at_the_line() {
        for (const double far : {0.0, 1e3, 1e6, 1e9}) {
            FlatScene scene;
            scene.names = {"slanted"};
            const Vec2 from(far - 12.5, far - 25.0), to(far + 37.25, far + 70.75);
            scene.lines = {{{from, to}, false}};
            const ExactLaw law(scene, {});
            for (const double along : {0.125, 0.5, 0.75}) {
                const Vec2 finger(far + std::floor(40.0 * along) - 8.25,
                                  far + std::floor(80.0 * along) - 25.5);
                const long double ux = (long double)(to.x) - from.x, uy = (long double)(to.y) - from.y;
                const long double x = (long double)(finger.x) - from.x, y = (long double)(finger.y) - from.y;
                const long double side = (ux * y - uy * x) / (ux * ux + uy * uy);
                const Guidance at = law.at(finger);
                const long double wanted_x = side * uy, wanted_y = -side * ux; // from the finger to the line
                const long double away = std::hypot(wanted_x, wanted_y);
                QVERIFY(away > 1e-3 && away < 8.0);
                const long double turn =
                    (wanted_x * at.force.y - wanted_y * at.force.x) / (away * length(at.force));
                QVERIFY2(std::abs(turn) < 1e-12, qPrintable(QString::number(double(turn))));
                QVERIFY(std::abs(at.distance - away) < 1e-12);
            }
        }
    }

    void no_line_is_too_long_for_the_peak() {
        for (const double half : {1e3, 1e6, 1e9, 1e13, 1e17, 1e100}) {
            FlatScene scene;
            scene.names = {"long"};
            scene.lines = {{{{-half, -0.3 * half}, {half, 0.3 * half}}, false}};
            const TentProfile profile;
            const ExactLaw law(scene, profile);
            std::mt19937 random(8);
            for (int k = 0; k < 300; ++k)
                QVERIFY(length(law.at(random_point(random, 12.0)).force) <= profile.peak() * (1.0 + 1e-12));
        }
    }

    void what_is_felt_is_the_same_without_the_distance_where_nothing_pulls() {
        const FlatScene scene = face_scene();
        std::mt19937 random(9);
        for (const Continuity& continuity : {Continuity{}, {0.0, 0.4, false}, {0.0, 0.0, true}}) {
            const auto law = make_law(scene, {}, LawKind::exact, continuity);
            int without = 0;
            for (int k = 0; k < 3000; ++k) {
                const Vec2 p = random_point(random, 90.0);
                const Guidance all = law->at(p), felt = law->felt_at(p);
                QVERIFY(all.force == felt.force && all.energy == felt.energy);
                if (felt.contour < 0) {
                    ++without;
                    QVERIFY(all.force == Vec2(0.0) && all.distance > TentProfile{}.band());
                } else {
                    QVERIFY(all.contour == felt.contour && all.nearest == felt.nearest &&
                            all.distance == felt.distance);
                }
            }
            QVERIFY(without > 500);
        }
    }

    void a_scene_beyond_a_kilometre_is_refused_with_a_sentence() {
        const auto scene_to = [](double x) {
            return Scene{100.0, 100.0, {contour_through("far", {{0, 0}, {x, 0}}, false)}};
        };
        QVERIFY(make_haptic_scene(scene_to(farthest_felt_mm)).ok());
        QVERIFY(make_haptic_scene(scene_to(-farthest_felt_mm)).ok());
        for (const double x : {1.001e6, -1.001e6, 1e17, -1e300}) {
            const auto made = make_haptic_scene(scene_to(x));
            QVERIFY(!made.ok());
            QVERIFY(made.error().find("far") != std::string::npos && made.error().ends_with('.'));
        }
    }

    void force_is_minus_the_gradient_of_the_energy() {
        std::mt19937 random(3);
        const FlatScene scene = face_scene();
        const ExactLaw law(scene, {});
        const double h = 1e-5;
        int compared = 0;
        for (int k = 0; k < 20000; ++k) {
            const Vec2 p = random_point(random, 70.0);
            const auto U = [&](double dx, double dy) { return law.energy(p + Vec2(dx, dy)); };
            const Vec2 gradient((U(h, 0) - U(-h, 0)) / (2 * h), (U(0, h) - U(0, -h)) / (2 * h));
            // On a ridge of the potential the difference quotient straddles two contours.
            const Vec2 one_sided((U(h, 0) - U(0, 0)) / h, (U(0, h) - U(0, 0)) / h);
            if (length(one_sided - gradient) > 1e-4)
                continue;
            ++compared;
            QVERIFY2(length(law.at(p).force + gradient) < 1e-3,
                     qPrintable(QString("at %1, %2").arg(p.x).arg(p.y)));
        }
        QVERIFY(compared > 15000);
    }

    void no_net_work_round_closed_loops() {
        std::mt19937 random(4);
        const FlatScene scene = face_scene();
        const ExactLaw law(scene, {});
        const double radius = 3.0;
        const int steps = 20000;
        double worst = 0.0;
        for (int loop = 0; loop < 50; ++loop) {
            const Vec2 centre = random_point(random, 70.0);
            double work = 0.0;
            for (int i = 0; i < steps; ++i) {
                const double angle = 2.0 * std::numbers::pi * (i + 0.5) / steps;
                const Vec2 normal(std::cos(angle), std::sin(angle));
                const Vec2 step = (2.0 * std::numbers::pi * radius / steps) * Vec2(-normal.y, normal.x);
                work += glm::dot(law.at(centre + radius * normal).force, step);
            }
            worst = std::max(worst, std::abs(work));
        }
        qInfo("largest net work in a loop of 3 mm radius: %.5f mJ (quadrature error)", worst);
        QVERIFY(worst < 0.01);
    }

    void rigid_motion_of_scene_and_finger_commutes() {
        std::mt19937 random(5);
        const double c = std::cos(0.7), s = std::sin(0.7);
        const auto turn = [&](Vec2 v) { return Vec2(c * v.x - s * v.y, s * v.x + c * v.y); };
        const FlatScene scene = face_scene(60);
        FlatScene moved = scene;
        for (Polyline& line : moved.lines)
            for (Vec2& p : line.points)
                p = turn(p) + Vec2(11, -7);
        const ExactLaw law(scene, {});
        const ExactLaw moved_law(moved, {});
        int compared = 0;
        for (int k = 0; k < 2000; ++k) {
            const Vec2 p = random_point(random, 70.0);
            const Guidance here = law.at(p);
            const Guidance there = moved_law.at(turn(p) + Vec2(11, -7));
            QVERIFY(std::abs(here.distance - there.distance) < 1e-9);
            if (here.contour ==
                there.contour) { // on a tie the rule, which names x and y, may choose otherwise
                ++compared;
                QVERIFY(length(turn(here.force) - there.force) < 1e-6);
            }
        }
        QVERIFY(compared > 1990);
    }
};

} // namespace exact_law_test

TP_TEST(exact_law_test, ExactLawTest, nothing)
#include "exact_law_test.moc"
