// SPDX-License-Identifier: Apache-2.0
#include "core/friction/friction_finger.hpp"
#include "scenes.hpp"
#include "test_program.hpp"
#include "walk.hpp"

#include <QTest>

#include <limits>
#include <numbers>
#include <utility>

namespace friction_finger_test {

using namespace tp;
using namespace tp::testing;

class FrictionFingerTest : public QObject {
    Q_OBJECT
private slots:
    void crossing_says_which_line_how_fast_and_at_what_angle() {
        for (const double degrees : {90.0, 60.0, 30.0, 120.0}) {
            Walk walk(line);
            const double angle = degrees * std::numbers::pi / 180.0;
            const Vec2 along(std::cos(angle), std::sin(angle));
            walk.to(-20.0 * along);
            walk.to(20.0 * along, 55.0);
            QCOMPARE(walk.events.size(), std::size_t(1));
            const LineEvent& event = walk.events.front();
            QVERIFY(event.kind == LineEventKind::crossed && event.contour == 0 && event.segment == 0);
            QVERIFY(std::abs(event.speed - 55.0) < 1e-9 && length(event.place) < 1e-9);
            QVERIFY(std::abs(event.angle - std::min(angle, std::numbers::pi - angle)) < 1e-9);
            QVERIFY(event.to_left && event.share == 1.0);
            QCOMPARE(walk.highest, 1.0);
            walk.to(-20.0 * along);
            QVERIFY(walk.events.size() == 2 && !walk.events.back().to_left);
        }
    }

    /// One step may be long: the finger is fast, or the machine has stood still.
    void a_hop_over_a_line_crosses_it() {
        for (const double x : {0.0, 7.0, -1.0})
            for (const double far : {0.5, 10.0, 500.0}) {
                Walk walk(line);
                walk.step({x, -far}, {0, 0});
                walk.step({x, far}, {0, 80});
                QCOMPARE(walk.events.size(), std::size_t(1));
                QVERIFY(walk.events.front().place == Vec2(x, 0));
                QVERIFY(std::abs(walk.events.front().angle - std::numbers::pi / 2.0) < 1e-12);
            }
    }

    void each_line_of_a_wedge_is_told_though_they_are_one() {
        const FlatScene wedge{{"wedge"}, {{{{-1, -5}, {0, 5}, {1, -5}}, false}}};
        Walk walk(wedge);
        walk.step({-3, 0}, {0, 0});
        walk.step({3, 0}, {80, 0});
        QCOMPARE(walk.of(LineEventKind::crossed).size(), std::size_t(2));
    }

    void a_line_is_told_again_when_the_finger_has_been_far_enough_from_where_it_crossed() {
        FrictionChoices choices;
        choices.again_mm = 1.0;
        const FlatScene two{{"one", "two"}, {{{{-40, 0}, {40, 0}}, false}, {{{-40, 0.5}, {40, 0.5}}, false}}};
        Walk walk(two, choices);
        walk.to({0, -5});
        walk.to({0, 0.9}); // over both
        QCOMPARE(walk.events.size(), std::size_t(2));
        for (int i = 0; i < 20; ++i)
            walk.to({0, i % 2 == 0 ? -0.4 : 0.9});
        QCOMPARE(walk.events.size(), std::size_t(2));
        walk.to({3, 0.9}); // along them
        walk.to({3, -0.4});
        QCOMPARE(walk.of(LineEventKind::crossed).size(), std::size_t(4));
        walk.to({3, -2});
        walk.to({3, 2});
        walk.finger().lift();
        walk.to({3, -2});
        walk.to({3, 2});
        QVERIFY(walk.of(LineEventKind::crossed).size() >= 8);
    }

    void a_finger_that_was_lifted_is_told_again_at_once() {
        FrictionChoices choices;
        choices.again_mm = 1.0;
        Walk walk(line, choices);
        walk.to({0, -0.5});
        walk.to({0, 0.5});
        walk.finger().lift();
        walk.to({0, 0.5});
        walk.to({0, -0.5});
        QCOMPARE(walk.of(LineEventKind::crossed).size(), std::size_t(2));
    }

    void as_far_as_that_is_not_far_enough_yet() {
        FrictionChoices choices;
        choices.again_mm = 1.0;
        Walk walk(line, choices);
        walk.to({0, -1});
        walk.to({0, 1});
        walk.to({0, -0.5});
        QCOMPARE(walk.of(LineEventKind::crossed).size(), std::size_t(1));
        walk.to({0, 1.1});
        walk.to({0, -0.5});
        QCOMPARE(walk.of(LineEventKind::crossed).size(), std::size_t(2));
    }

    void of_many_lines_at_one_place_four_are_remembered() {
        FrictionChoices choices;
        choices.again_mm = 1.0;
        FlatScene bundle;
        for (int i = 0; i < 6; ++i) {
            const double y = 0.05 * i;
            bundle.names.push_back("line " + std::to_string(i));
            bundle.lines.push_back({{{-40, y}, {40, y}}, false});
        }
        Walk walk(bundle, choices);
        walk.to({0, -0.2});
        walk.to({0, 0.4});
        QCOMPARE(walk.of(LineEventKind::crossed).size(), std::size_t(6));
        walk.to({0, -0.2});
        QCOMPARE(walk.of(LineEventKind::crossed).size(), std::size_t(8));
    }

