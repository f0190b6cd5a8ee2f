// SPDX-License-Identifier: Apache-2.0
// What a finger is told of a line along which it goes, and of its corners.
#include "core/friction/friction_finger.hpp"
#include "scenes.hpp"
#include "test_program.hpp"
#include "walk.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace following_test {

using namespace tp;
using namespace tp::testing;

namespace {

const FlatScene bent{{"bent"}, {{{{-30, 0}, {0, 0}, {0, 30}}, false}}};

} // namespace

class FollowingTest : public QObject {
    Q_OBJECT
private slots:
    void following_is_told_once_and_so_is_leaving() {
        Walk walk(line);
        walk.to({-30, 0.5});
        walk.to({-26.1, 0.5});
        QVERIFY(walk.events.empty() && !walk.finger().following());
        walk.to({-25.9, 0.5});
        QVERIFY(walk.events.size() == 1 && walk.events.front().kind == LineEventKind::followed);
        QVERIFY(walk.finger().following());
        walk.to({20, 0.5});
        walk.to({22, 2.0}); // not yet
        QCOMPARE(walk.events.size(), std::size_t(1));
        walk.to({22, 2.01});
        QVERIFY(walk.events.size() == 2 && walk.events.back().kind == LineEventKind::left);
        QVERIFY(walk.events.back().contour == 0 && !walk.finger().following());
        walk.to({30, 2.5});
        QCOMPARE(walk.events.size(), std::size_t(2));
    }

    void who_follows_or_leaves_is_told_which_line_where_and_how_fast() {
        const FlatScene two{{"other", "line"},
                            {{{{-40, 30}, {40, 30}}, false}, {{{-40, 0}, {-20, 0}, {40, 0}}, false}}};
        Walk walk(two);
        walk.to({-10, 0.5});
        walk.to({0, 0.5}, 50.0);
        walk.to({0, 3.0}, 5.0);
        QCOMPARE(walk.events.size(), std::size_t(2));
        const LineEvent& followed = walk.events.front();
        const LineEvent& left = walk.events.back();
        QVERIFY(followed.kind == LineEventKind::followed && left.kind == LineEventKind::left);
        QVERIFY(std::abs(followed.place.x + 6.0) < 0.06 && followed.place.y == 0.5);
        QVERIFY(std::abs(left.place.y - 2.0) < 0.006 && left.place.x == 0.0);
        QVERIFY(std::abs(followed.speed - 50.0) < 1e-9 && std::abs(left.speed - 5.0) < 1e-9);
        QVERIFY(followed.share == 1.0 && std::abs(left.share - 0.75) < 1e-9);
        for (const LineEvent& event : walk.events)
            QVERIFY(event.contour == 1 && event.segment == 1 && event.angle == 0.0 && !event.to_left);
    }

    void following_is_within_a_millimetre_of_the_line() {
        for (const auto& [beside, follows] : {std::pair{1.0, true}, {1.01, false}}) {
            Walk walk(line);
            walk.to({-30, beside});
            walk.to({20, beside});
            QCOMPARE(walk.finger().following(), follows);
        }
    }

    void a_step_as_long_as_it_takes_to_follow_a_line_follows_it() {
        for (const auto& [way, follows] : {std::pair{4.0, true}, {3.9, false}}) {
            Walk walk(line);
            walk.step({0, 0.5}, {80, 0});
            walk.step({way, 0.5}, {80, 0});
            QCOMPARE(walk.finger().following(), follows);
        }
    }

    void of_the_way_nine_tenths_are_along_the_line() {
        for (const auto& [degrees, follows] : {std::pair{24.0, true}, {28.0, false}, {45.0, false}}) {
            Walk walk(line);
            const double along = 1.8 / std::tan(degrees * std::numbers::pi / 180.0);
            for (int i = 0; i < 8; ++i)
                walk.to({along * i - 30.0, i % 2 == 0 ? 0.9 : -0.9});
            QCOMPARE(walk.finger().following(), follows);
        }
    }

