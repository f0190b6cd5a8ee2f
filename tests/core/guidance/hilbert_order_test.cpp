// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/segment_tree.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <numeric>
#include <random>

namespace hilbert_order_test {

using namespace tp;

namespace {

/// `columns` × `rows` points, `step` apart, in random order; each owned by its own number.
SegmentSet shuffled_grid(int columns, int rows, double step, Vec2 origin) {
    std::vector<int> order(static_cast<std::size_t>(columns * rows));
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    SegmentSet set;
    for (const int number : order) {
        const Vec2 place = origin + step * Vec2(number % columns, number / columns);
        set.segments.emplace_back(place, place);
        set.owners.push_back(number);
        set.numbers.push_back(static_cast<std::uint32_t>(2 * number));
    }
    return set;
}

} // namespace

class HilbertOrderTest : public QObject {
    Q_OBJECT
private slots:
    /// What makes the tree quick: the curve never leaves a place for one that is not beside it.
    void neighbours_in_the_order_are_neighbours_in_the_plane() {
        for (const Vec2 origin : {Vec2(0.0), Vec2(-1000.0, 250.0)})
            for (const double step : {0.001, 1.0, 500.0}) {
                SegmentSet set = shuffled_grid(32, 32, step, origin);
                sort_along_hilbert_curve(set);
                QCOMPARE(set.size(), std::size_t(1024));
                for (std::size_t i = 1; i < set.size(); ++i)
                    QVERIFY(std::abs(length(set.segments[i].a - set.segments[i - 1].a) - step) < 1e-6 * step);
            }
    }

    void what_belongs_to_a_segment_goes_with_it() {
        SegmentSet set = shuffled_grid(40, 3, 2.0, {5.0, 5.0});
        sort_along_hilbert_curve(set);
        QCOMPARE(set.size(), std::size_t(120));
        QCOMPARE(set.segments.size(), std::size_t(121)); // with the filler
        QVERIFY(set.segments.back().a == Vec2(1e145));
        for (std::size_t i = 0; i < set.size(); ++i) {
            const int number = set.owners[i];
            QVERIFY(set.segments[i].a == Vec2(5.0) + 2.0 * Vec2(number % 40, number / 40));
            QCOMPARE(set.numbers[i], static_cast<std::uint32_t>(2 * number));
        }
    }

    void repeats_are_kept_where_that_is_asked_for() {
        SegmentSet set = shuffled_grid(4, 3, 0.0, {5.0, 5.0});
        sort_along_hilbert_curve(set, Repeats::kept);
        QCOMPARE(set.size(), std::size_t(12));
        sort_along_hilbert_curve(set);
        QCOMPARE(set.size(), std::size_t(1));
    }

    void of_the_same_segment_the_first_owner_and_number_stay() {
        SegmentSet set;
        for (const auto& [owner, number] : {std::pair{2, 1u}, {1, 7u}, {1, 5u}, {3, 0u}}) {
            set.segments.emplace_back(Vec2(1, 2), Vec2(3, 4));
            set.owners.push_back(owner);
            set.numbers.push_back(number);
        }
        set.segments.emplace_back(Vec2(1, 2), Vec2(3, 5)); // another one
        set.owners.push_back(9);
        set.numbers.push_back(9u);
        sort_along_hilbert_curve(set);
        QCOMPARE(set.size(), std::size_t(2));
        const auto kept =
            static_cast<std::size_t>(std::find(set.owners.begin(), set.owners.end(), 1) - set.owners.begin());
        QVERIFY(kept < 2);
        QCOMPARE(set.numbers[kept], 5u);
    }

    void nothing_stays_nothing() {
        SegmentSet set;
        sort_along_hilbert_curve(set);
        QCOMPARE(set.size(), std::size_t(0));
    }
};

} // namespace hilbert_order_test

TP_TEST(hilbert_order_test, HilbertOrderTest, nothing)
#include "hilbert_order_test.moc"
