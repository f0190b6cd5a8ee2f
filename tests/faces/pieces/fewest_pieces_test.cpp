// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/flatten.hpp"
#include "faces/pieces/contour_fit.hpp"
#include "faces/pieces/fewest_pieces.hpp"

#include <QTest>

#include <algorithm>
#include <numbers>
#include <random>

using namespace tp;

namespace {

using Points = std::vector<Vec2>;

Points circle(std::size_t count, double radius) {
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return points;
}

/// An eye `width` px wide: two lids of 26 points, corners at 0 and 25, lids wavy by chance.
Points eye(double width, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(0.5, 1.5);
    const double low = 0.15 * any(random), high = 0.25 * any(random), skew = 0.2 * any(random);
    Points points;
    for (int i = 0; i < 50; ++i) {
        const double t = i <= 25 ? i / 25.0 : (50 - i) / 25.0;
        const double arch = std::sin(std::numbers::pi * t) + skew * std::sin(2.0 * std::numbers::pi * t);
        points.emplace_back(width * t, width * arch * (i < 25 ? low : -high));
    }
    return points;
}

/// Largest distance of either curve's places to the other one.
double apart(const Contour& a, const Contour& b) {
    const FlattenTolerance fine{0.002, 1.0, 12};
    const Polyline one = flatten(a, fine), other = flatten(b, fine);
    double most = 0.0;
    for (Vec2 p : resampled(one, 500).points)
        most = std::max(most, distance_to(other, p));
    for (Vec2 p : resampled(other, 500).points)
        most = std::max(most, distance_to(one, p));
    return most;
}

Vec2 leaving(const Piece& piece) {
    const auto* q = std::get_if<Quadratic>(&piece);
    return glm::normalize((q ? q->control : end_of(piece)) - start_of(piece));
}
Vec2 arriving(const Piece& piece) {
    const auto* q = std::get_if<Quadratic>(&piece);
    return glm::normalize(end_of(piece) - (q ? q->control : start_of(piece)));
}
double turn_degrees(const Piece& before, const Piece& after) {
    const Vec2 a = arriving(before), b = leaving(after);
    return std::abs(std::atan2(cross(a, b), glm::dot(a, b))) * 180.0 / std::numbers::pi;
}

} // namespace

