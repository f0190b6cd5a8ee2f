// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/polyline.hpp"
#include "random_points.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <limits>

namespace polyline_test {

using namespace tp;

namespace {

Polyline random_line(test::RandomPoints& random) {
    Polyline line{{}, random.below(2) == 0};
    const std::size_t count = 1 + random.below(12);
    for (std::size_t i = 0; i < count; ++i) {
        line.points.push_back(random.point(50.0));
        if (random.below(4) == 0) // vertices may coincide
            line.points.push_back(line.points.back());
    }
    return line;
}

bool finite(const Polyline& line) {
    return std::all_of(line.points.begin(), line.points.end(), [](Vec2 p) { return is_finite(p); });
}

} // namespace

class PolylineTest : public QObject {
    Q_OBJECT

private slots:
    void nearest_on_segment_is_nearest() {
        test::RandomPoints random(3);
        for (int i = 0; i < 2000; ++i) {
            const Vec2 a = random.point(10);
            const Vec2 b = i % 10 == 0 ? a : random.point(10);
            const Vec2 p = random.point(20);
            const Vec2 q = tp::nearest_on_segment(a, b, p);
            double brute = std::numeric_limits<double>::infinity();
            for (int k = 0; k <= 2000; ++k)
                brute = std::min(brute, length(p - (a + k / 2000.0 * (b - a))));
            const double step = length(b - a) / 2000.0;
            QVERIFY(length(p - q) <= brute + 1e-12);
            QVERIFY(length(p - q) >= brute - step);
            // It is a point of the segment.
            QVERIFY(std::abs(length(q - a) + length(b - q) - length(b - a)) < 1e-12);
        }
    }

    void nearest_on_segment_data() {
        QTest::addColumn<double>("size");
        QTest::newRow("segment_of_length_1") << 1.0;
        QTest::newRow("segment_of_length_1e_minus_12") << 1e-12;
        QTest::newRow("segment_of_length_1e_minus_150") << 1e-150;
        QTest::newRow("segment_of_length_1e_minus_160") << 1e-160;
        QTest::newRow("segment_of_length_1e_minus_200") << 1e-200;
        QTest::newRow("denormal_segment") << 5e-324;
        QTest::newRow("segment_of_length_1e100") << 1e100;
        QTest::newRow("segment_of_length_1e150") << 1e150;
    }
    void nearest_on_segment() {
        QFETCH(double, size);
        const Vec2 a(size, 2 * size);
        const Vec2 b(4 * size, 6 * size);
        const Vec2 middle = a + 0.5 * (b - a);
        for (const double far : {0.0, 1.0, -1.0, 1e3})
            for (const double along : {-1.0, 0.0, 0.5, 1.0, 2.0}) {
                const Vec2 p = a + along * (b - a) + far * size * Vec2(-4, 3);
                const Vec2 q = tp::nearest_on_segment(a, b, p);
                const Vec2 expected = along <= 0.0 ? a : along >= 1.0 ? b : middle;
                QVERIFY(is_finite(q));
                // So short that its square underflows: any of its points is as near as can be told.
                const double allowed =
                    size < 1e-140 ? 5.0 * size : 1e-12 * size * std::max(1.0, std::abs(far));
                QVERIFY(length(q - expected) <= allowed);
            }
    }

    void both_ends_are_exact() {
        test::RandomPoints random(4);
        for (int i = 0; i < 1000; ++i) {
            const Vec2 a = random.point(1e3);
            const Vec2 b = random.point(1e3);
            QVERIFY(tp::nearest_on_segment(a, b, a) == a);
            QVERIFY(tp::nearest_on_segment(a, b, b) == b);
            QVERIFY(tp::nearest_on_segment(a, b, a - 0.3 * (b - a)) == a);
            QVERIFY(tp::nearest_on_segment(a, b, b + 0.3 * (b - a)) == b);
        }
        QVERIFY(tp::nearest_on_segment({1, 1}, {1, 1}, {5, 5}) == Vec2(1, 1));
    }

    void distance_to_line() {
        const Polyline square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true};
        QCOMPARE(distance_to(square, {5, 5}), 5.0);
        QCOMPARE(distance_to(square, {-3, 5}), 3.0); // the closing segment
        QCOMPARE(distance_to({square.points, false}, {-3, 5}), std::hypot(3.0, 5.0));
        QCOMPARE(distance_to({{{1, 1}}, false}, {4, 5}), 5.0);
        QCOMPARE(distance_to({{{1, 1}}, true}, {4, 5}), 5.0);
        QCOMPARE(distance_to({{}, true}, {4, 5}), std::numeric_limits<double>::infinity());
    }

