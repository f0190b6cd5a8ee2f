// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/pantograph.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

namespace pantograph_test {

using namespace tp;

namespace {

constexpr double deg = std::numbers::pi / 180.0;
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

Vec2 any_place(std::mt19937& random, const Pantograph& arms, const std::vector<Vec2>& outline) {
    const Vec2 corner = outline[random() % outline.size()];
    return glm::mix(arms.middle(), corner,
                    0.98 * std::sqrt(std::uniform_real_distribution<double>(0.0, 1.0)(random)));
}

double area_cm2(const std::vector<Vec2>& outline) {
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        twice += cross(outline[i], outline[(i + 1) % outline.size()]);
    return 0.005 * twice;
}

} // namespace

class HaplyPantographTest : public QObject {
    Q_OBJECT

    static void both_generations() {
        QTest::addColumn<bool>("third");
        QTest::newRow("first") << false;
        QTest::newRow("third") << true;
    }
    static Pantograph arms_of(bool third) {
        return Pantograph(third ? HaplyGeneration::third : HaplyGeneration::first);
    }

private slots:
    void figures_are_those_of_the_facts() {
        const Pantograph third(HaplyGeneration::third);
        const auto pose = third.pose_at(*third.angles_at({19.0, 100.0}));
        QVERIFY(pose);
        QVERIFY(std::abs(pose->condition - 1.33) < 0.01);
        QVERIFY(std::abs(third.force_in_the_middle() - 1.7) < 0.05);
        QVERIFY(std::abs(third.resolution() - 0.09) < 0.01);
        QVERIFY(std::abs(third.resolution() - // of the coarser encoder, which is the second
                         2.0 * std::numbers::pi / (2048 * 2.5 * 1.0194) * length(pose->column[1])) < 1e-9);
        QVERIFY(std::abs(area_cm2(third.workspace()) - 270.0) < 15.0);
    }

    /// Two circles of the elbows' reach meet in the handle: by hand for arms that stand like a mirror image.
    void the_reference_pose_is_where_two_circles_meet() {
        const Pantograph third(HaplyGeneration::third);
        const auto pose = third.pose_at(third.reference_deg());
        QVERIFY(pose);
        const double half = 19.0 - 70.0 * std::cos(97.23 * deg);
        QVERIFY(length(pose->place -
                       Vec2(19.0, 70.0 * std::sin(97.23 * deg) + std::sqrt(8100.0 - half * half))) < 1e-9);
        const Pantograph first(HaplyGeneration::first);
        const auto folded = first.pose_at(first.reference_deg());
        QVERIFY(folded);
        const double apart = 70.0 * std::cos(61.0 * deg);
        QVERIFY(length(folded->place -
                       Vec2(0.0, std::sqrt(8100.0 - apart * apart) - 70.0 * std::sin(61.0 * deg))) < 1e-9);
    }

    void places_and_angles_are_each_others_inverse_data() { both_generations(); }
    void places_and_angles_are_each_others_inverse() {
        QFETCH(bool, third);
        const Pantograph arms = arms_of(third);
        const std::vector<Vec2> outline = arms.workspace();
        std::mt19937 random(3);
        for (int i = 0; i < 500; ++i) {
            const Vec2 place = any_place(random, arms, outline);
            const auto angles = arms.angles_at(place);
            QVERIFY(angles);
            const auto pose = arms.pose_at(*angles);
            QVERIFY(pose && length(pose->place - place) < 1e-9);
        }
        const auto back = arms.angles_at(arms.pose_at(arms.reference_deg())->place);
        QVERIFY(back && std::abs((*back)[0] - arms.reference_deg()[0]) < 1e-9 &&
                std::abs((*back)[1] - arms.reference_deg()[1]) < 1e-9);
    }

    void the_jacobian_is_what_small_turns_do_data() { both_generations(); }
    void the_jacobian_is_what_small_turns_do() {
        QFETCH(bool, third);
        const Pantograph arms = arms_of(third);
        const std::vector<Vec2> outline = arms.workspace();
        std::mt19937 random(4);
        constexpr double small = 1e-4; // degrees
        for (int i = 0; i < 500; ++i) {
            const std::array<double, 2> angles = *arms.angles_at(any_place(random, arms, outline));
            const auto pose = arms.pose_at(angles);
            for (std::size_t k = 0; k < 2; ++k) {
                std::array<double, 2> more = angles, less = angles;
                more[k] += small;
                less[k] -= small;
                const Vec2 slope =
                    (arms.pose_at(more)->place - arms.pose_at(less)->place) / (2.0 * small * deg);
                QVERIFY(length(slope - pose->column[k]) < 1e-3);
            }
        }
    }

