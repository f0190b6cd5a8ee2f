// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/corner_cue.hpp"
#include "core/guidance/exact_law.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>

namespace corner_cue_test {

using namespace tp;
using namespace tp::testing;

namespace {

FlatScene polygon(int corners, double radius) {
    return {{"polygon"}, {ellipse({0, 0}, radius, radius, corners)}};
}

CornerCueLaw cued(const FlatScene& scene, TentProfile tent = {}) {
    return {std::make_unique<ExactLaw>(scene, tent), scene, tent};
}

} // namespace

class CornerCueTest : public QObject {
    Q_OBJECT
private slots:
    void polygons_have_their_corners_and_circles_none() {
        for (const int corners : {3, 4, 5, 6})
            for (const double radius : {20.0, 50.0, 80.0})
                QCOMPARE(corners_of(polygon(corners, radius)).size(), std::size_t(corners));
        for (const int facets : {40, 200, 5000})
            QCOMPARE(corners_of(polygon(facets, 20.0)).size(), std::size_t(0));
        // The corner is where it is, however finely its sides are cut.
        FlatScene square = polygon(4, 30.0);
        square.lines.front() = resampled(square.lines.front(), 4000);
        std::vector<Vec2> corners = corners_of(square);
        QCOMPARE(corners.size(), std::size_t(4));
        for (const Vec2 corner : corners)
            QVERIFY(std::abs(length(corner) - 30.0) < 0.05);
    }

    void eyes_have_two_corners_and_open_ends_are_none() {
        const std::vector<Vec2> eye = corners_of({{"eye"}, {ellipse({5, 5}, 14, 5, 200)}});
        QCOMPARE(eye.size(), std::size_t(2));
        for (const Vec2 corner : eye)
            QVERIFY(std::abs(std::abs(corner.x - 5.0) - 14.0) < 0.2);
        QCOMPARE(corners_of({{"line"}, {{{{0, 0}, {10, 0}, {20, 0}}, false}}}).size(), std::size_t(0));
        QCOMPARE(corners_of({{"bent"}, {{{{0, 0}, {10, 0}, {10, 10}}, false}}}).size(), std::size_t(1));
    }

    void a_bend_is_a_corner_half_a_window_from_an_end_and_on_lines_longer_than_four() {
        const auto corners_of_bend = [](double before, double after) {
            return corners_of({{"bent"}, {{{{0, 0}, {before, 0}, {before, after}}, false}}}).size();
        };
        QCOMPARE(corners_of_bend(10.0, 0.5), std::size_t(1)); // the window is 1 mm
        QCOMPARE(corners_of_bend(10.0, 0.49), std::size_t(0));
        QCOMPARE(corners_of_bend(0.5, 10.0), std::size_t(1));
        QCOMPARE(corners_of_bend(0.49, 10.0), std::size_t(0));
        QCOMPARE(corners_of_bend(2.0, 2.0), std::size_t(0));
        QCOMPARE(corners_of_bend(2.0, 2.001), std::size_t(1));
    }

    void degenerate_lines_have_no_corners() {
        const double nan = std::nan("");
        for (const Polyline& line :
             {Polyline{{}, true}, Polyline{{{1, 1}}, true}, Polyline{{{1, 1}, {1, 1}, {1, 1}}, true},
              Polyline{{{0, 0}, {nan, 0}, {5, 5}}, false}, Polyline{{{0, 0}, {1e-12, 0}, {0, 1e-12}}, true},
              Polyline{{{-1e308, 0}, {1e308, 0}, {1e308, 1e308}}, false}})
            QCOMPARE(corners_of({{"line"}, {line}}).size(), std::size_t(0));
    }

    /// Of two bends closer than two windows only the sharper is a corner, round the end of a closed line too.
    void of_bends_close_to_one_another_the_sharpest_is_the_corner() {
        const auto corners = [](std::vector<Vec2> points, bool closed) {
            return corners_of({{"line"}, {{std::move(points), closed}}});
        };
        // 45° at (10, 0), 90° `apart` mm farther
        const auto two_bends = [&](double apart) {
            const Vec2 second = Vec2(10, 0) + apart * std::numbers::sqrt2 * Vec2(0.5, 0.5);
            return corners({{0, 0}, {10, 0}, second, second + Vec2(-7, 7)}, false);
        };
        QCOMPARE(two_bends(1.9).size(), std::size_t(1));
        QVERIFY(length(two_bends(1.9)[0] - Vec2(10, 0)) > 1.0);
        QCOMPARE(two_bends(2.1).size(), std::size_t(2));
        // A chamfered square that begins in the middle of its chamfer: one corner there, not two.
        const std::vector<Vec2> square{{0.5, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 0.5}};
        QCOMPARE(corners(square, true).size(), std::size_t(4));
    }

