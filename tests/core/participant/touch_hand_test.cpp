// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/polyline.hpp"
#include "core/participant/touch_hand.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <functional>
#include <vector>

namespace touch_hand_test {

using namespace tp;

namespace {

constexpr double step_s = 0.005;
const Rect area{{-70, -70}, {70, 70}};

/// A hand, its finger always where it means to be, on a surface that ticks or resists at a straight line along y = 0.
struct Walk {
    TouchHand hand;
    Vec2 place;
    double along = 0.0;      ///< mm between the farthest places near the line
    double near_share = 0.0; ///< of the time within 5 mm of it

    Walk(bool ticks, std::uint64_t seed, double seconds, Vec2 start = {0, 0}, bool on_line = true,
         bool anything = true)
        : hand(person_of(1, 1), area, start, on_line, step_s, seed), place(start) {
        double left = 0.0, right = 0.0;
        int near = 0, steps = 0;
        for (double t = 0.0; t < seconds; t += step_s, ++steps) {
            const Vec2 before = place;
            BareTouch touch;
            place = hand.step(place, now);
            touch.ticked = ticks && (before.y < 0.0) != (place.y < 0.0);
            touch.friction = !ticks && std::abs(place.y) < 0.5 ? 1.0 : 0.0;
            now = anything ? touch : BareTouch{};
            if (std::abs(place.y) < 5.0) {
                ++near;
                left = std::min(left, place.x);
                right = std::max(right, place.x);
            }
        }
        along = right - left;
        near_share = double(near) / steps;
    }

private:
    BareTouch now;
};

} // namespace

class TouchHandTest : public QObject {
    Q_OBJECT
private slots:
    void one_seed_is_one_way_with_every_compiler() {
        TouchHand hand(Person{}, {{-90, -90}, {90, 90}}, {1, 2}, true, 0.001, 7);
        Vec2 at(0.0);
        for (int i = 0; i < 2000; ++i)
            at = hand.step(at, {.ticked = i % 97 == 3});
        QVERIFY2(length(at - Vec2(13.947718, -18.930537)) < 1e-5,
                 qPrintable(QString("%1 %2").arg(at.x, 0, 'f', 6).arg(at.y, 0, 'f', 6)));
    }
    void by_either_it_goes_along_the_line() {
        for (const bool ticks : {true, false}) {
            double along = 0.0;
            for (std::uint64_t seed = 1; seed <= 10; ++seed)
                along += Walk(ticks, seed, 20.0).along / 10.0;
            QVERIFY2(along > 50.0, qPrintable(QString::number(along)));
        }
    }

    void friction_that_stutters_on_one_ridge_is_one_line() {
        const auto way = [](bool stutters) {
            TouchHand hand(person_of(1, 1), area, {0, 0}, true, step_s, 1);
            std::vector<Vec2> places{{0, 0}};
            BareTouch now;
            double gap_s = 0.0;
            for (double t = 0.0; t < 20.0; t += step_s) {
                places.push_back(hand.step(places.back(), now));
                const double y = std::abs(places.back().y);
                gap_s = y < 0.1 ? gap_s + step_s : 0.0; // in the middle of the ridge, and never for long
                now.friction = y < 1.0 && !(stutters && gap_s > 0.0 && gap_s < 0.025) ? 1.0 : 0.0;
            }
            return places;
        };
        QVERIFY(way(true) == way(false));
    }

    void who_feels_nothing_stays_and_circles() {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const Walk walk(true, seed, 10.0, {0, 0}, true, false);
            QVERIFY(walk.along < 35.0 && walk.hand.times_lost() == 0);
        }
    }

    void who_looks_for_a_line_goes_on_until_it_is_met() {
        int met = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const TouchHand fresh(person_of(1, 1), area, {0, 40}, false, step_s, seed);
            QVERIFY(!fresh.following());
            met += Walk(true, seed, 20.0, {0, 40}, false).hand.following() ? 1 : 0;
            QVERIFY(!Walk(true, seed, 20.0, {0, 40}, false, false).hand.following());
        }
        QVERIFY(met >= 18);
    }

    void it_stays_on_the_surface_and_does_the_same_again() {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const Walk one(false, seed, 15.0), again(false, seed, 15.0), other(false, seed + 100, 15.0);
            QVERIFY(one.place == again.place && one.place != other.place);
            QVERIFY(area.contains(one.place));
        }
    }

    void a_line_that_ends_is_lost_and_said_to_be() {
        TouchHand hand(person_of(1, 1), area, {0, 0}, true, step_s, 3);
        Vec2 place{0, 0};
        BareTouch now;
        for (double t = 0.0; t < 60.0; t += step_s) {
            const Vec2 before = place;
            place = hand.step(place, now);
            now = {};
            now.ticked = std::abs(place.x) < 20.0 && (before.y < 0.0) != (place.y < 0.0);
        }
        QVERIFY(hand.times_lost() > 0);
    }
};

} // namespace touch_hand_test

TP_TEST(touch_hand_test, TouchHandTest, nothing)
#include "touch_hand_test.moc"