    void what_was_too_slow_to_be_felt_is_told_when_it_is() {
        FrictionChoices choices;
        choices.again_mm = 1.0;
        Walk walk(line, choices);
        walk.to({0, -0.5}, 1.0);
        walk.to({0, 0.1}, 1.0);
        walk.to({0, -0.5}, 80.0);
        QVERIFY(walk.events.size() == 2 && walk.events.back().share == 1.0);
    }

    void a_slow_finger_is_told_that_nothing_is_to_be_felt_of_it() {
        Walk walk(line);
        walk.to({0, -1}, 1.0);
        walk.to({0, 1}, 1.0);
        QVERIFY(walk.events.size() == 1 && walk.events.front().share == 0.0);
        QCOMPARE(walk.highest, 0.0);
    }

    void who_stops_on_a_line_feels_nothing_any_more() {
        Walk walk(line);
        walk.to({0, -10});
        walk.to({0, 0});
        QCOMPARE(walk.highest, 1.0);
        QCOMPARE(walk.step({0, 0}, {0, 0}).level, 0.0);
    }

    void what_a_lifted_finger_passes_is_not_crossed() {
        Walk walk(line);
        walk.to({-20, 0.5});
        walk.to({0, 0.5});
        QVERIFY(walk.finger().following());
        walk.finger().lift();
        QVERIFY(!walk.finger().following());
        const std::size_t before = walk.events.size();
        walk.step({0, -5}, {0, 0});
        QCOMPARE(walk.events.size(), before);
        const double nan = std::nan("");
        const Friction nothing = walk.step({nan, 0}, {80, 0});
        QVERIFY(nothing.level == 0.0 && nothing.left_out == 0 && nothing.events.empty());
        walk.step({0, 5}, {0, 0});
        QCOMPARE(walk.events.size(), before);
        walk.step({0, -5}, {0, -80});
        QCOMPARE(walk.events.size(), before + 1);
    }

    void the_inside_of_a_feature_is_known_wherever_the_finger_came_in() {
        FlatScene eye{{"eye", "rim"}, {ellipse({0, 0}, 14, 9, 40), ellipse({0, 0}, 14, 9, 40)}};
        FrictionChoices choices;
        choices.textured = {"eye"};
        choices.texture = 0.5;
        choices.width_mm = 0.5;
        std::mt19937 random(4);
        Walk walk(eye, choices);
        const FrictionLaw law(eye, choices);
        for (int i = 0; i < 300; ++i) {
            const Vec2 place = random_point(random, 16.0);
            if (i % 7 == 3)
                walk.finger().lift();
            if (i % 3 == 0)
                walk.to(place);
            const Vec2 stripe(2.0 * std::round(0.5 * place.x), place.y);
            walk.step(stripe, {80, 0});
            const double level = walk.step(stripe + Vec2(0.0, 1e-3), {0, 80}).level;
            if (ExactLaw(eye, {}).at(stripe).distance > 0.3)
                QVERIFY(std::abs(level - (law.in_texture(stripe) ? 0.5 : 0.0)) < 1e-6);
        }
    }

    void a_step_over_more_lines_than_there_is_room_for_still_ends_inside() {
        constexpr std::size_t most = StepCrossings::room;
        FlatScene rings;
        for (std::size_t i = 0; i < most + 1; ++i) { // their number is odd, that of those told is even
            rings.names.emplace_back("ring");
            rings.lines.push_back(ellipse({0, 0}, 10.0 + double(i), 10.0 + double(i), 16));
        }
        FrictionChoices choices;
        choices.textured = {"ring"};
        choices.texture = 0.5;
        Walk walk(rings, choices);
        walk.step({100, 0}, {0, 0});
        const Friction friction = walk.step({0, 0}, {-80, 0});
        QCOMPARE(friction.events.size(), most);
        QCOMPARE(friction.left_out, std::size_t(1));
        QVERIFY(std::abs(friction.level - 0.5) < 1e-12);
    }

    void hostile_places_and_scenes_are_answered() {
        const double hostile[] = {
            0.0, 1e-300, 1e9, 1e308, -1e308, std::nan(""), std::numeric_limits<double>::infinity()};
        std::mt19937 random(5);
        for (int round = 0; round < 20; ++round) {
            Walk walk(round == 0 ? FlatScene{} : random_scene(random));
            for (const double x : hostile)
                for (const double y : hostile) {
                    const double level = walk.step({x, y}, {y, x}).level;
                    QVERIFY(level >= 0.0 && level <= 1.0);
                }
        }
    }
};

} // namespace friction_finger_test

TP_TEST(friction_finger_test, FrictionFingerTest, nothing)
#include "friction_finger_test.moc"
