// SPDX-License-Identifier: Apache-2.0
// Lines, rectangles, circles and ellipses become the contours they look like.
#include "drawn_sheet.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <string>

namespace drawn_shapes_test {

using namespace tp;
using namespace tp::testing;

class DrawnShapesTest : public QObject {
    Q_OBJECT

private slots:
    void line_shape() {
        const Contour contour = only("<line id='nose' x1='1' y1='2' x2='3' y2='4'/>");
        QCOMPARE(contour.name, std::string("nose"));
        QVERIFY(!contour.closed);
        compare_points(corners(contour), {{1, 2}, {3, 4}});
        compare_points(corners(only("<line x2='5'/>")), {{0, 0}, {5, 0}});
    }

    void polyline_and_polygon() {
        const Contour open = only("<polyline points='0,0 5,5-1.5.5'/>");
        QVERIFY(!open.closed);
        compare_points(corners(open), {{0, 0}, {5, 5}, {-1.5, 0.5}});
        const Contour closed = only("<polygon points=' 0 0,5 5 , 9 0 '/>");
        QVERIFY(closed.closed);
        compare_points(corners(closed), {{0, 0}, {5, 5}, {9, 0}, {0, 0}});
        QVERIFY(drawn("<polyline/><polygon points=''/><polyline points='3 3'/>").empty());
    }

    void broken_points_data() {
        QTest::addColumn<QByteArray>("points");
        for (const char* points :
             {"0 0 5", "0 0 x 5", "0,0,,5 5", "0 0 . 5", "0 0 +-5 5", "0 0 -+5 5", "0 0 - 5", "0 0 +",
              "0 0 5 5,", "0 0 nan 5", "0 0 1e400 5", "0 0 C 1 2 3 4 5 6"})
            QTest::newRow(points) << QByteArray(points);
    }
    void broken_points() {
        QFETCH(QByteArray, points);
        expect_refusal(on_sheet("<polygon id='brow' points='" + points.toStdString() + "'/>"), "brow");
    }

    void rectangle() {
        const Contour contour = only("<rect x='10' y='20' width='30' height='40'/>");
        QVERIFY(contour.closed);
        compare_points(corners(contour), {{10, 20}, {40, 20}, {40, 60}, {10, 60}, {10, 20}});
    }

    void rounded_rectangle() {
        // Every point is `r` away from the inner rectangle, however the corner is cut.
        const auto check = [](const std::string& attributes, double r) {
            const Contour contour = only("<rect x='10' y='20' width='30' height='40' " + attributes + "/>");
            QVERIFY(contour.closed);
            for (const Vec2 p : sampled(contour)) {
                const Vec2 inner = glm::clamp(p, Vec2(10 + r, 20 + r), Vec2(40 - r, 60 - r));
                QVERIFY(std::abs(length(p - inner) - r) < arc_tolerance);
            }
            QVERIFY(std::abs(arc_length(contour) - (2 * (70 - 4 * r) + 2 * pi * r)) < 1e-4);
        };
        check("rx='5'", 5);
        check("ry='5'", 5);
        check("rx='5' ry='auto'", 5);
        check("rx='15' ry='15'", 15);
        check("rx='5' ry='-1'", 5);
        // Radii are cut at half the sides: here an ellipse.
        const Contour ellipse = only("<rect x='10' y='20' width='30' height='40' rx='99' ry='99'/>");
        QVERIFY(off_ellipse(ellipse, {25, 40}, {15, 20}) < arc_tolerance);
        // One radius zero: square corners.
        QCOMPARE(only("<rect width='30' height='40' rx='5' ry='0'/>").pieces.size(), std::size_t{4});
    }

    void circle_and_ellipse() {
        const Contour circle = only("<circle cx='50' cy='40' r='30'/>");
        QVERIFY(circle.closed);
        QVERIFY(near(start_of(circle.pieces[0]), {80, 40}));
        QVERIFY(off_ellipse(circle, {50, 40}, {30, 30}) < arc_tolerance);
        QVERIFY(std::abs(arc_length(circle) - 60 * pi) < 1e-4);
        const auto truth = [](double t) {
            return Vec2(50 + 30 * std::cos(2 * pi * t), 40 + 20 * std::sin(2 * pi * t));
        };
        const Contour ellipse = only("<ellipse cx='50' cy='40' rx='30' ry='20'/>");
        QVERIFY(ellipse.closed);
        QVERIFY(off_ellipse(ellipse, {50, 40}, {30, 20}) < arc_tolerance);
        QVERIFY(deviation(ellipse, truth) < arc_tolerance);
        QVERIFY(off_ellipse(only("<ellipse cx='50' cy='40' rx='20' ry='auto'/>"), {50, 40}, {20, 20}) <
                arc_tolerance);
    }

    void shapes_turn_with_their_group() {
        const Contour contour =
            only("<g transform='translate(50 50) rotate(30)'><ellipse rx='30' ry='20'/></g>");
        QVERIFY(off_ellipse(contour, {50, 50}, {30, 20}, pi / 6) < arc_tolerance);
    }

    void lengths_with_units_on_shapes() {
        // No viewBox: 10 mm are 10 mm. With one: SVG's 96 user units an inch.
        compare_points(corners(only("<line x2='10mm' y2='1cm'/>")), {{0, 0}, {10, 10}});
        const ContourSheet sheet =
            read("<svg width='100mm' height='100mm' viewBox='0 0 96 96'><line x2='1in' y2='50%'/></svg>");
        compare_points(corners(sheet.contours.at(0)), {{0, 0}, {100, 50}});
        QVERIFY(off_ellipse(only("<circle cx='50%' cy='50%' r='10%'/>"), {50, 50}, {10, 10}) < arc_tolerance);
    }

    void shapes_without_extent_draw_nothing() {
        QVERIFY(
            drawn("<circle/><circle r='0'/><circle r='-5'/><ellipse rx='5' ry='0'/><rect/><rect width='5'/>"
                  "<rect width='-5' height='5'/>")
                .empty());
    }

    void shapes_that_cannot_be_read() {
        expect_refusal(on_sheet("<circle id='iris' r='5em'/>"), "iris");
        expect_refusal(on_sheet("<circle id='iris' r='big'/>"), "iris");
        expect_refusal(on_sheet("<rect id='frame' width='1e400' height='5'/>"), "frame");
        expect_refusal(on_sheet("<line id='nose' x1='nan'/>"), "nose");
        expect_refusal(on_sheet("<circle id='iris' cx='1e308' r='1e308'/>"), "iris");
    }
};

} // namespace drawn_shapes_test

TP_TEST(drawn_shapes_test, DrawnShapesTest, event_loop)
#include "drawn_shapes_test.moc"
