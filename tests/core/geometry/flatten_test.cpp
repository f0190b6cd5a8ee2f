// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/flatten.hpp"
#include "random_points.hpp"

#include <QTest>

#include <algorithm>
#include <limits>
#include <numbers>

using namespace tp;

namespace {

Contour curve(Piece piece) { return {"curve", {piece}, false}; }

/// Largest distance of the true curve from its segments.
double chord_error(const Piece& piece, const Polyline& line, int samples = 4000) {
    double worst = 0.0;
    for (int i = 0; i <= samples; ++i)
        worst = std::max(worst, distance_to(line, point_at(piece, static_cast<double>(i) / samples)));
    return worst;
}

double turn_between(Vec2 u, Vec2 v) { return std::abs(std::atan2(cross(u, v), glm::dot(u, v))); }

/// Largest turn (degrees) of the true curve within one segment, save those of the greatest depth, which may
/// turn as they like. Vertices stand at parameters k / 2^depth; where they do not, infinity.
double facet_error(const Piece& piece, const Polyline& line, int depth) {
    const int steps = 1 << depth;
    double worst = 0.0;
    int k = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        int next = k + 1;
        while (next <= steps &&
               length(point_at(piece, static_cast<double>(next) / steps) - line.points[i]) > 1e-9)
            ++next;
        if (next > steps)
            return std::numeric_limits<double>::infinity();
        if (next > k + 1) {
            constexpr int samples = 32;
            double turn = 0.0;
            Vec2 before(0.0);
            Vec2 direction(0.0);
            for (int s = 0; s <= samples; ++s) {
                const Vec2 p = point_at(piece, (k + static_cast<double>(s * (next - k)) / samples) / steps);
                if (s > 1)
                    turn += turn_between(direction, p - before);
                direction = p - before;
                before = p;
            }
            worst = std::max(worst, turn * 180.0 / std::numbers::pi);
        }
        k = next;
    }
    return k == steps ? worst : std::numeric_limits<double>::infinity();
}

bool all_finite(const Polyline& line) {
    return std::all_of(line.points.begin(), line.points.end(), [](Vec2 p) { return is_finite(p); });
}

} // namespace

Q_DECLARE_METATYPE(tp::Piece)

class FlattenTest : public QObject {
    Q_OBJECT

    static void check(const Piece& piece, const FlattenTolerance& tolerance) {
        const Polyline line = flatten(curve(piece), tolerance);
        QVERIFY(line.points.front() == start_of(piece));
        QVERIFY(line.points.back() == end_of(piece));
        QVERIFY(line.segment_count() <= std::size_t{1} << tolerance.max_depth);
        const double error = chord_error(piece, line, 1000);
        QVERIFY2(error <= tolerance.chord + 1e-12, qPrintable(QString::number(error)));
        const double turn = facet_error(piece, line, tolerance.max_depth);
        QVERIFY2(turn <= tolerance.facet_degrees + 1e-6, qPrintable(QString::number(turn)));
    }

private slots:
    void random_curves_keep_both_bounds() {
        test::RandomPoints random(11);
        const FlattenTolerance tolerances[] = {{}, {0.1, 10.0, 12}, {0.001, 45.0, 12}, {5.0, 1.0, 12}};
        for (int i = 0; i < 60; ++i) {
            const double reach = i % 3 == 0 ? 1.0 : i % 3 == 1 ? 20.0 : 100.0;
            const FlattenTolerance& tolerance = tolerances[random.below(4)];
            const auto p = [&] { return random.point(reach); };
            check(Line{p(), p()}, tolerance);
            check(Quadratic{p(), p(), p()}, tolerance);
            check(Cubic{p(), p(), p(), p()}, tolerance);
            if (QTest::currentTestFailed())
                return;
        }
    }

    void a_line_stays_one_segment() {
        QCOMPARE(flatten(curve(Line{{0, 0}, {100, 3}})).points.size(), std::size_t{2});
        // So do curves that are straight.
        QCOMPARE(flatten(curve(Quadratic{{0, 0}, {5, 0}, {10, 0}})).points.size(), std::size_t{2});
        QCOMPARE(flatten(curve(Cubic{{0, 0}, {0, 0}, {10, 0}, {10, 0}})).points.size(), std::size_t{2});
    }

