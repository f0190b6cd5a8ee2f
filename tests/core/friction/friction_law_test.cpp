// SPDX-License-Identifier: Apache-2.0
#include "core/friction/friction_law.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <limits>

namespace friction_law_test {

using namespace tp;
using namespace tp::testing;

namespace {

const FlatScene line{{"line"}, {{{{-20, 0}, {20, 0}}, false}}};

double moving(const FrictionChoices& choices, double distance) {
    return FrictionLaw(line, choices).moving_level({0, distance}, distance, false);
}

} // namespace

class FrictionLawTest : public QObject {
    Q_OBJECT
private slots:
    void at_2_mm_a_second_a_finger_rests_and_from_6_on_it_feels_all() {
        const FrictionLaw law(line, {});
        QCOMPARE(law.share_at(2.0), 0.0);
        QVERIFY(law.share_at(2.01) > 0.0 && law.share_at(5.99) < 1.0);
        QCOMPARE(law.share_at(4.0), 0.5);
        QCOMPARE(law.share_at(6.0), 1.0);
    }

    /// As in friction_choices.hpp: what a person feels who has chosen nothing.
    void what_nobody_chose_is_rounded_2_mm_wide_and_as_strong_as_can_be() {
        const FrictionChoices usual;
        QCOMPARE(moving(usual, 0.0), 1.0);
        QCOMPARE(moving(usual, 0.5), 0.5);
        QVERIFY(moving(usual, 0.25) > 0.8 && moving(usual, 0.99) > 0.0); // a tent has 0.75 there
        QCOMPARE(moving(usual, 1.0), 0.0);
        const FrictionLaw law(line, usual);
        for (const double stripe : {0.0, 2.0, -4.0}) {
            QVERIFY(std::abs(law.moving_level({stripe, 9}, 9.0, true) - 0.4) < 1e-12);
            QVERIFY(std::abs(law.moving_level({stripe + 0.5, 9}, 9.0, true) - 0.2) < 1e-12);
            QVERIFY(law.moving_level({stripe + 1.0, 9}, 9.0, true) < 1e-12);
        }
        QCOMPARE(law.again_mm(), 0.0);
    }

    void a_flat_ridge_ends_at_its_edge_among_stripes_too() {
        FrictionChoices choices;
        choices.ridge = RidgeShape::flat;
        const FrictionLaw law(line, choices);
        const double between_stripes = 1.0;
        QCOMPARE(law.moving_level({between_stripes, 0.99}, 0.99, true), 1.0);
        QCOMPARE(law.moving_level({between_stripes, 1.0}, 1.0, true), 0.0);
    }

    void a_ridge_is_as_high_and_wide_and_shaped_as_chosen() {
        FrictionChoices choices;
        choices.width_mm = 4.0;
        choices.strength = 0.8;
        for (const auto& [shape, middle, half] :
             {std::tuple(RidgeShape::flat, 0.8, 0.8), std::tuple(RidgeShape::tent, 0.8, 0.4),
              std::tuple(RidgeShape::rounded, 0.8, 0.4)}) {
            choices.ridge = shape;
            QVERIFY(std::abs(moving(choices, 0.0) - middle) < 1e-12);
            QVERIFY(std::abs(moving(choices, 1.0) - half) < 1e-12);
            QCOMPARE(moving(choices, 2.0), 0.0);
            QCOMPARE(moving(choices, 50.0), 0.0);
            double before = 1.0;
            for (double r = 0.0; r < 3.0; r += 0.01) {
                QVERIFY(moving(choices, r) <= before);
                before = moving(choices, r);
            }
        }
        choices.ridge = RidgeShape::rounded; // level at the edge and in the middle
        QVERIFY(moving(choices, 1.99) < 1e-3 && moving(choices, 0.01) > 0.8 - 1e-3);
        QVERIFY(std::abs(moving(choices, 0.5) - 0.8 * 27.0 / 32.0) < 1e-12);
    }

    void a_resting_finger_feels_nothing() {
        FrictionChoices choices;
        choices.rest_mm_s = 3.0;
        choices.moving_mm_s = 5.0;
        const FrictionLaw law(line, choices);
        for (const double speed : {0.0, 1.0, 3.0, -1.0, std::nan("")})
            QCOMPARE(law.share_at(speed), 0.0);
        QCOMPARE(law.share_at(4.0), 0.5);
        for (const double speed : {5.0, 80.0, std::numeric_limits<double>::infinity()})
            QCOMPARE(law.share_at(speed), 1.0);
    }

