// SPDX-License-Identifier: Apache-2.0
#include "brute_crossings.hpp"
#include "core/friction/crossing_finder.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <limits>
#include <random>

namespace crossing_finder_test {

using namespace tp;
using namespace tp::testing;

namespace {

FlatScene one_line(std::vector<Vec2> points, bool closed = false) {
    return {{"line"}, {{std::move(points), closed}}};
}

std::vector<Crossed> found(const CrossingFinder& finder, Vec2 from, Vec2 to) {
    StepCrossings crossings;
    finder.find(from, to, crossings);
    std::vector<Crossed> list;
    for (const LineCrossing& c : crossings.list())
        list.emplace_back(c.contour, c.segment, c.to_left);
    std::sort(list.begin(), list.end());
    return list;
}

/// How often each step of a way crosses, in order.
std::vector<std::size_t> counts(const FlatScene& scene, const std::vector<Vec2>& way) {
    const CrossingFinder finder(scene);
    std::vector<std::size_t> list;
    for (std::size_t i = 1; i < way.size(); ++i)
        list.push_back(found(finder, way[i - 1], way[i]).size());
    return list;
}

struct HardWay {
    const char* name;
    FlatScene scene;
    std::vector<Vec2> way;
    std::vector<std::size_t> crossed; ///< by each step
};

const std::vector<Vec2> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};

const std::vector<HardWay> all_hard_ways{
    {"through_the_middle", one_line({{-5, 0}, {5, 0}}), {{0, -1}, {0, 1}, {0, -1}}, {1, 1}},
    {"past_the_end", one_line({{-5, 0}, {5, 0}}), {{6, -1}, {6, 1}}, {0}},
    {"through_a_vertex", one_line({{-5, 0}, {0, 0}, {5, 1}}), {{0, -1}, {0, 1}, {0, -1}}, {1, 1}},
    {"through_a_vertex_that_is_there_three_times",
     one_line({{-5, 0}, {0, 0}, {0, 0}, {0, 0}, {5, 1}}),
     {{0, -1}, {0, 1}, {0, -1}},
     {1, 1}},
    {"touching_a_vertex_from_below", one_line({{-5, 5}, {0, 0}, {5, 5}}), {{-3, 0}, {3, 0}}, {0}},
    {"touching_a_vertex_from_above", one_line({{-5, -5}, {0, 0}, {5, -5}}), {{-3, 0}, {3, 0}}, {0}},
    {"touching_a_vertex_from_the_left", one_line({{5, 5}, {0, 0}, {5, -5}}), {{0, -3}, {0, 3}}, {0}},
    {"touching_a_vertex_from_the_right", one_line({{-5, 5}, {0, 0}, {-5, -5}}), {{0, -3}, {0, 3}}, {0}},
    {"touching_a_vertex_aslant", one_line({{-5, 1}, {0, 0}, {1, -5}}), {{-3, -3}, {3, 3}}, {1}},
    {"through_the_seam", one_line(square, true), {{-1, -1}, {1, 1}, {-1, -1}}, {1, 1}},
    {"through_a_seam_whose_point_is_repeated",
     one_line({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}}, true),
     {{-1, -1}, {1, 1}, {-1, -1}},
     {1, 1}},
    {"touching_the_seam", one_line(square, true), {{-1, 1}, {1, -1}}, {0}},
    {"along_a_segment_and_on", one_line({{-5, -1}, {0, 0}, {5, 0}, {9, 1}}), {{-2, 0}, {8, 0}}, {1}},
    {"along_a_segment_in_many_steps",
     one_line({{0, 0}, {5, 0}}),
     {{-1, -1}, {0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 1}},
     {1, 0, 0, 0, 0}},
    {"onto_a_line_and_over_it", one_line({{-5, 0}, {5, 0}}), {{0, -1}, {0, 0}, {0, 1}}, {1, 0}},
    {"onto_a_line_and_back_from_above", one_line({{-5, 0}, {5, 0}}), {{0, 1}, {0, 0}, {0, 1}}, {0, 0}},
    {"onto_a_line_and_back_from_below", one_line({{-5, 0}, {5, 0}}), {{0, -1}, {0, 0}, {0, -1}}, {1, 1}},
    {"resting_on_a_line", one_line({{-5, 0}, {5, 0}}), {{0, 0}, {0, 0}, {0, 0}}, {0, 0}},
    {"in_steps_of_a_denormal",
     one_line({{-5, 0}, {5, 0}}),
     {{0, -5e-324}, {0, 0}, {0, 5e-324}, {0, -5e-324}},
     {1, 0, 1}},
    {"beside_a_line_by_one_ulp",
     one_line({{0, 0}, {3, 3}}),
     {{1, std::nextafter(1.0, 0.0)}, {std::nextafter(1.0, 0.0), 1}, {0.5, std::nextafter(0.5, 1.0)}},
     {1, 0}},
    {"two_lines_in_one",
     {{"a", "b"}, {{{{-5, 0}, {5, 0}}, false}, {{{-5, 0}, {5, 0}}, false}}},
     {{0, -1}, {0, 1}},
     {2}},
    {"a_shut_lid", one_line({{-5, 0}, {5, 0}}, true), {{0, -1}, {0, 1}}, {2}},
    {"the_corner_of_a_shut_lid", one_line({{-5, 0}, {5, 0}}, true), {{5, -1}, {5, 1}}, {0}},
    {"a_point_is_no_line",
     {{"dot", "dots"}, {{{{0, 0}}, true}, {{{0, 0}, {0, 0}, {0, 0}}, true}}},
     {{-1, 0}, {1, 0}},
     {0}},
    {"a_gap_where_a_point_is_not_finite",
     one_line({{-5, 0}, {-1, 0}, {std::nan(""), 0}, {1, 0}, {5, 0}}),
     {{-3, -1}, {-3, 1}, {0, 1}, {0, -1}, {3, -1}, {3, 1}},
     {1, 0, 0, 0, 1}},
    {"touching_where_two_lines_meet_crosses_each", // neither goes on in the other
     {{"a", "b"}, {{{{-5, 5}, {0, 0}}, false}, {{{0, 0}, {5, 5}}, false}}},
     {{-3, 0}, {3, 0}},
     {2}},
    {"touching_the_seam_of_a_shut_lid", one_line({{-5, 0}, {5, 0}}, true), {{-5, -1}, {-5, 1}}, {0}},
    {"touching_where_an_open_line_ends_as_it_began",
     one_line({{0, 0}, {10, 0}, {10, 10}, {0, 0}}),
     {{-1, 1}, {1, -1}},
     {2}},
    {"through_a_step_that_is_none",
     one_line({{-5, 0}, {5, 0}}),
     {{0, 1}, {0, 1}, {0, -1}, {0, -1}},
     {0, 1, 0}},
};

} // namespace

