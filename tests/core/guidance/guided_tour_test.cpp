// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/guided_tour.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <functional>

namespace guided_tour_test {

using namespace tp;
using namespace tp::testing;

namespace {

/// A finger that follows the force like a light body in honey; returns the seconds it took, or -1.
double lead(GuidedTour& tour, Vec2 finger, const std::function<void(Vec2, Vec2)>& see) {
    const double dt = 0.001;
    for (double t = 0.0; t < 120.0; t += dt) {
        const Vec2 force = tour.step(finger, dt);
        see(finger, force);
        if (tour.finished())
            return t;
        finger += dt * 200.0 * force; // 5 N·s/m
    }
    return -1.0;
}

} // namespace

class GuidedTourTest : public QObject {
    Q_OBJECT
private slots:
    void leads_once_round_a_closed_feature_and_lets_go() {
        const Polyline eye = ellipse({20, 10}, 14, 5, 100);
        const TourManner manner;
        GuidedTour tour(eye, {0, 0}, manner);
        std::vector<Vec2> way;
        const double seconds = lead(tour, {0, 0}, [&](Vec2 finger, Vec2 force) {
            QVERIFY(length(force) <= manner.max_force + 1e-12);
            way.push_back(finger);
        });
        QVERIFY(seconds > length_of(eye) / manner.speed);
        for (const Vec2 p : eye.points) {
            double nearest = 1e9;
            for (const Vec2 q : way)
                nearest = std::min(nearest, length(p - q));
            QVERIFY(nearest < 2.0);
        }
        QCOMPARE(tour.progress(), 1.0);
        QVERIFY(tour.step({0, 0}, 0.001) == Vec2(0.0));
    }

    void walks_an_open_feature_from_its_nearer_end_to_the_other() {
        const Polyline line{{{0, 0}, {50, 0}, {50, 30}}, false};
        GuidedTour tour(line, {52, 33});
        Vec2 last(0.0);
        QVERIFY(lead(tour, {52, 33}, [&](Vec2 finger, Vec2) { last = finger; }) > 0.0);
        QVERIFY(length(last - Vec2(0, 0)) < 2.5);
    }

    void an_open_feature_is_begun_at_an_end_from_anywhere() {
        const Polyline line{{{0, 0}, {50, 0}}, false};
        GuidedTour tour(line, {20, 0});
        tour.step({20, 0}, 0.1);
        QVERIFY(length(tour.leader() - Vec2(17, 0)) < 1e-9);
        GuidedTour back(line, {30, 0});
        back.step({30, 0}, 0.1);
        QVERIFY(length(back.leader() - Vec2(33, 0)) < 1e-9);
    }

    void waits_for_a_finger_that_is_held_back() {
        const Polyline line{{{0, 0}, {100, 0}}, false};
        const TourManner manner;
        GuidedTour tour(line, {0, 0}, manner);
        for (int i = 0; i < 20000; ++i)
            QVERIFY(length(tour.step({0, 0}, 0.001)) <= manner.max_force + 1e-12);
        QVERIFY(length(tour.leader()) <= manner.max_lead + manner.speed * 0.001);
        QVERIFY(!tour.finished());
    }

    void the_leading_place_goes_at_its_speed_and_pulls_like_a_spring() {
        const Polyline line{{{0, 0}, {100, 0}}, false};
        GuidedTour tour(line, {-6, 0}); // 30 mm/s, 0.2 N/mm, at most 0.8 N, waits where 8 mm ahead
        QCOMPARE(tour.progress(), 0.0);
        QVERIFY(length(tour.step({-6, 0}, 0.1) - Vec2(0.6, 0)) < 1e-9);
        QVERIFY(length(tour.leader() - Vec2(-3, 0)) < 1e-9); // first to where the line begins
        QCOMPARE(tour.progress(), 0.0);
        QVERIFY(length(tour.step({-6, 0}, 0.2) - Vec2(0.8, 0)) < 1e-9);
        QVERIFY(length(tour.leader() - Vec2(3, 0)) < 1e-9); // and on, without a stop
        QCOMPARE(tour.progress(), 0.03);
        tour.step({-6, 0}, 0.1); // 9 mm ahead: it waits
        QVERIFY(length(tour.leader() - Vec2(3, 0)) < 1e-9);
        tour.step({-4.9, 0}, 0.1);
        QVERIFY(length(tour.leader() - Vec2(6, 0)) < 1e-9);
        QVERIFY(tour.step(tour.leader(), 0.0) == Vec2(0.0)); // where the finger is, nothing pulls
        QVERIFY(!tour.finished());
    }

    void of_a_feature_of_half_a_millimetre_half_is_half() {
        const Polyline line{{{0, 0}, {0.5, 0}}, false};
        GuidedTour tour(line, {0, 0});
        tour.step({0, 0}, 0.25 / 30.0);
        QVERIFY(std::abs(tour.progress() - 0.5) < 1e-9);
        const Polyline dot{{{3, 3}}, true};
        QCOMPARE(GuidedTour(dot, {0, 0}).progress(), 0.0);
    }

    void it_ends_when_the_finger_has_come_to_the_end_too() {
        const Polyline line{{{0, 0}, {3, 0}}, false};
        GuidedTour tour(line, {0, 0});
        for (int i = 0; i < 110; ++i)
            tour.step({0, 0}, 0.001);
        QCOMPARE(tour.progress(), 1.0);
        QVERIFY(!tour.finished()); // the finger is still 3 mm behind
        QVERIFY(tour.step({0.5, 0}, 0.1).x > 0.0);
        QVERIFY(!tour.finished());
        QVERIFY(tour.step({1.5, 0}, 0.1) == Vec2(0.0));
        QVERIFY(tour.finished());
    }

    void a_closed_feature_is_begun_where_it_is_nearest_and_walked_the_way_it_was_drawn() {
        const Polyline square{{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, true};
        GuidedTour tour(square, {10, -1});
        tour.step({10, -1}, 1.0 / 30.0);
        QVERIFY(length(tour.leader() - Vec2(10, 0)) < 1e-9);
        tour.step({10, -1}, 0.1);
        QVERIFY(length(tour.leader() - Vec2(13, 0)) < 1e-9);
        const Polyline open{square.points, false};
        GuidedTour back(open, {-1, 20}); // its end is nearer
        back.step({0, 20}, 1.0 / 30.0);
        back.step({0, 20}, 0.1);
        QVERIFY(length(back.leader() - Vec2(3, 20)) < 1e-9);
    }

    void degenerate_features_end_at_once_and_never_give_a_wild_force() {
        const Polyline dot{{{3, 3}}, true};
        GuidedTour tour(dot, {3, 3});
        for (int i = 0; i < 100; ++i)
            QVERIFY(is_finite(tour.step({3, 3}, 0.001)));
        QVERIFY(tour.finished());
        GuidedTour other(dot, {0, 0});
        QVERIFY(other.step({std::nan(""), 0}, 0.001) == Vec2(0.0));
        QVERIFY(is_finite(other.step({0, 0}, -1.0)));
    }
};

} // namespace guided_tour_test

TP_TEST(guided_tour_test, GuidedTourTest, nothing)
#include "guided_tour_test.moc"
