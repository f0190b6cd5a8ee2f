// SPDX-License-Identifier: Apache-2.0
// What is drawn lies where it looks: units, viewBox, transforms.
#include "drawn_sheet.hpp"
#include "test_program.hpp"

#include <QTest>

#include <clocale>
#include <cmath>
#include <string>

namespace drawing_test {

using namespace tp;
using namespace tp::testing;

class DrawingTest : public QObject {
    Q_OBJECT

private slots:
    void size_data() {
        QTest::addColumn<QByteArray>("attributes");
        QTest::addColumn<bool>("in_pixels");
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("height");
        const auto row = [](const char* name, const char* attributes, bool pixels, double width,
                            double height) {
            QTest::newRow(name) << QByteArray(attributes) << pixels << width << height;
        };
        row("mm", "width='210mm' height='297mm'", false, 210, 297);
        row("cm_and_in", "width='21cm' height='2in'", false, 210, 50.8);
        row("pt_and_pc", "width='72pt' height='6pc'", false, 25.4, 25.4);
        row("quarters_and_capitals", "width='40Q' height='10MM'", false, 10, 10);
        row("bare_is_mm", "width='210' height='29.7e1'", false, 210, 297);
        row("px_is_mm", "width='210px' height=' 297px '", false, 210, 297);
        row("bare_is_px", "width='640' height='480px'", true, 640, 480);
        row("mm_in_px", "width='25.4mm' height='1in'", true, 96, 96);
        row("view_box_alone", "viewBox='-5 -5 30 40'", false, 30, 40);
        row("percent_is_view_box", "width='100%' height='100%' viewBox='0,0,30,40'", false, 30, 40);
        row("auto_is_view_box", "width='auto' viewBox='0 0 30 40'", false, 30, 40);
        row("width_and_view_box", "width='60mm' viewBox='0 0 30 40'", false, 60, 80);
        row("height_and_view_box", "height='60mm' viewBox='0 0 30 40'", false, 45, 60);
        row("plus_sign_and_comma", "width='+6' height='.8e1' viewBox='0,0 , 3 4'", false, 6, 8);
    }
    void size() {
        QFETCH(QByteArray, attributes);
        QFETCH(bool, in_pixels);
        QFETCH(double, width);
        QFETCH(double, height);
        const ContourSheet sheet =
            read("<svg " + attributes.toStdString() + "/>", in_pixels ? Unit::pixel : Unit::millimetre);
        QVERIFY(std::abs(sheet.width - width) < 1e-9);
        QVERIFY(std::abs(sheet.height - height) < 1e-9);
        QVERIFY(sheet.contours.empty());
        QVERIFY(sheet.unit == (in_pixels ? Unit::pixel : Unit::millimetre));
    }

    void numbers_are_read_alike_in_every_locale() {
        const std::string before = std::setlocale(LC_ALL, nullptr);
        for (const char* locale : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "C"})
            if (std::setlocale(LC_ALL, locale) != nullptr)
                break;
        const Contour contour = path("M1.5,2.5 L 3.25 4");
        const double width = read("<svg width='12.5mm' height='1'/>").width;
        std::setlocale(LC_ALL, before.c_str());
        compare_points(corners(contour), {{1.5, 2.5}, {3.25, 4}});
        QCOMPARE(width, 12.5);
    }

    // viewBox