class CrossingFinderTest : public QObject {
    Q_OBJECT
private slots:
    void hard_ways_data() {
        QTest::addColumn<std::size_t>("number");
        for (std::size_t i = 0; i < all_hard_ways.size(); ++i)
            QTest::newRow(all_hard_ways[i].name) << i;
    }
    void hard_ways() {
        QFETCH(std::size_t, number);
        const HardWay& hard = all_hard_ways[number];
        QCOMPARE(counts(hard.scene, hard.way), hard.crossed);
    }

    /// On a lattice of whole millimetres nearly every step has a tie.
    void equals_brute_force_where_ties_are_frequent() {
        std::mt19937 random(1);
        std::uniform_int_distribution<int> place(-6, 6);
        std::size_t all = 0;
        for (int round = 0; round < 2000; ++round) {
            const FlatScene scene = on_lattice(random_scene(random, 6.0), 1.0);
            const CrossingFinder finder(scene);
            const BruteCrossings brute(scene, 1.0, 12);
            Vec2 from(place(random), place(random));
            for (int k = 0; k < 100; ++k) {
                const Vec2 to = k % 10 == 9 ? from : Vec2(place(random), place(random));
                auto right = brute.cross(from, to);
                std::sort(right.begin(), right.end());
                QCOMPARE(found(finder, from, to), right);
                all += right.size();
                from = to;
            }
        }
        QVERIFY(all > 100'000);
    }

    void a_way_back_to_its_beginning_crosses_closed_lines_evenly() {
        std::mt19937 random(2);
        std::uniform_int_distribution<int> place(-6, 6);
        for (int round = 0; round < 2000; ++round) {
            FlatScene scene = on_lattice(random_scene(random, 6.0), 1.0);
            for (Polyline& line : scene.lines)
                line.closed = true;
            const CrossingFinder finder(scene);
            std::vector<Vec2> way;
            for (int k = 0; k < 8; ++k)
                way.emplace_back(place(random), place(random));
            way.push_back(way.front());
            std::vector<int> crossed(scene.lines.size(), 0);
            for (std::size_t i = 1; i < way.size(); ++i)
                for (const Crossed& c : found(finder, way[i - 1], way[i]))
                    ++crossed[std::size_t(std::get<0>(c))];
            for (const int times : crossed)
                QCOMPARE(times % 2, 0);
        }
    }

    void each_crossing_says_where_and_in_which_order() {
        FlatScene scene;
        for (int i = 0; i < 20; ++i) {
            scene.names.push_back("line");
            const double x = (i * 7) % 20;
            scene.lines.push_back({{{x, -5}, {x + 1, 5}}, false});
        }
        const CrossingFinder finder(scene);
        StepCrossings crossings;
        finder.find({-10, 0}, {30, 0}, crossings);
        QCOMPARE(crossings.list().size(), std::size_t(20));
        QCOMPARE(crossings.left_out(), std::size_t(0));
        for (std::size_t i = 0; i < 20; ++i) {
            const LineCrossing& c = crossings.list()[i];
            QVERIFY(std::abs(c.place.x - (double(i) + 0.5)) < 1e-9 && std::abs(c.place.y) < 1e-9);
            QVERIFY(std::abs(c.share - (double(i) + 10.5) / 40.0) < 1e-12);
            QCOMPARE((c.contour * 7) % 20, int(i));
            QVERIFY(c.along == Vec2(1, 10) && !c.to_left);
        }
        finder.find({30, 0}, {-10, 0}, crossings);
        QVERIFY(crossings.list().front().to_left);
    }

    void of_too_many_the_first_are_kept() {
        FlatScene scene;
        for (int i = 0; i < 100; ++i) {
            scene.names.push_back("line");
            const double x = (i * 37) % 100;
            scene.lines.push_back({{{x, -5}, {x, 5}}, false});
        }
        StepCrossings crossings;
        QVERIFY(crossings.list().empty());
        CrossingFinder(scene).find({-10, 0}, {110, 0}, crossings);
        QCOMPARE(crossings.list().size(), StepCrossings::room);
        QCOMPARE(crossings.left_out(), 100 - StepCrossings::room);
        for (std::size_t i = 0; i < StepCrossings::room; ++i)
            QVERIFY(std::abs(crossings.list()[i].place.x - double(i)) < 1e-9);
    }

    void inside_is_an_odd_number_of_marked_closed_lines() {
        FlatScene scene{{"outer", "inner", "open"}, {ellipse({0, 0}, 10, 10, 64), ellipse({0, 0}, 5, 5, 64)}};
        scene.lines.push_back({{{-20, 7}, {20, 7}}, false});
        const CrossingFinder finder(scene);
        const std::vector<char> both{1, 1, 1}, outer{1, 0, 0};
        QVERIFY(!finder.inside({0, 0}, both) && finder.inside({0, 0}, outer));
        QVERIFY(finder.inside({7, 0}, both) && finder.inside({-7, 0}, both));
        QVERIFY(!finder.inside({12, 0}, both) && !finder.inside({-12, 0}, both));
        QVERIFY(finder.closed(0) && !finder.closed(2));
    }

    /// Places on lines and vertices too: what the ray of `inside` meets and what a way from outside meets agree.
    void inside_agrees_with_the_crossings_on_the_way_there() {
        std::mt19937 random(3);
        std::uniform_int_distribution<int> place(-7, 7);
        for (int round = 0; round < 1000; ++round) {
            FlatScene scene = on_lattice(random_scene(random, 6.0), 1.0);
            const CrossingFinder finder(scene);
            const std::vector<char> all(scene.lines.size(), 1);
            for (int k = 0; k < 20; ++k) {
                const Vec2 to(place(random), place(random));
                bool within = false;
                for (const Crossed& c : found(finder, {-40, 3}, to))
                    within ^= finder.closed(std::get<0>(c));
                QCOMPARE(finder.inside(to, all), within);
            }
        }
    }

    void a_step_that_begins_on_a_line_crosses_it_at_once() {
        const CrossingFinder finder(FlatScene{{"line"}, {{{{-5, 0}, {5, 0}}, false}}});
        StepCrossings crossings;
        finder.find({0, 0}, {1, -1}, crossings);
        QCOMPARE(crossings.list().size(), std::size_t(1));
        QCOMPARE(crossings.list()[0].share, 0.0);
        QVERIFY(crossings.list()[0].place == Vec2(0, 0));
    }

    /// Where both products round to the same, and beyond what their difference can tell.
    void a_place_on_the_way_is_a_place_of_the_way() {
        StepCrossings crossings;
        std::mt19937 random(6);
        std::uniform_real_distribution<double> at(-50.0, 50.0);
        std::uniform_int_distribution<int> ulps(-3, 3);
        std::size_t all = 0;
        for (int round = 0; round < 20'000; ++round) {
            const Vec2 a(at(random), at(random)), b(at(random), at(random));
            const auto nearly_on_it = [&] {
                const Vec2 place = a + 0.01 * (at(random) + 50.0) * (b - a);
                return Vec2(place.x + ulps(random) * 4e-15, place.y + ulps(random) * 4e-15);
            };
            const Vec2 from = nearly_on_it(), to = nearly_on_it();
            CrossingFinder(one_line({a, b})).find(from, to, crossings);
            for (const LineCrossing& crossing : crossings.list()) {
                QVERIFY(crossing.share >= 0.0 && crossing.share <= 1.0);
                ++all;
            }
        }
        QVERIFY(all > 1000);
    }

    void hostile_numbers_are_answered() {
        const double values[] = {0.0,    1e-320,       1e308,
                                 -1e308, std::nan(""), std::numeric_limits<double>::infinity()};
        FlatScene scene;
        for (const double x : values)
            for (const double y : values) {
                scene.names.push_back("line");
                scene.lines.push_back({{{0, 0}, {x, y}, {y, 1}}, true});
            }
        const CrossingFinder finder(scene);
        StepCrossings crossings;
        for (const double x : values)
            for (const double y : values)
                finder.find({x, 1}, {y, -1}, crossings);
        QVERIFY(finder.segment_count() > 0);
        CrossingFinder(FlatScene{}).find({0, 0}, {1, 1}, crossings);
        QVERIFY(crossings.list().empty());
    }
};

} // namespace crossing_finder_test

TP_TEST(crossing_finder_test, CrossingFinderTest, nothing)
#include "crossing_finder_test.moc"