    void halving_the_tolerance_reduces_the_error() {
        for (const Piece& piece : {Piece(Quadratic{{0, 0}, {30, 60}, {70, -5}}),
                                   Piece(Cubic{{0, 0}, {10, 50}, {60, -50}, {70, 0}})}) {
            double first = 0.0;
            double before = std::numeric_limits<double>::infinity();
            std::size_t points_before = 0;
            double chord = 1.0;
            for (int i = 0; i < 8; ++i, chord /= 2.0) {
                const Polyline line = flatten(curve(piece), {chord, 180.0, 12});
                const double error = chord_error(piece, line);
                first = i == 0 ? error : first;
                QVERIFY(error <= chord);
                QVERIFY(error <= before);
                QVERIFY(line.points.size() >= points_before);
                before = error;
                points_before = line.points.size();
            }
            QVERIFY(before < first / 30.0);
        }
    }

    void degenerate_data() {
        QTest::addColumn<Piece>("piece");
        const Vec2 a(1, 2);
        const Vec2 b(30, 4);
        const auto row = [](const char* name, const Piece& piece) { QTest::newRow(name) << piece; };
        row("line_of_length_zero", Line{a, a});
        row("quadratic_in_one_point", Quadratic{a, a, a});
        row("cubic_in_one_point", Cubic{a, a, a, a});
        row("handles_of_length_zero", Cubic{a, a, b, b});
        row("one_handle_of_length_zero", Cubic{a, a, {20, 30}, b});
        row("both_handles_in_one_point", Cubic{a, {20, 30}, {20, 30}, b});
        row("quadratic_handle_on_an_end", Quadratic{a, b, b});
        row("quadratic_there_and_back", Quadratic{a, b, a});
        row("quadratic_hairpin_beyond_its_end", Quadratic{{0, 0}, {40, 0}, {10, 0}});
        row("cubic_there_and_back", Cubic{a, b, b, a});
        row("cusp", Cubic{{0, 0}, {30, 30}, {0, 30}, {30, 0}});
        row("almost_a_cusp", Cubic{{0, 0}, {30, 30}, {0, 30.000001}, {30, 0}});
        row("loop", Cubic{{0, 0}, {60, 40}, {-30, 40}, {30, 0}});
        row("closed_loop", Cubic{{0, 0}, {60, 40}, {-60, 40}, {0, 0}});
        row("straight_cubic_that_overshoots", Cubic{{0, 0}, {100, 0}, {-70, 0}, {30, 0}});
        row("handles_of_length_1e_minus_12", Cubic{a, a + Vec2(1e-12, 3e-13), b - Vec2(0, 1e-12), b});
        row("all_within_1e_minus_12", Cubic{{0, 0}, {1e-12, 1e-12}, {2e-12, -1e-12}, {3e-12, 0}});
        row("all_within_1e_minus_200", Cubic{{0, 0}, {1e-200, 1e-200}, {2e-200, -1e-200}, {3e-200, 0}});
        row("denormal", Quadratic{{0, 0}, {5e-324, 5e-324}, {0, 5e-324}});
        row("handles_of_length_1e9", Cubic{a, a + Vec2(1e9, 1e9), b + Vec2(-1e9, 1e9), b});
        row("quadratic_handle_of_length_1e9", Quadratic{a, {1e9, -1e9}, b});
        row("handles_of_length_1e200", Cubic{a, {1e200, 1e200}, {-1e200, 1e200}, b});
        row("as_large_as_doubles_go",
            Cubic{{-1.7e308, 0}, {1.7e308, 1.7e308}, {-1.7e308, 1.7e308}, {1.7e308, 0}});
    }
    void degenerate() {
        QFETCH(Piece, piece);
        const FlattenTolerance tolerance;
        const Polyline line = flatten(curve(piece), tolerance);
        QVERIFY(!line.points.empty());
        QVERIFY(all_finite(line));
        QVERIFY(line.points.front() == start_of(piece));
        QVERIFY(line.points.back() == end_of(piece));
        QVERIFY(line.points.size() <= (std::size_t{1} << tolerance.max_depth) + 1);
        for (std::size_t i = 1; i < line.points.size(); ++i)
            QVERIFY(line.points[i] != line.points[i - 1]);
        double size = 0.0;
        for (const Vec2 p : line.points)
            size = std::max({size, std::abs(p.x), std::abs(p.y)});
        if (size < 1e6) // beyond, the greatest depth ends the search
            QVERIFY(chord_error(piece, line, 2000) <= tolerance.chord);
    }