    void who_crosses_to_and_fro_does_not_follow() {
        Walk walk(line);
        walk.to({0, 0.9});
        for (int i = 0; i < 20; ++i) {
            walk.to({0.1 * i, -0.9});
            walk.to({0.1 * i, 0.9});
        }
        QCOMPARE(walk.of(LineEventKind::crossed).size(), std::size_t(40));
        QVERIFY(walk.of(LineEventKind::followed).empty());
        // And then does: of the way across a tenth is remembered after 4 mm · ln 10.
        walk.to({1.9 + 8.0, 0.9});
        QVERIFY(walk.of(LineEventKind::followed).empty());
        walk.to({1.9 + 10.0, 0.9});
        QCOMPARE(walk.of(LineEventKind::followed).size(), std::size_t(1));
    }

    void a_finger_that_is_lifted_begins_anew() {
        Walk walk(line);
        walk.to({-30, 0.5});
        for (int i = 1; i <= 5; ++i) {
            walk.to({-30 + 3.0 * i, 0.5});
            walk.finger().lift();
        }
        QVERIFY(walk.events.empty());
    }

    void a_round_along_an_eye_is_followed_and_has_two_corners() {
        const FlatScene eye{{"eye"}, {ellipse({0, 0}, 14, 5, 200)}};
        Walk walk(eye);
        for (int i = 0; i <= 400; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i + 100.0) / 400.0;
            walk.to({14.3 * std::cos(angle), 5.3 * std::sin(angle)});
        }
        QCOMPARE(walk.of(LineEventKind::followed).size(), std::size_t(1));
        QVERIFY(walk.of(LineEventKind::left).empty() && walk.of(LineEventKind::crossed).empty());
        const auto corners = walk.of(LineEventKind::corner);
        QCOMPARE(corners.size(), std::size_t(2));
        for (const LineEvent& corner : corners)
            QVERIFY(std::abs(std::abs(corner.place.x) - 14.0) < 0.2);
    }

    void a_corner_is_told_again_once_the_finger_was_away() {
        Walk walk(bent);
        walk.to({-5, 0.0});
        for (int i = 0; i < 3; ++i) {
            walk.to({-0.2, 0.0});
            walk.to({-3.0, 0.0}); // not far enough
        }
        QCOMPARE(walk.of(LineEventKind::corner).size(), std::size_t(1));
        walk.to({-3.1, 0.0});
        walk.to({-0.2, 0.0});
        QCOMPARE(walk.of(LineEventKind::corner).size(), std::size_t(2));
        walk.to({6.0, -6.0}); // off all lines, and straight back
        walk.to({0.2, -0.2});
        QCOMPARE(walk.of(LineEventKind::corner).size(), std::size_t(3));
    }

    void a_corner_is_passed_within_one_and_a_half_millimetres() {
        for (const auto& [beside, passes] : {std::pair{1.5, true}, {1.51, false}}) {
            Walk walk(bent);
            walk.to({5, 0});
            walk.to({beside, 0});
            QCOMPARE(walk.of(LineEventKind::corner).size(), passes ? std::size_t(1) : std::size_t(0));
        }
    }

    void a_corner_is_told_with_its_place_its_line_and_how_fast_the_finger_passes() {
        const FlatScene two{{"other", "bent"}, {{{{-40, -30}, {40, -30}}, false}, bent.lines[0]}};
        Walk walk(two);
        walk.to({3, 0.5});
        walk.to({0.2, 0.5}, 4.0);
        QCOMPARE(walk.events.size(), std::size_t(1));
        const LineEvent& corner = walk.events.front();
        QVERIFY(corner.kind == LineEventKind::corner && corner.place == Vec2(0, 0));
        QVERIFY(corner.contour == 1 && corner.segment == 1 && corner.angle == 0.0 && !corner.to_left);
        QVERIFY(std::abs(corner.speed - 4.0) < 1e-9 && std::abs(corner.share - 0.5) < 1e-9);
    }

    void of_two_corners_that_are_near_each_is_told() {
        const FlatScene step{{"step"}, {{{{-30, 0}, {0, 0}, {0, 2.5}, {30, 2.5}}, false}}};
        Walk walk(step);
        walk.to({-5, 0});
        walk.to({-0.1, 0});
        walk.to({0.1, 2.4});
        const auto corners = walk.of(LineEventKind::corner);
        QCOMPARE(corners.size(), std::size_t(2));
        QVERIFY(corners[0].place == Vec2(0, 0) && corners[1].place == Vec2(0, 2.5));
    }

    void who_rests_on_a_corner_is_told_of_it_when_moving_and_again_when_set_down_again() {
        Walk walk(bent);
        for (std::size_t times = 0; times < 3; ++times) {
            walk.finger().lift();
            for (int i = 0; i < 3; ++i)
                walk.step({0.1, 0.1}, {0, 0});
            QCOMPARE(walk.of(LineEventKind::corner).size(), times);
            walk.step({0.2, 0.1}, {80, 0});
            QCOMPARE(walk.of(LineEventKind::corner).size(), times + 1);
        }
    }

    /// As when the machine has stood still: one step may be farther than it takes to follow a line.
    void a_step_beside_a_line_or_to_another_one_follows_none() {
        Walk beside(line);
        for (const double x : {-20.0, -14.0, -8.0})
            beside.step({x, 1.2}, {80.0, 0.0});
        QVERIFY(beside.of(LineEventKind::followed).empty());
        const FlatScene two{{"one", "other"}, {{{{-40, 0}, {-10, 0}}, false}, {{{10, 0}, {40, 0}}, false}}};
        Walk between(two);
        between.step({-12.0, 0.0}, Vec2(0.0));
        between.step({12.0, 0.0}, {80.0, 0.0});
        QVERIFY(between.of(LineEventKind::followed).empty());
    }

    /// Hops so long that no sample lies between near the line and far from it.
    void way_before_a_hop_does_not_count_as_following() {
        Walk walk(line);
        for (int i = 0; i < 3; ++i) {
            const double x = (FrictionFinger::along_way_mm - 0.5) * i;
            walk.step({x, 0.9}, {80, 0});
            walk.to({x + FrictionFinger::along_way_mm - 0.5, 0.9});
            walk.step({x + FrictionFinger::along_way_mm - 0.5, 1.6}, {80, 0});
        }
        QVERIFY(walk.of(LineEventKind::followed).empty());
    }

    void a_line_that_becomes_another_is_left() {
        const FlatScene two{{"a", "b"}, {{{{-40, 0}, {0, 0}}, false}, {{{0, 0}, {40, 0}}, false}}};
        Walk walk(two);
        walk.to({-20, 0.1});
        walk.to({20, 0.1});
        const auto followed = walk.of(LineEventKind::followed);
        QVERIFY(followed.size() == 2 && followed[0].contour == 0 && followed[1].contour == 1);
        const auto left = walk.of(LineEventKind::left);
        QVERIFY(left.size() == 1 && left[0].contour == 0 && left[0].segment == 0);
    }

    /// The most that one step can tell of: all crossings for which there is room, a line left, a corner reached.
    void a_step_in_which_everything_happens_tells_everything() {
        FlatScene fence{{"followed", "bent"},
                        {{{{-40, 0}, {0, 0}}, false}, {{{30, 5}, {30, 0}, {60, 0}}, false}}};
        for (int i = 0; i < 40; ++i) {
            const double x = 10.0 + 0.1 * i;
            fence.names.emplace_back("post");
            fence.lines.push_back({{{x, -5}, {x, 5}}, false});
        }
        Walk walk(fence);
        walk.to({-20, 0.5});
        walk.to({-1, 0.5});
        QVERIFY(walk.finger().following());
        const Friction friction = walk.step({29.5, 0.5}, {80, 0});
        QCOMPARE(friction.events.size(), StepCrossings::room + 2);
        QVERIFY(friction.events[0].kind == LineEventKind::crossed && friction.events[0].contour == 2);
        QVERIFY(friction.events[StepCrossings::room].kind == LineEventKind::left);
        QVERIFY(friction.events.back().kind == LineEventKind::corner);
        QCOMPARE(friction.left_out, 40 - StepCrossings::room);
        const Friction next = walk.step({29.51, 0.5}, {80, 0});
        QVERIFY(next.events.empty());
        QCOMPARE(next.left_out, std::size_t(0));
    }
};

} // namespace following_test

TP_TEST(following_test, FollowingTest, nothing)
#include "following_test.moc"
