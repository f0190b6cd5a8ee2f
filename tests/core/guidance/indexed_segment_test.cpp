// SPDX-License-Identifier: Apache-2.0
// The arithmetic beneath every answer of the index, against extended precision.
#include "index_parts.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <numeric>

namespace indexed_segment_test {

using namespace tp;
using namespace tp::testing;

namespace {

/// Segments of very different lengths, a few of them points, within ±`extent` mm.
SegmentSet random_set(std::mt19937& random, std::size_t count, double extent) {
    std::uniform_real_distribution<double> exponent(-13.0, 1.0);
    SegmentSet set;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 a = random_point(random, extent);
        const Vec2 b = i % 7 == 3 ? a : a + std::pow(10.0, exponent(random)) * random_point(random, extent);
        set.segments.emplace_back(a, b);
        set.owners.push_back(static_cast<int>(i));
        set.numbers.push_back(0);
        set.longest = std::max(set.longest, std::abs(b.x - a.x) + std::abs(b.y - a.y));
    }
    set.add_filler();
    return set;
}

/// All of the set in a random order, in pairs as a cell's list has them.
std::vector<std::uint32_t> shuffled_list(const SegmentSet& set, std::mt19937& random) {
    std::vector<std::uint32_t> list(set.size());
    std::iota(list.begin(), list.end(), 0u);
    std::shuffle(list.begin(), list.end(), random);
    if (list.size() % 2 == 1)
        list.push_back(set.filler());
    return list;
}

template <typename Real>
void check_foot(const IndexedSegment& segment, Vec2 p) {
    const Foot<Real> foot(segment, p);
    const long double truth = testing::distance_to(segment, p);
    const double coarse = 1e-14 * (length(segment.b - segment.a) + static_cast<double>(truth));
    QVERIFY(std::abs(std::sqrt(static_cast<long double>(foot.squared)) - truth) <= 1e-12L + coarse);
    QVERIFY(foot.parameter >= 0 && foot.parameter <= 1);
    QVERIFY(std::abs(length(point_on(segment, foot.parameter) - p) - static_cast<double>(truth)) < 1e-11);
}

} // namespace

class IndexedSegmentTest : public QObject {
    Q_OBJECT
private slots:
    void a_foot_is_where_the_segment_passes_nearest() {
        std::mt19937 random(21);
        const SegmentSet set = random_set(random, 400, 60.0);
        for (std::size_t i = 0; i < set.size(); ++i)
            for (int k = 0; k < 20; ++k) {
                const IndexedSegment& segment = set.segments[i];
                const Vec2 near = segment.a + random_point(random, 1.5 * length(segment.b - segment.a));
                for (const Vec2 p : {random_point(random, 90.0), near}) {
                    check_foot<double>(segment, p);
                    check_foot<long double>(segment, p);
                }
            }
    }

    /// A finger beyond a line's end is pulled to the end itself, without rounding.
    void beyond_an_end_the_end_itself_is_nearest() {
        std::mt19937 random(22);
        for (int k = 0; k < 2000; ++k) {
            const IndexedSegment segment(random_point(random), random_point(random));
            const Vec2 along = segment.b - segment.a;
            const double beyond = 0.001 + 0.5 * (k % 3);
            const Vec2 past_b = segment.b + beyond * along;
            const Vec2 past_a = segment.a - beyond * along;
            const auto check = [&](const auto& foot_a, const auto& foot_b) {
                QVERIFY(foot_a.parameter == 0 && foot_b.parameter == 1);
                QVERIFY(point_on(segment, foot_a.parameter) == segment.a);
                QVERIFY(point_on(segment, foot_b.parameter) == segment.b);
            };
            check(Foot<double>(segment, past_a), Foot<double>(segment, past_b));
            check(Foot<long double>(segment, past_a), Foot<long double>(segment, past_b));
            QCOMPARE(Foot<double>(segment, past_b).squared, glm::dot(past_b - segment.b, past_b - segment.b));
            QCOMPARE(Foot<double>(segment, past_a).squared, glm::dot(past_a - segment.a, past_a - segment.a));
        }
    }

    void a_segment_without_a_length_is_its_end() {
        for (const double size : {0.0, 1e-300, 1e-150, 1e-141}) {
            const IndexedSegment speck(Vec2(3.0, 4.0), Vec2(3.0, 4.0) + Vec2(size, 0.0));
            QCOMPARE(Foot<double>(speck, {0.0, 0.0}).squared, 25.0);
            QCOMPARE(double(Foot<long double>(speck, {0.0, 0.0}).squared), 25.0);
            const IndexedSegment at_zero(Vec2(0.0), Vec2(size, -size)); // where so small a size is kept
            QCOMPARE(Foot<double>(at_zero, {3.0, 4.0}).squared, 25.0);
            QVERIFY(std::isfinite(at_zero.per_square));
        }
        QCOMPARE(IndexedSegment(Vec2(0.0), Vec2(1e-120, 0.0)).per_square, 1e240);
        QCOMPARE(IndexedSegment(Vec2(0.0), Vec2(0.0, 4.0)).per_square, 1.0 / 16.0);
    }