    void view_box_data() {
        QTest::addColumn<QByteArray>("attributes");
        QTest::addColumn<double>("x0");
        QTest::addColumn<double>("y0");
        QTest::addColumn<double>("x1");
        QTest::addColumn<double>("y1");
        const auto row = [](const char* name, const char* attributes, double x0, double y0, double x1,
                            double y1) {
            QTest::newRow(name) << QByteArray(attributes) << x0 << y0 << x1 << y1;
        };
        // Where the corners (10, 20) and (20, 40) of the box land on a sheet of 200 × 100.
        row("same_shape", "viewBox='10 20 40 20'", 0, 0, 50, 100);
        row("centred_by_default", "viewBox='10 20 10 20'", 75, 0, 125, 100);
        row("meet_named", "viewBox='10 20 10 20' preserveAspectRatio='xMidYMid meet'", 75, 0, 125, 100);
        row("left", "viewBox='10 20 10 20' preserveAspectRatio='xMinYMid'", 0, 0, 50, 100);
        row("right", "viewBox='10 20 10 20' preserveAspectRatio='xMaxYMin meet'", 150, 0, 200, 100);
        row("none", "viewBox='10 20 10 20' preserveAspectRatio='none'", 0, 0, 200, 100);
        row("slice_centred", "viewBox='10 20 10 20' preserveAspectRatio='xMidYMid slice'", 0, -150, 200, 250);
        row("slice_top", "viewBox='10 20 10 20' preserveAspectRatio='xMinYMin slice'", 0, 0, 200, 400);
        row("slice_bottom", "viewBox='10 20 10 20' preserveAspectRatio='xMinYMax slice'", 0, -300, 200, 100);
        row("unknown_word", "viewBox='10 20 10 20' preserveAspectRatio='whatever'", 75, 0, 125, 100);
    }
    void view_box() {
        QFETCH(QByteArray, attributes);
        QFETCH(double, x0);
        QFETCH(double, y0);
        QFETCH(double, x1);
        QFETCH(double, y1);
        const ContourSheet sheet = read("<svg width='200mm' height='100mm' " + attributes.toStdString() +
                                        "><path d='M10 20 L20 40'/></svg>");
        compare_points(corners(sheet.contours.at(0)), {{x0, y0}, {x1, y1}});
    }

    void drawing_of_an_inkscape_page() {
        const ContourSheet sheet =
            read("<svg width='210mm' height='297mm' viewBox='0 0 793.7007874 1122.519685'>"
                 "<path id='a' d='m 0,0 377.9527559,377.9527559'/></svg>");
        compare_points(corners(sheet.contours.at(0)), {{0, 0}, {100, 100}}, 1e-6);
    }

    // Transforms

