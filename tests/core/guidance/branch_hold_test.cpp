// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/branch_hold.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

namespace branch_hold_test {

using namespace tp;
using namespace tp::testing;

namespace {

FlatScene two_level_lines() {
    FlatScene scene;
    scene.names = {"upper", "lower"};
    scene.lines = {{{{-50, 3}, {50, 3}}, false}, {{{-50, -3}, {50, -3}}, false}};
    return scene;
}

} // namespace

class BranchHoldTest : public QObject {
    Q_OBJECT
private slots:
    void the_other_line_takes_over_only_when_nearer_by_the_margin() {
        const FlatScene scene = two_level_lines();
        const ExactLaw law(scene, {});
        BranchHold hold(scene, {}, 0.4);
        const auto contour_at = [&](double y) { return hold.hold({1.0, y}, law.at({1.0, y})).contour; };
        QCOMPARE(contour_at(1.0), 0);
        QCOMPARE(contour_at(-0.1), 0); // nearer to the lower one by 0.2 mm
        QCOMPARE(contour_at(-0.19), 0);
        QCOMPARE(contour_at(-0.21), 1);
        QCOMPARE(contour_at(0.19), 1);
        QCOMPARE(contour_at(0.21), 0);
        QCOMPARE(hold.switches(), std::uint64_t(2));
    }

    /// A finger that has just come down holds nothing yet, nor does one that has left all pulls.
    void what_is_touched_first_is_the_nearest_and_no_switch() {
        const FlatScene scene = two_level_lines();
        const ExactLaw law(scene, {});
        BranchHold hold(scene, {}, 0.4);
        const auto contour_at = [&](double y) { return hold.hold({1.0, y}, law.at({1.0, y})).contour; };
        QCOMPARE(contour_at(-0.1), 1);
        QCOMPARE(hold.switches(), std::uint64_t(0));
        contour_at(12.0); // out of reach
        QCOMPARE(contour_at(0.1), 0);
        contour_at(11.0); // where the pull ends
        QCOMPARE(contour_at(-0.1), 1);
        QCOMPARE(hold.switches(), std::uint64_t(0));
        BranchHold exactly(scene, {}, 0.5);
        exactly.hold({1.0, 1.0}, law.at({1.0, 1.0}));
        QCOMPARE(exactly.hold({1.0, -0.25}, law.at({1.0, -0.25})).contour, 0); // nearer by just the margin
    }

    /// What the corner cue adds to the tent is felt on the branch that is held too.
    void what_a_law_adds_is_kept_on_the_branch_held() {
        const FlatScene scene = two_level_lines();
        const ExactLaw law(scene, {});
        BranchHold hold(scene, {}, 0.4);
        hold.hold({1.0, 0.5}, law.at({1.0, 0.5}));
        const Vec2 finger(1.0, -0.1);
        const Guidance alone = hold.hold(finger, law.at(finger));
        Guidance more = law.at(finger);
        more.force += Vec2(0.01, -0.02);
        more.energy -= 0.125;
        const Guidance both = hold.hold(finger, more);
        QVERIFY(length(both.force - alone.force - Vec2(0.01, -0.02)) < 1e-12);
        QVERIFY(std::abs(both.energy - alone.energy + 0.125) < 1e-12);
        QCOMPARE(both.contour, 0);
        QVERIFY(std::abs(both.distance - 3.1) < 1e-12 && both.nearest == Vec2(1.0, 3.0));
        QVERIFY(std::abs(alone.energy - TentProfile{}.energy(3.1)) < 1e-12);
    }

    /// The tip of an open line is where its branch ends: nothing leads from one end to the other.
    void an_open_line_does_not_go_on_at_its_other_end() {
        // A bracket whose ends lie 1 mm apart.
        const FlatScene scene{{"bracket"},
                              {{{{0, 0.5}, {20, 0.5}, {20, 20}, {-20, 20}, {-20, -0.5}, {0, -0.5}}, false}}};
        const ExactLaw law(scene, {});
        BranchHold hold(scene, {}, 0.4);
        QVERIFY(hold.hold({-0.1, 0.2}, law.at({-0.1, 0.2})).nearest.y > 0.0);
        QVERIFY(hold.hold({-0.1, -0.1}, law.at({-0.1, -0.1})).nearest.y > 0.0);
        QVERIFY(hold.hold({-0.1, -0.4}, law.at({-0.1, -0.4})).nearest.y < 0.0);
        QCOMPARE(hold.switches(), std::uint64_t(1));
        QVERIFY(hold.hold({-0.1, 0.1}, law.at({-0.1, 0.1})).nearest.y < 0.0); // and back from its last end
        QVERIFY(hold.hold({-0.1, 0.4}, law.at({-0.1, 0.4})).nearest.y > 0.0);
        QCOMPARE(hold.switches(), std::uint64_t(2));
    }