    void the_direction_it_was_drawn_in_does_not_matter() {
        for (const auto& [from, to] : {std::pair{Vec2(1, 5), Vec2(2, 3)}, {Vec2(2, -7), Vec2(2, 3)}}) {
            const IndexedSegment there(from, to);
            const IndexedSegment back(to, from);
            QVERIFY(there.a == from && there.b == to && back.a == from && back.b == to);
            QCOMPARE(back.per_square, there.per_square);
        }
    }

    void two_at_a_time_are_measured_as_one_is() {
        std::mt19937 random(23);
        const SegmentSet set = random_set(random, 100, 60.0);
        const auto same = [](double squared, double parameter, const IndexedSegment& segment, Vec2 p) {
            const Foot<double> foot(segment, p);
            const double truth = std::sqrt(foot.squared);
            const double whole = length(segment.b - segment.a);
            return std::abs(std::sqrt(squared) - truth) <= 1e-14 * (truth + whole) + 1e-15 &&
                   std::abs(parameter - foot.parameter) * whole <= 1e-12;
        };
        for (std::size_t i = 0; i < set.size(); ++i)
            for (std::size_t k = 0; k < set.size(); ++k) {
                const Vec2 p = random_point(random, 90.0);
                const Vec2 q = random_point(random, 90.0);
                const TwoSquares of_two(set.segments[i], set.segments[k], p);
                QVERIFY(same(of_two.squared[0], of_two.parameter[0], set.segments[i], p));
                QVERIFY(same(of_two.squared[1], of_two.parameter[1], set.segments[k], p));
                const TwoSquares from_two(set.segments[i], p, q);
                QVERIFY(same(from_two.squared[0], from_two.parameter[0], set.segments[i], p));
                QVERIFY(same(from_two.squared[1], from_two.parameter[1], set.segments[i], q));
            }
    }

    void of_a_list_the_nearest_is_found_wherever_it_stands() {
        std::mt19937 random(24);
        for (int round = 0; round < 3000; ++round) {
            const SegmentSet set = random_set(random, static_cast<std::size_t>(1 + round % 14), 20.0);
            const Vec2 p = random_point(random, 30.0);
            const Closest<double> all = closest_of_all(set, p);
            const Closest<double> found = closest_of(set, shuffled_list(set, random), p);
            QCOMPARE(found.segment, all.segment);
            QVERIFY(std::abs(found.squared - all.squared) <= 1e-12 * all.squared + 1e-24);
            const Vec2 apart = point_on(set.segments[all.segment], all.parameter) -
                               point_on(set.segments[found.segment], found.parameter);
            QVERIFY(length(apart) < 1e-11);
        }
    }

    void what_it_holds_is_counted_in_full() {
        std::mt19937 random(26);
        const SegmentSet set = random_set(random, 100, 60.0);
        QVERIFY(set.bytes() >= 101 * sizeof(IndexedSegment) + 100 * (sizeof(int) + sizeof(std::uint32_t)));
        QCOMPARE(SegmentSet().bytes(), std::size_t(0));
    }

    /// Lines that meet in one vertex are equally near from beyond it, and so are twins.
    void of_equals_the_same_one_is_found_in_any_order() {
        std::mt19937 random(25);
        for (int round = 0; round < 2000; ++round) {
            const Vec2 vertex = random_point(random, 20.0);
            SegmentSet set;
            for (int i = 0; i < 2 + round % 9; ++i) {
                const Vec2 end =
                    vertex + Vec2(1.0 + (round + i) % 3, 1.0 - i % 3) * (i % 4 == 3 ? 50.0 : 1.0);
                set.segments.emplace_back(vertex, end);
                set.owners.push_back((7 * i + round) % 11);
                set.numbers.push_back(0);
                set.longest = std::max(set.longest, std::abs(end.x - vertex.x) + std::abs(end.y - vertex.y));
            }
            set.add_filler();
            const Vec2 p = vertex - Vec2(0.7, round % 2 == 0 ? 0.1 : 3.0);
            const Closest<double> first = closest_of(set, shuffled_list(set, random), p);
            const Closest<double> again = closest_of(set, shuffled_list(set, random), p);
            const int owner = set.owners[first.segment];
            QCOMPARE(set.owners[again.segment], owner);
            QVERIFY(first.squared == again.squared);
            if (round % 2 == 0) // all are nearest in the vertex: the first owner has it
                QCOMPARE(owner, *std::min_element(set.owners.begin(), set.owners.end()));
        }
    }
};

} // namespace indexed_segment_test

TP_TEST(indexed_segment_test, IndexedSegmentTest, nothing)
#include "indexed_segment_test.moc"
