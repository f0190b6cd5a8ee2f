// SPDX-License-Identifier: Apache-2.0
#include "frames.hpp"
#include "test_program.hpp"
#include "watched.hpp"

#include <QTest>

#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace adviser_search_test {

using namespace tp;
using namespace tp::testing;

class AdviserSearchTest : public QObject {
    Q_OBJECT
private slots:
    void a_lost_face_is_looked_for_where_it_went() {
        for (const auto& [x, y, advice] :
             {std::tuple{0.9, 0.5, Advice::look_right}, std::tuple{0.1, 0.5, Advice::look_left},
              std::tuple{0.5, 0.85, Advice::look_down}, std::tuple{0.5, 0.1, Advice::look_up}}) {
            Watched watched;
            watched.stare(face_at(x, y));
            const AimInstruction lost = watched.stare(frame_of(0.0, {}));
            QCOMPARE(lost.advice, advice);
            QCOMPARE(lost.faces, 0);
            QVERIFY(!watched.adviser.good());
        }
        AimFace corner; // as far up as to the left of its place
        corner.box = {{0.125, 0.075}, {0.375, 0.325}};
        Watched watched;
        watched.stare(corner);
        QCOMPARE(watched.adviser.framing()->off, Vec2(-0.25));
        QCOMPARE(watched.stare(frame_of(0.0, {})).advice, Advice::look_left);
        Watched front(Aim::middle, {true, false});
        front.stare(face_at(0.9, 0.5));
        QCOMPARE(front.stare(frame_of(0.0, {})).advice, Advice::look_left);
    }

    void a_lost_face_is_looked_for_five_seconds_long() {
        Watched watched;
        watched.stare(face_at(0.5, 0.85));
        const auto way = [&watched](double at) {
            return watched.adviser.advise({}, frame_of(at, {})).advice;
        };
        QCOMPARE(way(10.0), Advice::look_down);
        QCOMPARE(way(14.99), Advice::look_down);
        QCOMPARE(way(15.0), Advice::look_left); // as everybody is who was never there
    }

    void only_who_was_a_fifth_beside_has_gone_off_that_way() {
        const auto looked_for = [](double x) {
            Watched watched;
            watched.stare(face_at(x, 0.45));
            return watched.stare(frame_of(0.0, {})).advice;
        };
        QCOMPARE(looked_for(0.29), Advice::look_left);
        QCOMPARE(looked_for(0.31), Advice::look_right); // that is how looking for somebody begins
        AimFace low;
        low.box = {{0.4, 0.5}, {0.6, 0.8}};
        Watched watched;
        watched.stare(low);
        QCOMPARE(watched.adviser.framing()->off.y, 0.2);
        QCOMPARE(watched.stare(frame_of(0.0, {})).advice, Advice::look_right);
    }

    void who_was_too_large_is_stepped_back_from() {
        const auto looked_for = [](double height) {
            Watched watched;
            watched.stare(face_at(0.5, 0.5, height));
            return watched.stare(frame_of(0.0, {}));
        };
        const AimInstruction back = looked_for(0.8);
        QCOMPARE(back.advice, Advice::farther);
        QCOMPARE(back.amount, 0.9); // a step
        QCOMPARE(back.step, AimStep::some);
        QCOMPARE(looked_for(0.5).advice, Advice::look_right); // as large as may be
    }

    void nobody_yet_is_looked_for_upright_and_on_both_sides() {
        AimFrame tipped = frame_of(0.0, {});
        tipped.elevation_deg = -20.0;
        const AimInstruction up = Watched().see(tipped);
        QCOMPARE(up.advice, Advice::move_up);
        QVERIFY(std::abs(up.amount - 20.0 / 37.0) < 1e-9);
        tipped.elevation_deg = 20.0;
        QCOMPARE(Watched().see(tipped).advice, Advice::move_down);
        Watched watched;
        std::set<Advice> advices;
        tipped.elevation_deg = 3.0;
        QCOMPARE(watched.see(tipped).advice, Advice::look_right);
        for (int i = 0; i < 200; ++i)
            advices.insert(watched.see(tipped).advice);
        QCOMPARE(advices,
                 (std::set{Advice::look_left, Advice::look_right, Advice::look_up, Advice::look_down}));
    }