    void transform_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        const auto row = [](const char* text, double x, double y) {
            QTest::newRow(text) << QByteArray(text) << x << y;
        };
        // Where (3, 4) lands.
        const double root = std::sqrt(0.5);
        row("", 3, 4);
        row("none", 3, 4);
        row("translate(10)", 13, 4);
        row("translate(10 20)", 13, 24);
        row(" translate ( 10 , 20 ) ", 13, 24);
        row("translate(10-20)", 13, -16);
        row("translate(1e1.5)", 13, 4.5);
        row("scale(2)", 6, 8);
        row("scale(2,-3)", 6, -12);
        row("rotate(90)", -4, 3);
        row("rotate(-450)", 4, -3);
        row("rotate(45)", -root, 7 * root);
        row("rotate(180,10,20)", 17, 36);
        row("skewX(45)", 7, 4);
        row("skewY(45)", 3, 7);
        row("matrix(1 2 3 4 5 6)", 1 * 3 + 3 * 4 + 5, 2 * 3 + 4 * 4 + 6);
        row("translate(10,20) scale(2)", 16, 28);
        row("scale(2),translate(10,20)", 26, 48);
        row("rotate(90)translate(1)scale(2)", -8, 7);
    }
    void transform() {
        QFETCH(QByteArray, text);
        QFETCH(double, x);
        QFETCH(double, y);
        const std::string attribute = " transform=\"" + text.toStdString() + "\"";
        const Vec2 expected(x, y);
        QVERIFY(near(end_of(only("<path d=\"M0 0L3 4\"" + attribute + "/>").pieces.at(0)), expected));
        QVERIFY(near(end_of(only("<g" + attribute + "><path d=\"M0 0L3 4\"/></g>").pieces.at(0)), expected));
    }

    void transforms_that_cannot_be_read_data() {
        QTest::addColumn<QByteArray>("text");
        for (const char* text : {"rotate",
                                 "rotate(",
                                 "rotate)",
                                 "rotate(1 2)",
                                 "turn(5)",
                                 "translate(1,,2)",
                                 "translate(1,)",
                                 "scale()",
                                 "scale(1 2 3)",
                                 "translate()",
                                 "translate(1 2 3)",
                                 "rotate(1 2 3 4)",
                                 "skewX()",
                                 "skewX(1 2)",
                                 "skewY(1 2)",
                                 "matrix(1 2 3 4 5)",
                                 "matrix(1 2 3 4 5 6 7)",
                                 "translate(nan)",
                                 "translate(inf 0)",
                                 "translate(1e400)",
                                 "translate(10px)",
                                 "5",
                                 "scale(2) rotate",
                                 "rotate(45",
                                 "scale(2) rotate(45",
                                 "1)rotate(45)",
                                 "matrix(1e400 0 0 1 0 0)",
                                 "matrix(1 0 0 1e400 0 0)",
                                 "matrix(1 0 0 1 0 1e400)",
                                 "scale(1e300) scale(1e300)"})
            QTest::newRow(text) << QByteArray(text);
    }
    void transforms_that_cannot_be_read() {
        QFETCH(QByteArray, text);
        expect_refusal(on_sheet("<g id=\"face\" transform=\"" + text.toStdString() + "\"/>"), "face");
    }

    void nested_groups_compose_and_end() {
        const auto contours = drawn("<g transform='translate(10,0)'><g transform='scale(2)'>"
                                    "<path id='in' transform='rotate(90)' d='M0 0L1 0'/></g>"
                                    "<path id='middle' d='M0 0L1 0'/></g><path id='out' d='M0 0L1 0'/>");
        QCOMPARE(contours.size(), std::size_t{3});
        compare_points(corners(contours[0]), {{10, 0}, {10, 2}});
        compare_points(corners(contours[1]), {{10, 0}, {11, 0}});
        compare_points(corners(contours[2]), {{0, 0}, {1, 0}});
    }

    /// A drawing within a drawing measures by its own sides.
    void svg_in_svg_measures_by_itself() {
        const auto inner = [](const char* attributes, const char* line) {
            return drawn("<svg " + std::string(attributes) + ">" + line + "</svg>");
        };
        compare_points(corners(inner("width='50' height='20'", "<line x2='50%' y2='50%'/>").at(0)),
                       {{0, 0}, {25, 10}});
        compare_points(corners(inner("viewBox='0 0 10 10'", "<line x2='1' y2='50%'/>").at(0)),
                       {{0, 0}, {10, 50}});
        compare_points(
            corners(inner("width='96' height='48' viewBox='0 0 96 48'", "<line x2='1in' y2='.5in'/>").at(0)),
            {{0, 0}, {96, 48}});
        compare_points(corners(inner("width='90' height='10' viewBox='0 0 1 1' preserveAspectRatio='none'",
                                     "<line x2='1' y2='1'/>")
                                   .at(0)),
                       {{0, 0}, {90, 10}});
        compare_points(corners(inner("x='wide' y='10%'", "<line x2='1' y2='1'/>").at(0)), {{0, 10}, {1, 11}});
        for (const char* nothing : {"height='0'", "width='-1'", "viewBox='0 0 0 1'", "viewBox='1 2 3'"})
            QVERIFY2(inner(nothing, "<path d='M0 0L1 1'/>").empty(), nothing);
    }

    void svg_in_svg() {
        const auto contours = drawn(
            "<svg x='10' y='20' width='50%' height='25' viewBox='0 0 10 10'><path d='M0 0L10 10'/></svg>"
            "<svg width='0'><path d='M0 0L1 1'/></svg><svg x='5'><path d='M0 0L1 1'/></svg>");
        QCOMPARE(contours.size(), std::size_t{2});
        compare_points(corners(contours[0]), {{22.5, 20}, {47.5, 45}});
        compare_points(corners(contours[1]), {{5, 0}, {6, 1}});
    }
};

} // namespace drawing_test

TP_TEST(drawing_test, DrawingTest, event_loop)
#include "drawing_test.moc"