    void a_corner_is_more_than_30_degrees() {
        for (const double degrees : {29.0, 31.0, -29.0, -31.0, 150.0}) {
            const double angle = degrees * std::numbers::pi / 180.0;
            const Vec2 end = Vec2(10, 0) + 10.0 * Vec2(std::cos(angle), std::sin(angle));
            const auto found = corners_of({{"bent"}, {{{{0, 0}, {10, 0}, end}, false}}});
            QCOMPARE(found.size(), std::size_t(std::abs(degrees) > 30.0 ? 1 : 0));
            if (!found.empty())
                QVERIFY(found[0] == Vec2(10, 0));
        }
    }

    void a_well_is_as_deep_and_wide_as_promised() {
        const FlatScene bent{{"bent"}, {{{{-30, 0}, {0, 0}, {0, 30}}, false}}};
        for (const TentProfile tent : {TentProfile{0.2, 4.0}, TentProfile{0.5, 3.0}}) {
            const CornerCueLaw law = cued(bent, tent);
            const ExactLaw plain(bent, tent);
            QCOMPARE(law.corner_count(), std::size_t(1));
            QCOMPARE(law.reach(), 0.5 * tent.range);
            const double depth = plain.at({0, 0}).energy - law.at({0, 0}).energy;
            // its steepest slope, 8E/(3√3·R), is a fifth of the peak
            QVERIFY(std::abs(depth * 8.0 / (3.0 * std::numbers::sqrt3 * law.reach()) - 0.2 * tent.peak()) <
                    1e-12);
            for (const double share : {0.25, 0.5, 0.75}) {
                const Vec2 place(0.0, share * law.reach());
                const double left = 1.0 - share * share;
                QVERIFY(std::abs(plain.at(place).energy - law.at(place).energy - depth * left * left) <
                        1e-12);
            }
            const Vec2 beyond(0.0, 1.001 * law.reach());
            QVERIFY(law.at(beyond).force == plain.at(beyond).force &&
                    law.at(beyond).energy == plain.at(beyond).energy);
        }
    }

    void the_tick_pulls_on_and_then_back() {
        const FlatScene bent{{"bent"}, {{{{-30, 0}, {0, 0}, {0, 30}}, false}}};
        const TentProfile tent;
        const CornerCueLaw law = cued(bent, tent);
        const ExactLaw plain(bent, tent);
        double most = 0.0;
        for (double x = -4.0; x <= 0.0; x += 0.01) { // along the contour towards the corner
            const Vec2 tick = law.at({x, 0.0}).force - plain.at({x, 0.0}).force;
            QVERIFY(tick.x >= 0.0);
            most = std::max(most, tick.x);
            QVERIFY(x > -law.reach() || tick == Vec2(0.0));
        }
        for (double y = 0.1; y < law.reach(); y += 0.1) // and away from it
            QVERIFY(law.at({0.0, y}).force.y < plain.at({0.0, y}).force.y);
        const double promised = CornerCueLaw::share_of_peak * tent.peak();
        QVERIFY(std::abs(most - promised) < 0.001 * promised);
        QVERIFY(law.at({0.0, 0.0}).force == Vec2(0.0));
    }

    void a_well_is_a_potential() {
        std::mt19937 random(9);
        const CornerCueLaw law = cued(polygon(5, 20.0));
        const double h = 1e-6;
        int compared = 0;
        for (int k = 0; k < 5000; ++k) {
            const Vec2 p = random_point(random, 26.0);
            const auto U = [&](double dx, double dy) { return law.at(p + Vec2(dx, dy)).energy; };
            const Vec2 gradient((U(h, 0) - U(-h, 0)) / (2 * h), (U(0, h) - U(0, -h)) / (2 * h));
            const Vec2 one_sided((U(h, 0) - U(0, 0)) / h, (U(0, h) - U(0, 0)) / h);
            if (length(one_sided - gradient) > 1e-4)
                continue;
            ++compared;
            QVERIFY(length(law.at(p).force + gradient) < 1e-3);
        }
        QVERIFY(compared > 4000);
    }
};

} // namespace corner_cue_test

TP_TEST(corner_cue_test, CornerCueTest, nothing)
#include "corner_cue_test.moc"