    void torques_do_the_work_of_the_force_data() { both_generations(); }
    void torques_do_the_work_of_the_force() {
        QFETCH(bool, third);
        const Pantograph arms = arms_of(third);
        const std::vector<Vec2> outline = arms.workspace();
        std::mt19937 random(5);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        for (int i = 0; i < 2000; ++i) {
            const std::array<double, 2> angles = *arms.angles_at(any_place(random, arms, outline));
            const auto pose = arms.pose_at(angles);
            const Vec2 force = 0.3 * Vec2(any(random), any(random));
            const std::array<double, 2> torque = arms.torques(angles, force);
            for (std::size_t k = 0; k < 2; ++k)
                QVERIFY(std::abs(torque[k] - 1e-3 * glm::dot(pose->column[k], force)) < 1e-12);
        }
    }

    void a_force_beyond_the_motors_keeps_its_direction_data() { both_generations(); }
    void a_force_beyond_the_motors_keeps_its_direction() {
        QFETCH(bool, third);
        const Pantograph arms = arms_of(third);
        const std::vector<Vec2> outline = arms.workspace();
        std::mt19937 random(6);
        for (int i = 0; i < 2000; ++i) {
            const std::array<double, 2> angles = *arms.angles_at(any_place(random, arms, outline));
            const double way = 1e-3 * static_cast<double>(random() % 6283);
            const Vec2 force(60.0 * std::cos(way), 60.0 * std::sin(way));
            const std::array<double, 2> torque = arms.torques(angles, force);
            const std::array<double, 2> small = arms.torques(angles, 1e-3 * force);
            QVERIFY(std::max(std::abs(torque[0]), std::abs(torque[1])) <= Pantograph::greatest_torque);
            QVERIFY(std::max(std::abs(torque[0]), std::abs(torque[1])) > Pantograph::greatest_torque - 1e-9);
            QVERIFY(std::abs(torque[0] * small[1] - torque[1] * small[0]) < 1e-9);
            QVERIFY(torque[0] * small[0] >= 0.0 && torque[1] * small[1] >= 0.0);
        }
    }

    void hard_poses_are_no_places_and_pull_nothing_data() {
        QTest::addColumn<double>("first_deg");
        QTest::addColumn<double>("second_deg");
        QTest::addColumn<bool>("place");
        QTest::newRow("elbows_too_far_apart") << 180.0 << 0.0 << true; // 38 + 140 mm < 180: just reachable
        QTest::newRow("not_a_number") << nan_value << 80.0 << false;
        QTest::newRow("the_other_not_a_number") << 100.0 << nan_value << false;
        QTest::newRow("infinite") << 100.0 << std::numeric_limits<double>::infinity() << false;
        QTest::newRow("coincident_elbows")
            << std::acos(19.0 / 70.0) / deg << 180.0 - std::acos(19.0 / 70.0) / deg << false;
    }
    void hard_poses_are_no_places_and_pull_nothing() {
        QFETCH(double, first_deg);
        QFETCH(double, second_deg);
        QFETCH(bool, place);
        const Pantograph arms(HaplyGeneration::third);
        const std::array<double, 2> angles{first_deg, second_deg};
        const auto pose = arms.pose_at(angles);
        QCOMPARE(pose.has_value(), place);
        const std::array<double, 2> torque = arms.torques(angles, {0.5, 0.5});
        if (!place)
            QVERIFY(torque[0] == 0.0 && torque[1] == 0.0);
        QVERIFY(std::abs(torque[0]) <= Pantograph::greatest_torque &&
                std::abs(torque[1]) <= Pantograph::greatest_torque);
    }