    void a_trembling_finger_clicks_no_more() {
        const FlatScene scene = two_level_lines();
        const ExactLaw law(scene, {});
        BranchHold none(scene, {}, 0.0);
        BranchHold hold(scene, {}, 0.4);
        std::mt19937 random(1);
        std::normal_distribution<double> tremor(0.0, 0.04);
        for (int i = 0; i < 1000; ++i) {
            const Vec2 finger(1.0, tremor(random));
            none.hold(finger, law.at(finger));
            hold.hold(finger, law.at(finger));
        }
        QVERIFY(none.switches() > 300);
        QCOMPARE(hold.switches(), std::uint64_t(0));
    }

    /// A hand of 500 mm/s that is read every 20 ms; its line is cut finely.
    void a_quick_finger_is_followed_along_its_line() {
        const FlatScene scene{{"line"}, {resampled(Polyline{{{0, 0}, {40, 0}}, false}, 401)}};
        const TentProfile tent;
        const ExactLaw law(scene, tent);
        BranchHold hold(scene, tent, 0.4);
        for (const double x : {1.0, 11.0, 21.0, 11.0, 1.0}) {
            const Guidance felt = hold.hold({x, 1.0}, law.at({x, 1.0}));
            QVERIFY(length(felt.force - law.at({x, 1.0}).force) < 1e-9);
        }
        QCOMPARE(hold.switches(), std::uint64_t(0));
    }

    void the_lids_of_one_eye_are_two_branches() {
        const FlatScene eye{{"eye"}, {ellipse({0, 0}, 14, 5, 200)}};
        const ExactLaw law(eye, {});
        BranchHold hold(eye, {}, 0.4);
        hold.hold({0.0, 1.0}, law.at({0.0, 1.0}));
        const Vec2 below(0.0, -0.15);
        QVERIFY(law.at(below).force.y < 0.0);
        QVERIFY(hold.hold(below, law.at(below)).force.y > 0.0);
        const Vec2 farther(0.0, -0.25);
        QVERIFY(hold.hold(farther, law.at(farther)).force.y < 0.0);
    }

    /// On the inner side of an arc every facet has a foot of its own.
    void one_branch_followed_inside_and_outside_gives_the_exact_force() {
        for (const int facets : {40, 100, 720}) {
            const FlatScene ring{{"ring"}, {ellipse({0, 0}, 30, 30, facets)}};
            const ExactLaw law(ring, {});
            for (const double radius : {26.0, 29.0, 30.5, 34.0}) {
                BranchHold hold(ring, {}, 0.4);
                for (double angle = 0.0; angle < 7.0; angle += 0.003) {
                    const Vec2 finger(radius * std::cos(angle), radius * std::sin(angle));
                    const Guidance exact = law.at(finger);
                    const Guidance held = hold.hold(finger, exact);
                    QVERIFY(std::abs(held.distance - exact.distance) < 1e-9);
                }
                QCOMPARE(hold.switches(), std::uint64_t(0));
            }
        }
    }

    /// What the field gives back round any path is at most what was put in: the energy never jumps up.
    void a_switch_never_raises_the_energy() {
        std::mt19937 random(7);
        for (int round = 0; round < 50; ++round) {
            const FlatScene scene = random_scene(random, 15.0);
            const TentProfile tent;
            const ExactLaw law(scene, tent);
            BranchHold hold(scene, tent, 0.5);
            Vec2 finger = random_point(random, 15.0);
            Vec2 heading = 0.01 * random_point(random, 1.0);
            std::uint64_t switches = 0;
            double energy = hold.hold(finger, law.at(finger)).energy;
            for (int i = 0; i < 5000; ++i) {
                if (i % 100 == 0)
                    heading = 0.01 * random_point(random, 1.0);
                finger += heading;
                if (std::max(std::abs(finger.x), std::abs(finger.y)) > 20.0)
                    heading = -heading;
                const Guidance held = hold.hold(finger, law.at(finger));
                const double most_work = tent.peak() * length(heading) + 1e-12;
                QVERIFY(held.energy <= energy + most_work);
                if (hold.switches() ==
                    switches) // on one branch it is a potential, which moves no faster down
                    QVERIFY(held.energy >= energy - most_work - tent.peak() * 0.5);
                switches = hold.switches();
                energy = held.energy;
                QVERIFY(is_finite(held.force) && length(held.force) <= tent.peak() * (1.0 + 1e-12));
                QVERIFY(held.distance <= law.at(finger).distance + 0.5 + 1e-12 || held.contour < 0);
            }
        }
    }

    void hostile_scenes_and_fingers_end_in_something_finite() {
        const double nan = std::nan("");
        FlatScene scene;
        scene.names = {"specks", "point", "long"};
        scene.lines = {
            {std::vector<Vec2>(2000, Vec2(1, 1)), true}, {{{2, 2}}, false}, {{{-1e9, 3}, {1e9, 3}}, false}};
        const ExactLaw law(scene, {});
        BranchHold hold(scene, {}, 0.5);
        for (const Vec2 finger : {Vec2(1, 1), Vec2(1, 2), Vec2(nan, 0), Vec2(2, 2), Vec2(1e9, 3), Vec2(0, 0)})
            QVERIFY(is_finite(hold.hold(finger, law.at(finger)).force));
    }
};

} // namespace branch_hold_test

TP_TEST(branch_hold_test, BranchHoldTest, nothing)
#include "branch_hold_test.moc"