    void depth_limits_the_segments() {
        const Piece piece = Cubic{{0, 0}, {1e9, 1e9}, {-1e9, 1e9}, {30, 0}};
        for (const int depth : {0, 1, 5})
            QCOMPARE(flatten(curve(piece), {1e-12, 1e-9, depth}).points.size(),
                     (std::size_t{1} << depth) + 1);
    }

    void joints_are_kept_and_not_repeated() {
        const Contour contour{
            "a",
            {Line{{0, 0}, {10, 0}}, Quadratic{{10, 0}, {20, 0}, {20, 10}}, Line{{20, 10}, {0, 0}}},
            true};
        const Polyline line = flatten(contour);
        QVERIFY(line.closed);
        for (const Vec2 joint : {Vec2(0, 0), Vec2(10, 0), Vec2(20, 10)})
            QCOMPARE(std::count(line.points.begin(), line.points.end(), joint), 1);
    }

    void pieces_that_are_not_finite_are_left_out() {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const Contour contour{
            "a",
            {Line{{0, 0}, {1, 0}}, Cubic{{1, 0}, {nan, 0}, {0, 0}, {2, 0}}, Line{{2, 0}, {3, 0}}},
            false};
        const Polyline line = flatten(contour);
        QVERIFY(all_finite(line));
        QCOMPARE(line.points.size(), std::size_t{4});
        QVERIFY(flatten(Contour{"b", {Line{{nan, 0}, {1, 1}}}, true}).points.empty());
        QVERIFY(flatten(Contour{}).points.empty());
    }

    /// A segment more than the bounds ask for is work at each of a thousand ticks a second; one less is felt.
    void one_segment_where_the_chord_allows_it_and_two_where_not_data() {
        QTest::addColumn<Piece>("piece");
        QTest::addColumn<bool>("one");
        const auto row = [](const char* name, const Piece& piece, bool one) {
            QTest::newRow(name) << piece << one;
        };
        // A quadratic leaves its chord by half of what its handle does.
        row("quadratic_within", Quadratic{{0, 0}, {5, 0.0199}, {10, 0}}, true);
        row("quadratic_beyond", Quadratic{{0, 0}, {5, 0.0201}, {10, 0}}, false);
        row("quadratic_below_the_chord", Quadratic{{0, 0}, {5, -0.0201}, {10, 0}}, false);
        // A cubic by three quarters.
        row("cubic_within", Cubic{{0, 0}, {3, 0.0133}, {7, 0.0133}, {10, 0}}, true);
        row("cubic_beyond", Cubic{{0, 0}, {3, 0.0134}, {7, 0.0134}, {10, 0}}, false);
        row("cubic_beyond_by_its_first_handle", Cubic{{0, 0}, {3, 0.0134}, {7, 0.0}, {10, 0}}, false);
        row("cubic_beyond_by_its_second_handle", Cubic{{0, 0}, {3, 0.0}, {7, -0.0134}, {10, 0}}, false);
    }
    void one_segment_where_the_chord_allows_it_and_two_where_not() {
        QFETCH(Piece, piece);
        QFETCH(bool, one);
        const Polyline line = flatten(curve(piece), {0.01, 180.0, 12});
        QCOMPARE(line.segment_count() == 1, one);
        QVERIFY(chord_error(piece, line) <= 0.01);
    }

