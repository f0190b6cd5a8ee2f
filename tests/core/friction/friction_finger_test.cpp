// SPDX-License-Identifier: Apache-2.0
#include "core/friction/friction_finger.hpp"
#include "core/guidance/exact_law.hpp"
#include "scenes.hpp"

#include <QTest>

#include <limits>
#include <numbers>
#include <utility>

using namespace tp;
using namespace tp::testing;

namespace {

constexpr double dt = 0.001;

/// A finger on a scene, moved at a speed, and everything that it was told.
class Walk {
public:
    explicit Walk(const FlatScene& scene, const FrictionChoices& choices = {})
        : exact_(scene, {}), law_(scene, choices), finger_(law_) {}

    /// In a straight line; the first place of all is where the finger is set down.
    void to(Vec2 place, double speed = 80.0) {
        if (!down_) {
            step(place, Vec2(0.0));
            down_ = true;
        }
        const Vec2 from = place_;
        const double way = length(place - from);
        const int steps = std::max(1, static_cast<int>(std::ceil(way / (speed * dt))));
        for (int i = 1; i <= steps; ++i)
            step(from + double(i) / steps * (place - from),
                 way > 0.0 ? speed / way * (place - from) : Vec2(0.0));
    }
    Friction step(Vec2 place, Vec2 velocity) {
        const Friction friction = finger_.step(place, velocity, exact_.at(place));
        events.insert(events.end(), friction.events.begin(), friction.events.end());
        highest = std::max(highest, friction.level);
        place_ = place;
        return friction;
    }
    std::vector<LineEvent> of(LineEventKind kind) const {
        std::vector<LineEvent> list;
        for (const LineEvent& event : events)
            if (event.kind == kind)
                list.push_back(event);
        return list;
    }
    FrictionFinger& finger() { return finger_; }

    std::vector<LineEvent> events;
    double highest = 0.0;

private:
    ExactLaw exact_;
    FrictionLaw law_;
    FrictionFinger finger_;
    bool down_ = false;
    Vec2 place_{0.0};
};

const FlatScene line{{"line"}, {{{{-40, 0}, {40, 0}}, false}}};

} // namespace

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

    void following_is_told_once_and_so_is_leaving() {
        Walk walk(line);
        walk.to({-30, 0.5});
        walk.to({-30.0 + FrictionFinger::along_way_mm - 0.5, 0.5});
        QVERIFY(walk.events.empty() && !walk.finger().following());
        walk.to({20, 0.5});
        QVERIFY(walk.events.size() == 1 && walk.events.front().kind == LineEventKind::followed);
        QVERIFY(walk.finger().following());
        walk.to({22, 1.9}); // not yet
        QCOMPARE(walk.events.size(), std::size_t(1));
        walk.to({23, 2.5});
        QVERIFY(walk.events.size() == 2 && walk.events.back().kind == LineEventKind::left);
        QVERIFY(walk.events.back().contour == 0 && !walk.finger().following());
        walk.to({30, 2.5});
        QCOMPARE(walk.events.size(), std::size_t(2));
    }

    void following_is_within_a_millimetre_of_the_line() {
        for (const auto& [beside, follows] : {std::pair{0.99, true}, {1.01, false}}) {
            Walk walk(line);
            walk.to({-30, beside});
            walk.to({20, beside});
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
        walk.to({14, 0.3}); // and then does
        QCOMPARE(walk.of(LineEventKind::followed).size(), std::size_t(1));
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
            QVERIFY(std::abs(std::abs(corner.place.x) - 14.0) < 0.2 && !corner.to_left);
    }

    void a_corner_is_told_again_once_the_finger_was_away() {
        const FlatScene bent{{"bent"}, {{{{-30, 0}, {0, 0}, {0, 30}}, false}}};
        Walk walk(bent);
        walk.to({-5, 0.2});
        for (int i = 0; i < 3; ++i) {
            walk.to({-0.2, 0.2});
            walk.to({-2.0, 0.2}); // not far enough
        }
        QCOMPARE(walk.of(LineEventKind::corner).size(), std::size_t(1));
        walk.to({-6.0, 0.2});
        walk.to({-0.2, 0.2});
        QCOMPARE(walk.of(LineEventKind::corner).size(), std::size_t(2));
        QVERIFY(walk.of(LineEventKind::corner).back().place == Vec2(0, 0));
        walk.to({6.0, -6.0}); // off all lines, and straight back
        walk.to({0.2, -0.2});
        QCOMPARE(walk.of(LineEventKind::corner).size(), std::size_t(3));
    }

    /// Hops so long that no sample lies between near the line and far from it.
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
        QCOMPARE(walk.step({nan, 0}, {80, 0}).level, 0.0);
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
        FlatScene rings;
        for (int i = 0; i < 41; ++i) {
            rings.names.emplace_back("ring");
            rings.lines.push_back(ellipse({0, 0}, 10.0 + i, 10.0 + i, 16));
        }
        FrictionChoices choices;
        choices.textured = {"ring"};
        choices.texture = 0.5;
        Walk walk(rings, choices);
        walk.step({100, 0}, {0, 0});
        const Friction friction = walk.step({0, 0}, {-80, 0});
        QCOMPARE(friction.events.size(), StepCrossings::room);
        QCOMPARE(friction.left_out, 41 - StepCrossings::room);
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

QTEST_APPLESS_MAIN(FrictionFingerTest)
#include "friction_finger_test.moc"