    /// A round of 15 s; a clock that is set back begins it anew.
    void looking_goes_one_way_then_the_other_as_long_as_it_says() {
        Adviser adviser(Aim::middle, {});
        const auto way = [&adviser](double at) { return adviser.advise({}, frame_of(at, {})).advice; };
        for (const double start : {100.0, 1.0}) {
            QCOMPARE(way(start), Advice::look_right);
            double begins = start;
            for (const auto& [advice, seconds] :
                 {std::pair{Advice::look_right, 2.5}, std::pair{Advice::look_left, 5.0},
                  std::pair{Advice::look_right, 2.5}, std::pair{Advice::look_up, 1.25},
                  std::pair{Advice::look_down, 2.5}, std::pair{Advice::look_up, 1.25},
                  std::pair{Advice::look_right, 2.5}, std::pair{Advice::look_left, 5.0}}) {
                QCOMPARE(way(begins), advice);
                begins += seconds;
                QCOMPARE(way(begins - 0.01), advice);
            }
        }
    }

    void who_was_seen_meanwhile_is_looked_for_from_the_start() {
        Watched watched;
        while (watched.see(frame_of(0.0, {})).advice == Advice::look_right)
            continue;
        watched.stare(face_at(0.5, 0.45)); // in its place: nobody knows which way it went
        AimInstruction now = watched.see(frame_of(0.0, {}));
        while (now.faces > 0)
            now = watched.see(frame_of(0.0, {}));
        QCOMPARE(now.advice, Advice::look_right);
    }

    void eight_degrees_are_upright_enough() {
        const auto see = [](double elevation) {
            AimFrame frame = frame_of(0.0, {});
            frame.elevation_deg = elevation;
            return Watched().see(frame);
        };
        QCOMPARE(see(8.0).advice, Advice::look_right);
        QCOMPARE(see(8.1).advice, Advice::move_down);
        QCOMPARE(see(-8.1).advice, Advice::move_up);
        QCOMPARE(see(14.0).step, AimStep::some);
        QCOMPARE(see(15.0).step, AimStep::much);
    }

    void forgotten_is_as_at_first() {
        Watched watched;
        watched.stare(face_at(0.1, 0.5, 0.8, 20.0));
        watched.forget();
        QVERIFY(!watched.adviser.framing());
        QCOMPARE(watched.adviser.faults(), AimFaultSizes{});
        QVERIFY(!watched.adviser.there(AimFault::size));
        QCOMPARE(watched.adviser.badness(), 0.0);
        QCOMPARE(watched.see(frame_of(0.0, {})).advice, Advice::look_right); // not left, nor a step back
    }

    void forgotten_the_search_begins_anew() {
        Watched watched;
        while (watched.see(frame_of(0.0, {})).advice == Advice::look_right)
            continue;
        watched.forget();
        QCOMPARE(watched.see(frame_of(0.0, {})).advice, Advice::look_right);
    }

    /// A fault that was there ends below its limit, and the advice stays with it; neither holds for one who comes anew.
    void who_comes_anew_is_told_what_is_worst() {
        for (const bool forgotten : {false, true}) {
            const auto then = [forgotten](double x, double tilt) {
                Watched watched;
                watched.stare(face_at(0.62, 0.45)); // beside its place, 1.2 times its limit
                if (forgotten)
                    watched.forget();
                else
                    watched.stare(frame_of(0.0, {}));
                return watched.stare(face_at(x, 0.45, 0.27, tilt)).advice;
            };
            QCOMPARE(then(0.58, 0.0), Advice::ready);
            QCOMPARE(then(0.62, 10.5), Advice::turn_clockwise); // 1.5 times
        }
    }
};

} // namespace adviser_search_test

TP_TEST(adviser_search_test, AdviserSearchTest, nothing)
#include "adviser_search_test.moc"