    void one_segment_where_the_turn_allows_it_and_two_where_not_data() {
        QTest::addColumn<Piece>("piece");
        QTest::addColumn<bool>("one");
        const auto row = [](const char* name, const Piece& piece, bool one) {
            QTest::newRow(name) << piece << one;
        };
        const auto bend = [](double degrees) {
            const double angle = degrees * std::numbers::pi / 180.0;
            return 10.0 * Vec2(std::cos(angle), std::sin(angle));
        };
        const Vec2 at(10, 0);
        row("quadratic_within", Quadratic{{0, 0}, at, at + bend(1.98)}, true);
        row("quadratic_beyond", Quadratic{{0, 0}, at, at + bend(2.02)}, false);
        row("quadratic_to_the_other_side", Quadratic{{0, 0}, at, at + bend(-2.02)}, false);
        row("cubic_within", Cubic{{0, 0}, at, at + bend(0.99), at + bend(0.99) + bend(1.98)}, true);
        row("cubic_beyond", Cubic{{0, 0}, at, at + bend(1.01), at + bend(1.01) + bend(2.02)}, false);
        row("cubic_there_and_back", Cubic{{0, 0}, at, at + bend(1.01), at + bend(1.01) + bend(0.0)}, false);
        row("cubic_of_one_handle_within", Cubic{{0, 0}, at, at, at + bend(1.98)}, true);
        row("cubic_of_one_handle_beyond", Cubic{{0, 0}, at, at, at + bend(2.02)}, false);
        const Vec2 far(-30, 70);
        row("cubic_of_one_handle_elsewhere_within", Cubic{far, far + at, far + at, far + at + bend(1.98)},
            true);
        row("cubic_of_one_handle_elsewhere_beyond", Cubic{far, far + at, far + at, far + at + bend(2.02)},
            false);
        row("quadratic_elsewhere_within", Quadratic{far, far + at, far + at + bend(1.98)}, true);
        row("cubic_elsewhere_within",
            Cubic{far, far + at, far + at + bend(0.99), far + at + bend(0.99) + bend(1.98)}, true);
        row("cubic_that_turns_at_its_start_alone", Cubic{{0, 0}, at, at + bend(1.98), at + 2.0 * bend(1.98)},
            true);
    }
    void one_segment_where_the_turn_allows_it_and_two_where_not() {
        QFETCH(Piece, piece);
        QFETCH(bool, one);
        QCOMPARE(flatten(curve(piece), {100.0, 2.0, 12}).segment_count() == 1, one);
    }

    /// Just what is allowed is not too much: a corner of 90 degrees, in one turn or in two halves, and a handle
    /// that leaves the chord by twice the tolerance.
    void a_bound_itself_is_kept() {
        QCOMPARE(flatten(curve(Quadratic{{0, 0}, {10, 0}, {10, 10}}), {100.0, 90.0, 12}).segment_count(),
                 std::size_t{1});
        QCOMPARE(
            flatten(curve(Cubic{{0, 0}, {10, 0}, {20, 10}, {20, 20}}), {100.0, 90.0, 12}).segment_count(),
            std::size_t{1});
        QCOMPARE(flatten(curve(Quadratic{{0, 0}, {5, 1}, {10, 0}}), {0.5, 180.0, 12}).segment_count(),
                 std::size_t{1});
        QCOMPARE(flatten(curve(Cubic{{0, 0}, {3, 1}, {7, -1}, {10, 0}}), {0.75, 360.0, 12}).segment_count(),
                 std::size_t{1});
    }

    /// A quarter of a circle as drawing programs make it: 90 degrees in steps of two are 45, and halving
    /// makes 64.
    void a_quarter_circle_is_no_more_segments_than_it_needs() {
        constexpr double handle = 0.5522847498;
        const Piece quarter = Cubic{{50, 0}, {50, 50 * handle}, {50 * handle, 50}, {0, 50}};
        QCOMPARE(flatten(curve(quarter)).segment_count(), std::size_t{64});
        const Piece parabola = Quadratic{{50, 0}, {50, 50}, {0, 50}};
        QVERIFY(flatten(curve(parabola)).segment_count() <= std::size_t{80});
    }

    /// A line that returns to where it began is not closed by that: the segment that leads back to the start
    /// stays.
    void an_open_line_keeps_its_end_though_it_is_its_start() {
        const Contour contour = contour_through("a", {{0, 0}, {10, 0}, {10, 10}, {0, 0}}, false);
        const Polyline line = flatten(contour);
        QCOMPARE(line.points.size(), std::size_t{4});
        QCOMPARE(length_of(line), 20.0 + std::hypot(10.0, 10.0));
        // A closed one ends where it likes: what leads back is the closing segment.
        const Polyline closed = flatten({"b", {Line{{0, 0}, {10, 0}}, Line{{10, 0}, {10, 10}}}, true});
        QCOMPARE(closed.points.size(), std::size_t{3});
        QCOMPARE(flatten({"dot", {Line{{1, 1}, {1, 1}}, Line{{1, 1}, {1, 1}}}, true}).points.size(),
                 std::size_t{1});
    }

    void a_dot_is_one_point() {
        for (const bool closed : {false, true})
            QCOMPARE(flatten(contour_through("dot", {{3, 4}}, closed)).points.size(), std::size_t{1});
    }
};

QTEST_GUILESS_MAIN(FlattenTest)
#include "flatten_test.moc"
