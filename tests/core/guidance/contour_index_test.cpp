// SPDX-License-Identifier: Apache-2.0
#include "brute_force.hpp"
#include "core/guidance/contour_index.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

namespace contour_index_test {

using namespace tp;
using namespace tp::testing;

class ContourIndexTest : public QObject {
    Q_OBJECT
private slots:
    void equals_brute_force_on_random_scenes() {
        std::mt19937 random(1);
        for (int round = 0; round < 300; ++round) {
            const FlatScene scene = random_scene(random);
            const ContourIndex index(scene);
            for (int k = 0; k < 50; ++k) {
                const Vec2 p = random_point(random);
                const Nearest nearest = index.nearest(p);
                QVERIFY(nearest.found());
                QVERIFY(std::abs(nearest.distance - true_distance(scene, p)) < 1e-9);
                QVERIFY(std::abs(length(nearest.point - p) - nearest.distance) < 1e-9);
                const Polyline& line = scene.lines[static_cast<std::size_t>(nearest.contour)];
                QVERIFY(distance_to(line, nearest.point) < 1e-9);
            }
        }
    }

    void order_and_direction_of_the_input_change_nothing() {
        std::mt19937 random(2);
        for (int round = 0; round < 100; ++round) {
            FlatScene scene = random_scene(random);
            scene.names.push_back("a twin"); // coincides with the first line: only names can break the tie
            scene.lines.push_back(scene.lines.front());
            const FlatScene other = shuffled(scene, random);
            const ContourIndex index(scene);
            const ContourIndex other_index(other);
            for (int k = 0; k < 50; ++k) {
                const Vec2 p = random_point(random);
                const Nearest a = index.nearest(p);
                const Nearest b = other_index.nearest(p);
                QVERIFY(a.point == b.point);
                QVERIFY(a.distance == b.distance);
                QCOMPARE(scene.names[static_cast<std::size_t>(a.contour)],
                         other.names[static_cast<std::size_t>(b.contour)]);
            }
        }
    }

    void finger_equidistant_from_two_lines_follows_the_tie_rule() {
        FlatScene scene;
        scene.names = {"right", "left"};
        scene.lines = {{{{3, -5}, {3, 5}}, false}, {{{-3, -5}, {-3, 5}}, false}};
        const Nearest nearest = ContourIndex(scene).nearest({0, 0});
        QCOMPARE(nearest.distance, 3.0);
        QCOMPARE(nearest.point.x, -3.0);
    }

    void degenerate_segments_are_points() {
        FlatScene scene;
        scene.names = {"dot", "speck"};
        scene.lines = {{{{1, 1}}, true}, {{{5, 5}, {5 + 1e-12, 5}}, false}};
        const ContourIndex index(scene);
        QCOMPARE(index.nearest({1, 2}).distance, 1.0);
        QVERIFY(std::abs(index.nearest({5, 7}).distance - 2.0) < 1e-9);
    }

    void far_coordinates_keep_their_distance() {
        FlatScene scene;
        scene.names = {"far"};
        scene.lines = {{{{1e9, 1e9}, {1e9 + 10, 1e9}}, false}};
        QCOMPARE(ContourIndex(scene).nearest({1e9 + 5, 1e9 + 3}).distance, 3.0);
    }

    void what_is_not_finite_is_left_out() {
        const double nan = std::nan("");
        FlatScene scene;
        scene.names = {"broken", "whole"};
        scene.lines = {{{{nan, 0}, {1, 1}, {2, 2}}, false}, {{{10, 0}, {10, 10}}, false}};
        const ContourIndex index(scene);
        QCOMPARE(index.segment_count(), std::size_t(2));
        QVERIFY(!index.nearest({nan, 0}).found());
        QVERIFY(!index.nearest({0, std::numeric_limits<double>::infinity()}).found());
        QVERIFY(!ContourIndex(FlatScene{}).nearest({0, 0}).found());
    }
};

} // namespace contour_index_test

TP_TEST(contour_index_test, ContourIndexTest, nothing)
#include "contour_index_test.moc"