    /// Where the sine of the angle between the links at the handle is below 0.1.
    void links_that_lie_side_by_side_pull_nothing() {
        const Pantograph arms(HaplyGeneration::third);
        for (const auto& [sine, pulls] :
             {std::pair{0.07, false}, {0.098, false}, {0.102, true}, {0.15, true}}) {
            const double apart = 2.0 * 90.0 * std::sin(0.5 * std::asin(sine)); // the elbows, mm
            const double lean = std::acos((38.0 - apart) / 140.0) / deg;
            const std::array<double, 2> torque = arms.torques({lean, 180.0 - lean}, {0.1, 0.1});
            QCOMPARE(torque != (std::array<double, 2>{}), pulls);
        }
    }

    void an_arm_reaches_from_20_to_160_mm() {
        const Pantograph arms(HaplyGeneration::first); // whose motors stand on one axis
        for (const auto& [reach, reaches] :
             {std::pair{19.99, false}, {20.0, true}, {100.0, true}, {160.0, true}, {160.01, false}})
            QCOMPARE(arms.angles_at({0.0, reach}).has_value(), reaches);
    }

    void the_workspace_goes_as_far_as_it_can_by_eighths_of_a_millimetre_data() { both_generations(); }
    void the_workspace_goes_as_far_as_it_can_by_eighths_of_a_millimetre() {
        QFETCH(bool, third);
        const Pantograph arms = arms_of(third);
        for (const Vec2 corner : arms.workspace()) {
            const double reach = length(corner - arms.middle());
            QVERIFY(reach > 30.0 && std::abs(8.0 * reach - std::round(8.0 * reach)) < 1e-9);
            const Vec2 beyond = arms.middle() + (reach + 0.125) / reach * (corner - arms.middle());
            const auto angles = arms.angles_at(beyond);
            QVERIFY(!angles || beyond.y < 15.0 ||
                    !(arms.pose_at(*angles)->condition < Pantograph::greatest_condition));
        }
    }

    void links_in_one_line_are_singular_and_pull_nothing() {
        // d = 0 and 2·70·cos ≥ 2·90 cannot be; with a base of 38 the distal links lie in one line at h = 2L.
        const Pantograph arms(HaplyGeneration::third);
        const double reach = std::sqrt(180.0 * 180.0); // h
        const double lean = std::acos((reach - 38.0) / 140.0) / deg;
        QVERIFY(std::isnan(lean)); // even stretched sideways these arms cannot: 178 mm < 180 mm
        const std::array<double, 2> nearest{180.0, 0.0};
        QVERIFY(arms.pose_at(nearest)->condition > 4.0);
        // An arm in line with its distal link cannot push along it: singular the other way, and no torque is
        // lost in it.
        const auto stretched = arms.angles_at({159.99, 0.5});
        QVERIFY(stretched);
        QVERIFY(arms.pose_at(*stretched)->condition > 50.0);
        QVERIFY(!arms.angles_at({19.0, 171.0}));
        QVERIFY(!arms.angles_at({nan_value, 100.0}));
        QVERIFY(arms.torques(*arms.angles_at(arms.middle()), {nan_value, 0.0}) == (std::array<double, 2>{}));
    }

    void every_place_of_the_workspace_is_well_conditioned_data() { both_generations(); }
    void every_place_of_the_workspace_is_well_conditioned() {
        QFETCH(bool, third);
        const Pantograph arms = arms_of(third);
        std::mt19937 random(8);
        const std::vector<Vec2> outline = arms.workspace();
        QVERIFY(outline.size() >= 24);
        for (std::size_t i = 0; i < outline.size(); ++i)
            for (int k = 0; k < 200; ++k) {
                const double along = std::uniform_real_distribution<double>(0.0, 1.0)(random);
                const double out = std::sqrt(std::uniform_real_distribution<double>(0.0, 1.0)(random));
                const Vec2 edge = glm::mix(outline[i], outline[(i + 1) % outline.size()], along);
                const Vec2 place = glm::mix(arms.middle(), edge, out);
                const auto angles = arms.angles_at(place);
                QVERIFY(angles);
                QVERIFY(arms.pose_at(*angles)->condition < 1.2 * Pantograph::greatest_condition);
            }
    }
};

} // namespace pantograph_test

TP_TEST(pantograph_test, HaplyPantographTest, nothing)
#include "pantograph_test.moc"
