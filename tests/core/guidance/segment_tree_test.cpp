// SPDX-License-Identifier: Apache-2.0
// The tree alone, where the grid of cells does not answer for it.
#include "index_parts.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>

namespace segment_tree_test {

using namespace tp;
using namespace tp::testing;

namespace {

template <typename Real>
Closest<Real> searched(const SegmentSet& set, const SegmentTree& tree, Vec2 p) {
    Closest<Real> closest;
    tree.search(set, p, closest);
    return closest;
}

/// The same place of the same contour; two segments of it may meet there.
template <typename Real>
bool same(const SegmentSet& set, const Closest<Real>& a, const Closest<Real>& b) {
    return a.squared == b.squared && set.owners[a.segment] == set.owners[b.segment] &&
           point_on(set.segments[a.segment], a.parameter) == point_on(set.segments[b.segment], b.parameter);
}

/// Both precisions find what asking all of them finds, to the last bit.
bool agrees(const SegmentSet& set, const SegmentTree& tree, Vec2 p) {
    Closest<long double> all_wide;
    for (std::uint32_t i = 0; i < set.size(); ++i)
        all_wide.offer(set, i, p);
    return same(set, searched<double>(set, tree, p), closest_of_all(set, p)) &&
           same(set, searched<long double>(set, tree, p), all_wide);
}

FlatScene dots(const std::vector<Vec2>& places) {
    FlatScene scene;
    for (const Vec2 p : places) {
        scene.names.emplace_back("dot");
        scene.lines.push_back({{p}, false});
    }
    return scene;
}

} // namespace

class SegmentTreeTest : public QObject {
    Q_OBJECT
private slots:
    /// None that a rectangle meets is missed, on its edge too, and not all are visited.
    void near_a_rectangle_are_all_that_it_meets() {
        std::mt19937 random(37);
        std::size_t visited = 0, offered = 0;
        for (int round = 0; round < 100; ++round) {
            const bool is_empty = round % 10 == 9, is_at_origin = round % 2 == 0;
            const Vec2 shift = is_at_origin ? Vec2(0.0) : 5.0 * random_point(random);
            FlatScene scene = many_curves(is_empty ? 0 : 1000, 60.0);
            for (Polyline& line : scene.lines)
                for (Vec2& point : line.points)
                    point += shift;
            const SegmentSet set = set_of(scene);
            const SegmentTree tree(set);
            const Vec2 p = shift + random_point(random), q = p + 0.1 * random_point(random);
            const Vec2 low = glm::min(p, q), high = glm::max(p, q);
            std::vector<char> near(set.size(), 0);
            tree.for_each_near(low, high, [&](std::uint32_t i) { near[i] = 1; });
            for (std::uint32_t i = 0; i < set.size(); ++i) {
                const Vec2 from = glm::min(set.segments[i].a, set.segments[i].b);
                const Vec2 to = glm::max(set.segments[i].a, set.segments[i].b);
                const bool apart = to.x < low.x || from.x > high.x || to.y < low.y || from.y > high.y;
                QVERIFY(apart || near[i] != 0);
                bool touched = false;
                tree.for_each_near(to, to + Vec2(1.0), [&](std::uint32_t k) { touched |= k == i; });
                QVERIFY(touched);
                visited += near[i] != 0 ? 1 : 0;
            }
            offered += set.size();
        }
        QVERIFY(visited > 0 && visited < offered / 10);
    }

    /// Full and half-empty leaves and nodes, one level and several.
    void of_any_number_of_segments_the_nearest_is_found() {
        std::mt19937 random(31);
        for (int count = 0; count <= 300; ++count) {
            std::vector<Vec2> places;
            for (int i = 0; i < count; ++i)
                places.push_back(random_point(random));
            const SegmentSet set = set_of(dots(places));
            const SegmentTree tree(set);
            if (count == 0) {
                QCOMPARE(searched<double>(set, tree, {1, 2}).segment, Closest<double>::none);
                continue;
            }
            for (const Vec2 p : places)
                QVERIFY(searched<double>(set, tree, p).squared == 0.0);
            for (int k = 0; k < 10; ++k)
                QVERIFY(agrees(set, tree, random_point(random, k < 5 ? 60.0 : 500.0)));
        }
    }

    void lines_of_any_length_are_found_near_and_far() {
        std::mt19937 random(32);
        for (const FlatScene& scene :
             {face_scene(60), many_curves(1000, 50.0), random_scene(random, 300.0)}) {
            const SegmentSet set = set_of(scene);
            const SegmentTree tree(set);
            for (int k = 0; k < 400; ++k)
                QVERIFY(agrees(set, tree, random_point(random, k % 2 == 0 ? 70.0 : 1e4)));
            for (std::uint32_t i = 0; i < set.size(); ++i) // on it, where everything else is to be left out
                QVERIFY(agrees(set, tree, point_on(set.segments[i], 0.37)));
        }
    }

