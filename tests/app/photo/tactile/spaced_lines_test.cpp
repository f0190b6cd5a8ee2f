// SPDX-License-Identifier: Apache-2.0
#include "app/photo/tactile/spaced_lines.hpp"
#include "core/geometry/flatten.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace spaced_lines_test {

using namespace tp;

namespace {

Contour line(double x1, double y1, double x2, double y2) { return contour_through("line", {{x1, y1}, {x2, y2}}, false); }

Contour ellipse(Vec2 middle, double a, double b) {
    std::vector<Vec2> points;
    for (int i = 0; i < 90; ++i)
        points.push_back(middle + Vec2(a * std::cos(i * 0.0698131700797732), b * std::sin(i * 0.0698131700797732)));
    return contour_through("ellipse", points, true);
}

double drawn_length(const SpacedLines& lines) {
    double sum = 0.0;
    for (const TactileLine& each : lines.lines())
        sum += length_of(flatten(each.path));
    return sum;
}

} // namespace

class SpacedLinesTest : public QObject {
    Q_OBJECT
private slots:
    void lines_that_are_far_apart_stay_as_they_are() {
        SpacedLines lines;
        QVERIFY(lines.lay(line(0, 0, 50, 0), 1.5) == LineFate::whole);
        QVERIFY(lines.lay(line(0, 4.5, 50, 4.5), 1.0) == LineFate::whole); // 3.25 mm between the edges
        QVERIFY(std::abs(least_gap(lines.lines()) - 3.25) < 1e-9);
    }
    void a_line_that_is_too_close_is_left_out() {
        SpacedLines lines;
        lines.lay(line(0, 0, 50, 0), 1.5);
        QVERIFY(lines.lay(line(0, 4.0, 50, 4.0), 1.0) == LineFate::left_out);
        QVERIFY(lines.lay(line(25, -20, 25, 3), 1.0) == LineFate::partly); // it crosses
        QCOMPARE(lines.lines().size(), 2u);
        QVERIFY(least_gap(lines.lines()) >= 3.0);
    }
    void both_sides_of_a_crossing_are_drawn() {
        SpacedLines lines;
        lines.lay(line(0, 0, 50, 0), 1.0);
        QVERIFY(lines.lay(line(25, -20, 25, 20), 1.0) == LineFate::partly);
        QCOMPARE(lines.lines().size(), 3u);
        QVERIFY(std::abs(drawn_length(lines) - 50.0 - 2.0 * 16.0) < 1.0);
    }
    void a_narrow_opening_is_one_line() {
        SpacedLines lines;
        QVERIFY(lines.lay(ellipse({0, 0}, 15, 1.8), 1.0) == LineFate::one_line);
        QVERIFY(!lines.lines()[0].path.closed);
        QVERIFY(std::abs(drawn_length(lines) - 30.0) < 1.0);
        QVERIFY(lines.lay(ellipse({0, 30}, 15, 5), 1.0) == LineFate::whole);
        QVERIFY(lines.lines()[1].path.closed);
    }
    void an_opening_within_another_is_drawn_where_there_is_room() {
        SpacedLines lines;
        lines.lay(ellipse({0, 0}, 30, 12), 1.0);
        QVERIFY(lines.lay(ellipse({0, 0}, 27, 4), 1.0) == LineFate::partly);
        QVERIFY(lines.lines().size() >= 2);
        QVERIFY(least_gap(lines.lines()) >= 3.0);
    }
    void where_little_of_its_sides_has_room_the_middle_is_drawn() {
        SpacedLines lines;
        lines.lay(ellipse({0, 0}, 30, 7.5), 1.0);
        QVERIFY(lines.lay(ellipse({0, 0}, 25, 3.9), 1.0) == LineFate::partly);
        QCOMPARE(lines.lines().size(), 2u);
        for (const Vec2 p : flatten(lines.lines()[1].path).points)
            QVERIFY(std::abs(p.y) < 0.1);
    }
    void what_is_too_small_is_left_out() {
        SpacedLines lines;
        QVERIFY(lines.lay(line(0, 0, 5, 0), 1.0) == LineFate::left_out);
        QVERIFY(lines.lay({"empty", {}, true}, 1.0) == LineFate::left_out);
        QVERIFY(lines.lay(contour_through("dot", {{1, 1}}, false), 1.0) == LineFate::left_out);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(lines.lay(line(0, 0, nan, 0), 1.0) == LineFate::left_out);
        QVERIFY(std::isinf(least_gap(lines.lines())));
    }
    void the_gap_holds_for_any_lines() {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> at(0.0, 100.0), size(1.0, 30.0);
        for (int i = 0; i < 60; ++i) {
            SpacedLines lines;
            for (int k = 0; k < 12; ++k) {
                const double width = k % 2 ? 1.0 : 1.5;
                if (k % 3)
                    lines.lay(ellipse({at(random), at(random)}, size(random), size(random)), width);
                else
                    lines.lay(line(at(random), at(random), at(random), at(random)), width);
            }
            QVERIFY2(least_gap(lines.lines()) >= SpacedLines::gap_mm,
                     qPrintable(QString("%1: %2").arg(i).arg(least_gap(lines.lines()))));
            for (const TactileLine& each : lines.lines())
                QVERIFY(length_of(flatten(each.path)) >= SpacedLines::shortest_mm - 0.1);
        }
    }
    void distance_to_a_rectangle() {
        SpacedLines lines;
        QVERIFY(std::isinf(lines.distance_to_lines({{0, 0}, {1, 1}})));
        lines.lay(line(0, 0, 50, 0), 1.0);
        QVERIFY(std::abs(lines.distance_to_lines({{10, 5}, {20, 9}}) - 4.5) < 1e-9);
        QCOMPARE(lines.distance_to_lines({{10, -5}, {20, 9}}), 0.0);
        QCOMPARE(lines.distance_to_lines({{-10, -5}, {60, 5}}), 0.0); // it lies within
    }
};

} // namespace spaced_lines_test

TP_TEST(spaced_lines_test, SpacedLinesTest, event_loop)
#include "spaced_lines_test.moc"