    void lengths() {
        const Polyline square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true};
        QCOMPARE(length_of(square), 40.0);
        QCOMPARE(length_of({square.points, false}), 30.0);
        QCOMPARE(length_of({{{1, 1}}, true}), 0.0);
        QCOMPARE(length_of({{}, false}), 0.0);
        QCOMPARE(length_of({{{0, 0}, {3, 4}}, true}), 10.0);
    }

    void point_along_walks_the_line() {
        const Polyline square{{{0, 0}, {10, 0}, {10, 10}, {10, 10}, {0, 10}}, true};
        QVERIFY(point_along(square, 0) == Vec2(0, 0));
        QVERIFY(point_along(square, 15) == Vec2(10, 5));
        QVERIFY(point_along(square, 35) == Vec2(0, 5));
        QVERIFY(length(point_along(square, 45) - Vec2(5, 0)) < 1e-12);
        QVERIFY(length(point_along(square, -5) - Vec2(0, 5)) < 1e-12);
        const Polyline open{square.points, false};
        QVERIFY(point_along(open, -5) == Vec2(0, 0));
        QVERIFY(point_along(open, 1e9) == Vec2(0, 10));
        QVERIFY(point_along({{{3, 4}, {3, 4}}, true}, 7) == Vec2(3, 4));
    }

    void point_along_odd_lengths() {
        const double infinity = std::numeric_limits<double>::infinity();
        for (const bool closed : {false, true})
            for (const double arc :
                 {infinity, -infinity, std::numeric_limits<double>::quiet_NaN(), 1e300, -1e300}) {
                const Polyline line{{{0, 0}, {10, 0}, {10, 10}}, closed};
                QVERIFY(is_finite(point_along(line, arc)));
                QVERIFY(distance_to(line, point_along(line, arc)) < 1e-9);
            }
    }

    void point_along_and_nearest_arc_are_inverse() {
        test::RandomPoints random(5);
        for (int i = 0; i < 500; ++i) {
            const Polyline line = random_line(random);
            const double total = length_of(line);
            const double arc = random.number(0, total);
            const Vec2 p = point_along(line, arc);
            QVERIFY(distance_to(line, p) < 1e-9);
            // A line that crosses itself may pass p at another arc, never anywhere else.
            const double found = nearest_arc(line, p);
            QVERIFY(found >= 0.0 && found <= total + 1e-9);
            QVERIFY(length(point_along(line, std::min(found, total)) - p) < 1e-9);
            // Nearest for points off the line, too.
            const Vec2 off = random.point(80);
            QVERIFY(std::abs(length(point_along(line, std::min(nearest_arc(line, off), total)) - off) -
                             distance_to(line, off)) < 1e-9);
        }
    }

    void point_along_is_continuous() {
        test::RandomPoints random(6);
        for (int i = 0; i < 100; ++i) {
            const Polyline line = random_line(random);
            const double total = length_of(line);
            for (int k = 0; k < 200; ++k) {
                const double step =
                    length(point_along(line, (k + 1) * total / 200) - point_along(line, k * total / 200));
                QVERIFY(step <= total / 200 + 1e-9);
            }
        }
    }

    void resampled_is_even_and_keeps_the_ends() {
        test::RandomPoints random(7);
        for (int i = 0; i < 500; ++i) {
            const Polyline line = random_line(random);
            const std::size_t count = 2 + random.below(40);
            const Polyline result = resampled(line, count);
            QCOMPARE(result.points.size(), count);
            QCOMPARE(result.closed, line.closed);
            QVERIFY(result.points.front() == line.points.front());
            if (!line.closed)
                QVERIFY(result.points.back() == line.points.back());
            const double gap = length_of(line) / static_cast<double>(line.closed ? count : count - 1);
            for (std::size_t k = 0; k < count; ++k)
                QVERIFY(length(result.points[k] - point_along(line, static_cast<double>(k) * gap)) < 1e-9 ||
                        (line.closed && k == 0) || k + 1 == count);
            QVERIFY(length_of(result) <= length_of(line) + 1e-9);
        }
    }

    void resampled_degenerate() {
        for (const bool closed : {false, true})
            for (const std::vector<Vec2>& points : {std::vector<Vec2>{{3, 4}},
                                                    {{3, 4}, {3, 4}},
                                                    {{0, 0}, {1e-160, 0}},
                                                    {{0, 0}, {1e150, 1e150}, {0, 1e150}}})
                for (const std::size_t count : {std::size_t{2}, std::size_t{7}}) {
                    const Polyline result = resampled({points, closed}, count);
                    QCOMPARE(result.points.size(), count);
                    QVERIFY(finite(result));
                }
    }

    void an_edge_belongs_to_its_rectangle() {
        const Rect box{{-2, 5}, {1, 7}};
        for (const Vec2 inside : {Vec2(0, 6), Vec2(-2, 5), Vec2(1, 7), Vec2(-2, 7), Vec2(1, 5)})
            QVERIFY(box.contains(inside));
        for (const Vec2 outside : {Vec2(-2.1, 6), Vec2(1.1, 6), Vec2(0, 4.9), Vec2(0, 7.1), Vec2(-3, 8)})
            QVERIFY(!box.contains(outside));
        QCOMPARE(box.width(), 3.0);
        QCOMPARE(box.height(), 2.0);
        QVERIFY(box.centre() == Vec2(-0.5, 6.0));
        const Rect empty{{1, 0}, {0, 1}};
        QVERIFY(!empty.contains({0.5, 0.5}));
    }

    void bounds() {
        QVERIFY(bounds_of({}).min == Vec2(0, 0));
        QVERIFY(bounds_of({}).max == Vec2(0, 0));
        const Rect box = bounds_of({{1, 5}, {-2, 7}, {0, 6}});
        QVERIFY(box.min == Vec2(-2, 5));
        QVERIFY(box.max == Vec2(1, 7));
    }
};

} // namespace polyline_test

TP_TEST(polyline_test, PolylineTest, event_loop)
#include "polyline_test.moc"
