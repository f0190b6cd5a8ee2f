// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/spacing.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

namespace spacing_test {

using namespace tp;
using namespace tp::testing;

namespace {

FlatScene two_lines(double gap) {
    return {{"upper", "lower"}, {{{{-20, gap}, {20, gap}}, false}, {{{-30, 0}, {5, 0}, {30, 0}}, false}}};
}

Contour eye(double opening) {
    const Polyline line = ellipse({3, 2}, 14, 0.5 * opening, 200);
    return contour_through("left_eye", line.points, true);
}

} // namespace

class SpacingTest : public QObject {
    Q_OBJECT
private slots:
    void two_lines_a_gap_apart_leave_half_the_gap_of_force() {
        const auto pairs = closeness(two_lines(4.0), {0.2, 4.0});
        QCOMPARE(pairs.size(), std::size_t(1));
        QCOMPARE(pairs[0].gap, 4.0);
        QVERIFY(std::abs(pairs[0].peak - 0.4) < 1e-12);
        QVERIFY(pairs[0].tellable);
        QVERIFY(!closeness(two_lines(0.7), {})[0].tellable);
        QVERIFY(closeness(two_lines(8.0), {0.2, 4.0}).empty());
    }

    void at_the_end_of_doubles_the_middle_is_none_beyond_it() {
        const Contour far = contour_through("eye", {{-1e308, 30.0}, {-1e308, 22.0}, {-1e308, 38.0}}, true);
        const auto line = thinned(far);
        QVERIFY(line.has_value());
        for (const Piece& piece : line->pieces)
            QVERIFY(is_finite(piece));
    }

    void a_contour_too_long_for_a_double_is_not_thinned() {
        const Contour endless =
            contour_through("endless", {{-1.5e308, 0}, {1.5e308, 0}, {1.5e308, 0.1}}, true);
        QVERIFY(!thinned(endless));
    }

    void a_shorter_range_is_proposed_where_pulls_would_meet() {
        const TentProfile usual{0.2, 4.0};
        const auto proposed = [&](double gap, TentProfile profile) {
            return proposed_profile(closeness(two_lines(gap), profile), profile);
        };
        const auto closer = proposed(7.9, {0.2, 6.0}); // a quarter of it would be below 2 mm
        QVERIFY(closer);
        QCOMPARE(closer->range, 2.0);
        QCOMPARE(closer->stiffness, 0.5); // 0.6 would keep the peak, but was never tried
        const auto wide = proposed(12.0, {0.1, 8.0});
        QVERIFY(wide);
        QCOMPARE(wide->range, 3.0); // bands of 6 mm end where they meet
        QVERIFY(std::abs(wide->peak() - 0.8) < 1e-12);
        QVERIFY(!proposed(9.0, usual));      // out of each other's reach
        QVERIFY(!proposed(0.7, usual));      // not to be told apart anyway
        QVERIFY(!proposed(4.0, {0.2, 2.0})); // as short as it gets
        QVERIFY(!proposed_profile({}, usual));
    }

    void equals_brute_force_and_sorts_the_narrowest_first() {
        std::mt19937 random(11);
        for (int round = 0; round < 100; ++round) {
            const FlatScene scene = random_scene(random, 20.0);
            const auto pairs = closeness(scene, {0.2, 4.0});
            for (std::size_t i = 1; i < pairs.size(); ++i)
                QVERIFY(pairs[i - 1].gap <= pairs[i].gap);
            for (const Closeness& pair : pairs) {
                const Polyline& a = scene.lines[static_cast<std::size_t>(pair.first)];
                const Polyline& b = scene.lines[static_cast<std::size_t>(pair.second)];
                QVERIFY(distance_to(a, pair.where) < 1e-9);
                QVERIFY(std::abs(distance_to(b, pair.where) - pair.gap) < 1e-9);
                for (const Vec2 p : resampled(a, 500).points)
                    QVERIFY(distance_to(b, p) >= pair.gap - 1e-9);
            }
        }
    }