    void stripes_lie_in_textured_features_only() {
        const FlatScene eyes{
            {"left_eye", "right_eye", "open"},
            {ellipse({-20, 0}, 8, 8, 60), ellipse({20, 0}, 8, 8, 60), {{{0, 0}, {1, 1}}, false}}};
        FrictionChoices choices;
        choices.textured = {"left_eye", "open", "no such line"};
        choices.texture = 0.5;
        choices.texture_mm = 3.0;
        const FrictionLaw law(eyes, choices);
        QVERIFY(law.in_texture({-20, 1}) && !law.in_texture({20, 1}) && !law.in_texture({-5, 1}));
        QVERIFY(law.bounds_texture(0) && !law.bounds_texture(1) && !law.bounds_texture(2));
        for (const double stripe : {-21.0, 0.0, 3.0, 300.0}) {
            QVERIFY(std::abs(law.moving_level({stripe, 1}, 9.0, true) - 0.5) < 1e-9);
            QVERIFY(std::abs(law.moving_level({stripe + 0.75, 1}, 9.0, true) - 0.25) < 1e-9);
            QVERIFY(std::abs(law.moving_level({stripe - 0.75, 1}, 9.0, true) - 0.25) < 1e-9);
            QVERIFY(law.moving_level({stripe + 1.5, 1}, 9.0, true) < 1e-9);
            QCOMPARE(law.moving_level({stripe, 1}, 9.0, false), 0.0);
            QVERIFY(law.moving_level({stripe + 1.5, 1}, 0.0, true) == 1.0); // a ridge goes over it
        }
        choices.textured.clear();
        QVERIFY(!FrictionLaw(eyes, choices).in_texture({-20, 1}));
    }

    void every_level_is_a_share() {
        std::mt19937 random(1);
        const double hostile[] = {
            0.0, 1e-300, 1e9, 1e308, -1e308, std::nan(""), std::numeric_limits<double>::infinity()};
        for (int round = 0; round < 50; ++round) {
            FrictionChoices choices;
            choices.textured = {"line 0", "line 2"};
            const FrictionLaw law(random_scene(random), choices);
            for (const double x : hostile)
                for (const double d : hostile) {
                    const double level = law.moving_level({x, d}, std::abs(d), round % 2 == 0);
                    QVERIFY(level >= 0.0 && level <= 1.0);
                }
        }
    }

    void corners_are_where_contours_turn() {
        const FlatScene bent{{"bent"}, {{{{-30, 0}, {0, 0}, {0, 30}}, false}}};
        const FrictionLaw law(bent, {});
        QVERIFY(law.corners().nearest({1, 1}).point == Vec2(0, 0));
        QCOMPARE(FrictionLaw(line, {}).corners().segment_count(), std::size_t(0));
    }

    void a_way_that_is_enlarged_is_felt_as_it_is() {
        FrictionChoices choices;
        choices.again_mm = 0.3;
        const FrictionLaw own(line, choices), enlarged(line, choices.enlarged(4.0));
        QCOMPARE(enlarged.again_mm(), 1.2);
        for (const double speed : {1.0, 3.0, 5.0, 7.0})
            QVERIFY(std::abs(enlarged.share_at(4.0 * speed) - own.share_at(speed)) < 1e-12);
        QCOMPARE(enlarged.moving_level({0, 0}, 0.4, false), own.moving_level({0, 0}, 0.4, false));
    }

    void choices_that_cannot_be_are_refused_in_a_sentence() {
        QVERIFY(FrictionChoices{}.problem().empty());
        const auto problem = [](auto change) {
            FrictionChoices choices;
            change(choices);
            return choices.problem();
        };
        const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
        for (const double bad : {0.0, -1.0, nan, inf}) {
            QVERIFY(problem([&](auto& c) { c.width_mm = bad; }).ends_with('.'));
            QVERIFY(problem([&](auto& c) { c.texture_mm = bad; }).ends_with('.'));
        }
        for (const double bad : {-0.01, 1.01, nan}) {
            QVERIFY(problem([&](auto& c) { c.strength = bad; }).ends_with('.'));
            QVERIFY(problem([&](auto& c) { c.texture = bad; }).ends_with('.'));
        }
        for (const double bad : {-1.0, 6.0, nan})
            QVERIFY(problem([&](auto& c) { c.rest_mm_s = bad; }).ends_with('.'));
        for (const double bad : {-0.1, inf, nan})
            QVERIFY(problem([&](auto& c) { c.again_mm = bad; }).ends_with('.'));
        QVERIFY(problem([&](auto& c) { c.moving_mm_s = inf; }).ends_with('.'));
        QVERIFY(problem([&](auto& c) { c.strength = 0.0; }).empty());
        QVERIFY(problem([&](auto& c) { c.width_mm = c.texture_mm = 0.1; }).empty());
        QVERIFY(problem([&](auto& c) { c.rest_mm_s = 0.0; }).empty());
        QVERIFY(ridge_named("flat") == RidgeShape::flat && ridge_named("tent") == RidgeShape::tent);
        QVERIFY(ridge_named("rounded") == RidgeShape::rounded && !ridge_named("steep"));
    }
};

} // namespace friction_law_test

TP_TEST(friction_law_test, FrictionLawTest, nothing)
#include "friction_law_test.moc"
