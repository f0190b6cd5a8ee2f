// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/flatten.hpp"
#include "faces/pieces/contour_fit.hpp"

#include <QTest>

#include <numbers>

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

/// An eye of 16 points with unevenly spaced lids; corners at 0 and 8.
Points almond() {
    Points points;
    for (int i = 0; i < 16; ++i) {
        const double t = i <= 8 ? i / 8.0 : (16 - i) / 8.0;
        points.emplace_back(20.0 * (t + t * t), (i < 8 ? 6.0 : -9.0) * std::sin(std::numbers::pi * t));
    }
    return points;
}

struct Ends {
    Vec2 start_direction, end_direction;
};
Ends directions(const Piece& piece) {
    if (const auto* q = std::get_if<Quadratic>(&piece))
        return {glm::normalize(q->control - q->a), glm::normalize(q->b - q->control)};
    const Line line = std::get<Line>(piece);
    return {glm::normalize(line.b - line.a), glm::normalize(line.b - line.a)};
}

double turn_degrees(Vec2 a, Vec2 b) {
    return std::abs(std::atan2(cross(a, b), glm::dot(a, b))) * 180.0 / std::numbers::pi;
}

} // namespace

class ContourFitTest : public QObject {
    Q_OBJECT

private slots:
    void passes_through_every_point() {
        const Points points = almond();
        const Polyline line = flatten(fit_contour("eye", points, true, {0, 8}), {1e-4, 1.0, 12});
        for (Vec2 p : points)
            QVERIFY(distance_to(line, p) < 1e-9);
    }
    void pieces_join_and_close() {
        const Contour contour = fit_contour("eye", almond(), true, {0, 8});
        QCOMPARE(contour.name, std::string("eye"));
        QVERIFY(contour.closed);
        QCOMPARE(contour.pieces.size(), std::size_t{32});
        for (std::size_t i = 0; i < contour.pieces.size(); ++i)
            QCOMPARE(end_of(contour.pieces[i]), start_of(contour.pieces[(i + 1) % contour.pieces.size()]));
    }
    void direction_is_continuous_except_at_corners() {
        const Contour contour = fit_contour("eye", almond(), true, {0, 8});
        for (std::size_t i = 0; i < contour.pieces.size(); ++i) {
            const double turn = turn_degrees(directions(contour.pieces[i]).end_direction,
                                             directions(contour.pieces[(i + 1) % 32]).start_direction);
            const bool corner = i == 31 || i == 15; // two pieces a span
            QVERIFY2(corner ? turn > 30.0 : turn < 1e-6,
                     qPrintable(QString("joint %1: %2°").arg(i).arg(turn)));
        }
    }
    void follows_a_circle() {
        const Polyline line = flatten(fit_contour("circle", circle(16, 50.0), true), {1e-4, 1.0, 12});
        for (Vec2 p : line.points)
            QVERIFY(std::abs(length(p) - 50.0) < 0.1);
    }
    void open_curve_keeps_its_ends() {
        const Points points = circle(9, 10.0);
        const Contour contour = fit_contour("outline", points, false);
        QVERIFY(!contour.closed);
        QCOMPARE(contour.pieces.size(), std::size_t{16});
        QCOMPARE(start_of(contour.pieces.front()), points.front());
        QCOMPARE(end_of(contour.pieces.back()), points.back());
    }
    void does_not_overshoot_uneven_points() {
        const Points points{{0, 0}, {100, 0}, {101, 1}, {101, 100}};
        for (Vec2 p : flatten(fit_contour("bend", points, false)).points)
            QVERIFY(p.x > -1.0 && p.x < 103.0 && p.y > -2.0 && p.y < 101.0);
    }
    void repeated_points_are_skipped() {
        Points points = almond();
        points.insert(points.begin() + 3, points[3]);
        points.push_back(points.front());
        for (const Piece& piece : fit_contour("eye", points, true).pieces)
            QVERIFY(is_finite(piece));
    }
    void few_points() {
        QVERIFY(fit_contour("none", {}, true).pieces.empty());
        QVERIFY(fit_contour("one", {{1, 2}, {1, 2}}, false).pieces.empty());
        QCOMPARE(fit_contour("two", {{1, 2}, {3, 4}}, false).pieces.size(), std::size_t{1});
        QCOMPARE(fit_contour("corners", {{0, 0}, {5, 1}, {9, 9}}, true, {0, 1, 2}).pieces.size(),
                 std::size_t{3});
    }

    void uncrossed_leaves_an_open_eye_alone() {
        QCOMPARE(uncrossed(almond(), 8), almond());
        Points mirrored = almond();
        for (Vec2& p : mirrored)
            p.x = -p.x;
        QCOMPARE(uncrossed(mirrored, 8), mirrored);
    }
    void uncrossed_parts_lids_that_have_changed_sides() {
        Points points = almond();
        std::swap(points[3], points[13]);
        const Points mended = uncrossed(points, 8);
        QCOMPARE(mended[3], mended[13]);
        QCOMPARE(mended[3], 0.5 * (points[3] + points[13]));
        QCOMPARE(mended[4], points[4]);
    }
};

QTEST_GUILESS_MAIN(ContourFitTest)
#include "contour_fit_test.moc"