    /// Wherever on the two lines they come closest: at an end, at a vertex, in the middle.
    void the_narrowest_place_is_found_wherever_it_is() {
        const std::vector<Vec2> still{{-10, 0}, {10, 0}};
        for (const bool first : {true, false})
            for (const bool turned : {true, false})
                for (const double x : {-4.0, 0.0, 7.0}) {
                    std::vector<Vec2> tip{{x, 1.5}, {x - 1.0, 12.0}};
                    if (turned)
                        std::swap(tip[0], tip[1]);
                    FlatScene scene{{"a", "b"}, {{first ? still : tip, false}, {first ? tip : still, false}}};
                    const auto pairs = closeness(scene, {0.2, 4.0});
                    QCOMPARE(pairs.size(), std::size_t(1));
                    QVERIFY(pairs[0].first == 0 && pairs[0].second == 1);
                    QCOMPARE(pairs[0].gap, 1.5);
                    QVERIFY(length(pairs[0].where - (first ? Vec2(x, 0) : Vec2(x, 1.5))) < 1e-12);
                    QVERIFY(std::abs(pairs[0].peak - 0.15) < 1e-12);
                }
        // No pull is left over that is stronger than one line's own.
        QVERIFY(std::abs(closeness(two_lines(11.0), {0.2, 6.0})[0].peak - 1.1) < 1e-12);
        QVERIFY(closeness(two_lines(1.0), {})[0].tellable);
    }

    void lines_that_cross_off_their_middles_cross_where_they_do() {
        const FlatScene cross{{"a", "b"}, {{{{0, 0}, {8, 4}}, false}, {{{5, -1}, {3, 4}}, false}}};
        const auto pairs = closeness(cross, {});
        QCOMPARE(pairs[0].gap, 0.0);
        QVERIFY(distance_to(cross.lines[0], pairs[0].where) < 1e-12);
        QVERIFY(distance_to(cross.lines[1], pairs[0].where) < 1e-12);
        QCOMPARE(pairs[0].peak, 0.0);
        // Their endless lines cross, they do not.
        const FlatScene apart{{"a", "b"}, {{{{0, 0}, {8, 0}}, false}, {{{9, 1}, {10, -1}}, false}}};
        QVERIFY(closeness(apart, {})[0].gap > 1.0);
        const FlatScene other{{"a", "b"}, {{{{9, 1}, {10, -1}}, false}, {{{0, 0}, {8, 0}}, false}}};
        QVERIFY(closeness(other, {})[0].gap == closeness(apart, {})[0].gap);
    }

    void crossing_contours_have_no_gap() {
        const FlatScene cross{{"a", "b"}, {{{{-5, -5}, {5, 5}}, false}, {{{-5, 5}, {5, -5}}, false}}};
        const auto pairs = closeness(cross, {});
        QCOMPARE(pairs[0].gap, 0.0);
        QVERIFY(length(pairs[0].where) < 1e-12);
        QVERIFY(!pairs[0].tellable);
    }

    void a_shut_eye_becomes_one_line_and_an_open_one_stays() {
        const auto line = thinned(eye(0.8));
        QVERIFY(line.has_value());
        QVERIFY(!line->closed);
        QCOMPARE(line->name, std::string("left_eye"));
        const Polyline flat = flatten(*line);
        QVERIFY(std::abs(length_of(flat) - 28.0) < 0.3);
        for (const Vec2 p : flat.points)
            QVERIFY(std::abs(p.y - 2.0) < 0.05);
        QVERIFY(!thinned(eye(1.2)).has_value());
        QVERIFY(!thinned(eye(10.0)).has_value());
    }

    void a_bent_shut_eye_keeps_its_bend() {
        std::vector<Vec2> points;
        for (int x = -15; x <= 15; ++x)
            points.emplace_back(x, 0.02 * x * x + 0.3);
        for (int x = 14; x >= -14; --x)
            points.emplace_back(x, 0.02 * x * x - 0.3);
        const auto line = thinned(contour_through("eye", points, true));
        QVERIFY(line.has_value());
        for (const Vec2 p : flatten(*line).points)
            QVERIFY(std::abs(p.y - 0.02 * p.x * p.x) < 0.35); // half the eye's thickness, at its ends
    }

    void a_sliver_of_three_points_becomes_one_line() {
        const Vec2 corners[] = {{-10, 0}, {10, 0}, {0, 0.4}};
        const Contour sliver = contour_through("eye", {std::begin(corners), std::end(corners)}, true);
        QVERIFY(thinned(sliver).has_value());
    }

    void open_and_degenerate_contours_are_left_alone() {
        QVERIFY(!thinned(contour_through("outline", {{0, 0}, {10, 0}, {20, 0.1}}, false)).has_value());
        QVERIFY(!thinned(contour_through("dot", {{1, 1}}, true)).has_value());
        QVERIFY(!thinned(Contour{"nothing", {}, true}).has_value());
    }
};

} // namespace spacing_test

TP_TEST(spacing_test, SpacingTest, nothing)
#include "spacing_test.moc"