    /// Boxes are kept in single precision, which at 100 mm knows steps of 8 nm.
    void what_lies_closer_together_than_the_boxes_can_tell_is_told_apart() {
        std::mt19937 random(33);
        std::vector<Vec2> places{{-100.0, -90.0}};
        for (int i = 0; i < 2000; ++i)
            places.push_back(Vec2(100.0, 70.0) + random_point(random, 1e-6));
        const SegmentSet set = set_of(dots(places));
        const SegmentTree tree(set);
        for (const Vec2 p : places)
            QVERIFY(searched<double>(set, tree, p).squared == 0.0 &&
                    searched<long double>(set, tree, p).squared == 0.0L);
        for (int k = 0; k < 500; ++k)
            QVERIFY(agrees(set, tree, Vec2(100.0, 70.0) + random_point(random, 2e-6)));
    }

    /// A search within a reach finds what lies on its edge, and nothing beyond.
    void what_is_as_near_as_what_is_known_already_is_still_offered() {
        std::mt19937 random(34);
        const SegmentSet set = set_of(face_scene(60));
        const SegmentTree tree(set);
        for (int k = 0; k < 2000; ++k) {
            const Vec2 p = random_point(random, 90.0);
            const Closest<double> all = closest_of_all(set, p);
            Closest<double> as_near;
            as_near.squared = all.squared;
            tree.search(set, p, as_near);
            QVERIFY(as_near.segment != Closest<double>::none && same(set, as_near, all));
            Closest<double> nearer;
            nearer.squared = std::nextafter(all.squared, 0.0);
            tree.search(set, p, nearer);
            QCOMPARE(nearer.segment, Closest<double>::none);
        }
    }

    void coordinates_that_overflow_in_single_precision_are_found_too() {
        std::mt19937 random(35);
        for (const double size : {1e30, 1e38, 1e100}) {
            std::vector<Vec2> places;
            for (int i = 0; i < 100; ++i)
                places.push_back(random_point(random, size));
            const SegmentSet set = set_of(dots(places));
            const SegmentTree tree(set);
            for (int k = 0; k < 100; ++k) {
                const Vec2 p = random_point(random, 1.2 * size);
                Closest<long double> all;
                for (std::uint32_t i = 0; i < set.size(); ++i)
                    all.offer(set, i, p);
                QVERIFY(same(set, searched<long double>(set, tree, p), all));
            }
        }
    }

    /// What a cell's list is made of: no segment that may be nearest in the block is missing, and few others
    /// are there.
    void a_block_is_told_all_that_may_be_nearest_in_it_and_little_more() {
        std::mt19937 random(36);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        std::size_t told = 0, unbeaten = 0;
        const SegmentSet set = set_of(many_curves(2000, 60.0));
        const SegmentTree tree(set);
        for (int k = 0; k < 250; ++k) {
            const Vec2 centre = random_point(random, 70.0);
            const double half = 0.05 + 2.0 * unit(random);
            const std::array<Vec2, 4> corners{centre + Vec2(-half, -half), centre + Vec2(half, -half),
                                              centre + Vec2(-half, half), centre + Vec2(half, half)};
            const Closest<double> nearest = closest_of_all(set, centre);
            const Vec2 rival = point_on(set.segments[nearest.segment], nearest.parameter);
            const double margin = k % 2 == 0 ? 1e-6 : 0.5;
            std::vector<std::uint32_t> list;
            QVERIFY(tree.collect_unbeaten(corners, rival, margin, set.size(), list));
            std::sort(list.begin(), list.end());
            QVERIFY(std::adjacent_find(list.begin(), list.end()) == list.end());
            for (std::uint32_t i = 0; i < set.size(); ++i) {
                const bool listed = std::binary_search(list.begin(), list.end(), i);
                const bool may_be_nearest = std::any_of(corners.begin(), corners.end(), [&](Vec2 corner) {
                    return static_cast<double>(testing::distance_to(set.segments[i], corner)) <=
                           length(corner - rival) + margin;
                });
                QVERIFY(listed || !may_be_nearest);
                unbeaten += may_be_nearest ? 1 : 0;
            }
            told += list.size();
        }
        qInfo("%.2f segments are told for each that may be nearest", double(told) / double(unbeaten));
        QVERIFY(told < 2 * unbeaten);
    }

    void a_block_without_segments_is_told_none() {
        std::vector<std::uint32_t> list;
        QVERIFY(SegmentTree().collect_unbeaten({Vec2(0), Vec2(1), Vec2(2), Vec2(3)}, Vec2(5), 1.0, 0, list));
        QVERIFY(list.empty());
        QCOMPARE(SegmentTree().bytes(), std::size_t(0));
    }
};

} // namespace segment_tree_test

TP_TEST(segment_tree_test, SegmentTreeTest, nothing)
#include "segment_tree_test.moc"