class FewestPiecesTest : public QObject {
    Q_OBJECT

private slots:
    void stays_within_the_tolerance_data() {
        QTest::addColumn<double>("width");
        for (double width : {12.0, 60.0, 300.0, 1500.0})
            QTest::addRow("eye of %.0f px", width) << width;
    }
    void stays_within_the_tolerance() {
        QFETCH(double, width);
        for (double tolerance : {0.05, 0.2, 1.0})
            for (unsigned seed = 1; seed <= 20; ++seed) {
                const Points points = eye(width, seed);
                const Contour exact = fit_contour("eye", points, true, {0, 25});
                const Contour few = fewest_pieces("eye", points, true, {0, 25}, tolerance);
                QVERIFY2(apart(exact, few) <= 1.1 * tolerance,
                         qPrintable(QString::number(apart(exact, few))));
                QVERIFY(few.pieces.size() <= exact.pieces.size());
                QCOMPARE(few.name, exact.name);
                QVERIFY(few.closed);
            }
    }
    void needs_fewer_pieces_for_less() {
        double last = 1e9;
        for (double tolerance : {0.01, 0.05, 0.2, 0.5, 2.0}) {
            double pieces = 0.0;
            for (unsigned seed = 1; seed <= 20; ++seed)
                pieces += static_cast<double>(
                    fewest_pieces("eye", eye(80.0, seed), true, {0, 25}, tolerance).pieces.size());
            qInfo("tolerance %.2f px: %.1f pieces an eye of 80 px", tolerance, pieces / 20.0);
            QVERIFY(pieces < last);
            last = pieces;
        }
        QVERIFY(last / 20.0 <= 6.0);
    }
    void joins_are_smooth_except_at_corners() {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const Points points = eye(80.0, seed);
            const Contour few = fewest_pieces("eye", points, true, {0, 25}, 0.2);
            int corners = 0;
            for (std::size_t i = 0; i < few.pieces.size(); ++i) {
                const Piece& next = few.pieces[(i + 1) % few.pieces.size()];
                QCOMPARE(end_of(few.pieces[i]), start_of(next));
                if (end_of(few.pieces[i]) == points[0] || end_of(few.pieces[i]) == points[25])
                    ++corners;
                else // a line may stand for a curve that bends by half a degree
                    QVERIFY2(turn_degrees(few.pieces[i], next) < 0.6,
                             qPrintable(QString::number(turn_degrees(few.pieces[i], next))));
            }
            QCOMPARE(corners, 2);
        }
    }
    /// A quadratic that spans the angle a misses the circle by about r (a/2)⁴ / 8.
    void a_circle_takes_about_as_many_as_it_must() {
        const double radius = 100.0, tolerance = 0.2;
        const Contour few = fewest_pieces("circle", circle(72, radius), true, {}, tolerance);
        QVERIFY(apart(few, fit_contour("circle", circle(72, radius), true)) <= tolerance);
        const double angle = 2.0 * std::pow(8.0 * tolerance / radius, 0.25);
        const double must = 2.0 * std::numbers::pi / angle;
        QVERIFY2(static_cast<double>(few.pieces.size()) <= 1.35 * must + 1.0,
                 qPrintable(QString("%1 for %2").arg(few.pieces.size()).arg(must)));
        for (std::size_t i = 0; i < few.pieces.size(); ++i)
            QVERIFY(turn_degrees(few.pieces[i], few.pieces[(i + 1) % few.pieces.size()]) < 0.6);
    }
    void straight_parts_are_lines() {
        Points points;
        for (int i = 0; i <= 30; ++i)
            points.emplace_back(3.0 * i, 7.0);
        const Contour few = fewest_pieces("edge", points, false, {}, 0.2);
        QCOMPARE(few.pieces.size(), std::size_t{1});
        QVERIFY(std::holds_alternative<Line>(few.pieces[0]));
        QCOMPARE(start_of(few.pieces[0]), points.front());
        QCOMPARE(end_of(few.pieces[0]), points.back());
    }
    void open_curves_keep_their_ends() {
        const Points points = circle(40, 50.0);
        const Contour few = fewest_pieces("outline", points, false, {}, 0.2);
        QVERIFY(!few.closed);
        QCOMPARE(start_of(few.pieces.front()), points.front());
        QCOMPARE(end_of(few.pieces.back()), points.back());
    }
    void noisy_and_repeated_points_are_safe() {
        std::mt19937 random(3);
        std::normal_distribution<double> grain(0.0, 2.0);
        for (int round = 0; round < 50; ++round) {
            Points points = eye(40.0, static_cast<unsigned>(round));
            for (Vec2& p : points)
                p += Vec2(grain(random), grain(random));
            points[10] = points[11] = points[12];
            const Contour exact = fit_contour("eye", points, true, {0, 25});
            const Contour few = fewest_pieces("eye", points, true, {0, 25}, 0.2);
            for (std::size_t i = 0; i < few.pieces.size(); ++i) {
                QVERIFY(is_finite(few.pieces[i]));
                QCOMPARE(end_of(few.pieces[i]), start_of(few.pieces[(i + 1) % few.pieces.size()]));
            }
            QVERIFY(few.pieces.size() <= exact.pieces.size());
        }
        QVERIFY(fewest_pieces("none", {}, true, {}, 0.2).pieces.empty());
        QVERIFY(fewest_pieces("one", {{1, 2}, {1, 2}}, false, {}, 0.2).pieces.empty());
        QCOMPARE(fewest_pieces("two", {{1, 2}, {3, 4}}, false, {}, 0.2).pieces.size(), std::size_t{1});
    }
};

QTEST_GUILESS_MAIN(FewestPiecesTest)
#include "fewest_pieces_test.moc"
