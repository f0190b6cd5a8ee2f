// SPDX-License-Identifier: Apache-2.0
// What is drawn becomes the contours it looks like: units, viewBox, transforms, shapes, path commands, arcs.
#include "core/geometry/flatten.hpp"
#include "core/svg/contour_sheet.hpp"

#include <QTest>

#include <clocale>
#include <cmath>
#include <functional>
#include <numbers>

using namespace tp;

namespace {

using Unit = ContourSheet::Unit;
constexpr double pi = std::numbers::pi;
constexpr double arc_tolerance = 1e-6; ///< the contract's, in units of the sheet

/// `body` on a sheet of 100 × 100 units, one user unit each.
std::string on_sheet(const std::string& body) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"100\">" + body + "</svg>";
}

ContourSheet read(const std::string& text, Unit unit = Unit::millimetre) {
    const auto sheet = sheet_from_svg(text, unit);
    if (!sheet) {
        QTest::qFail(sheet.error().c_str(), __FILE__, __LINE__);
        return {};
    }
    return *sheet;
}

std::vector<Contour> drawn(const std::string& body) { return read(on_sheet(body)).contours; }

Contour only(const std::string& body) {
    auto contours = drawn(body);
    if (contours.size() != 1) {
        QTest::qFail(("contours: " + std::to_string(contours.size())).c_str(), __FILE__, __LINE__);
        return {};
    }
    return contours.front();
}

Contour path(const std::string& data) { return only("<path d=\"" + data + "\"/>"); }

std::vector<Vec2> sampled(const Contour& contour, int a_piece = 200) {
    std::vector<Vec2> points;
    for (const Piece& piece : contour.pieces)
        for (int i = 0; i <= a_piece; ++i)
            points.push_back(point_at(piece, static_cast<double>(i) / a_piece));
    return points;
}

/// Largest distance of the curve t ↦ truth(t), 0 ≤ t ≤ 1, from the contour.
double deviation(const Contour& contour, const std::function<Vec2(double)>& truth) {
    FlattenTolerance fine;
    fine.chord = 1e-7;
    fine.facet_degrees = 1.0;
    const Polyline line = flatten(contour, fine);
    double worst = 0.0;
    for (int i = 0; i <= 60; ++i)
        worst = std::max(worst, distance_to(line, truth(i / 60.0)));
    return worst;
}

/// Largest distance of the contour's points from the ellipse about `centre`, of radii `r`, turned by `angle`;
/// by one step of Newton's, good where they are close.
double off_ellipse(const Contour& contour, Vec2 centre, Vec2 r, double angle = 0.0) {
    double worst = 0.0;
    for (const Vec2 p : sampled(contour)) {
        const Vec2 d = p - centre;
        const Vec2 q(std::cos(angle) * d.x + std::sin(angle) * d.y,
                     -std::sin(angle) * d.x + std::cos(angle) * d.y);
        const double f = q.x * q.x / (r.x * r.x) + q.y * q.y / (r.y * r.y) - 1.0;
        const Vec2 slope(2.0 * q.x / (r.x * r.x), 2.0 * q.y / (r.y * r.y));
        worst = std::max(worst, std::abs(f) / length(slope));
    }
    return worst;
}

double arc_length(const Contour& contour) {
    FlattenTolerance fine;
    fine.chord = 1e-7;
    fine.facet_degrees = 0.1;
    return length_of(flatten(contour, fine));
}

bool near(Vec2 a, Vec2 b, double tolerance = 1e-9) { return length(a - b) <= tolerance; }

/// The end points of every piece, the start first.
std::vector<Vec2> corners(const Contour& contour) {
    std::vector<Vec2> points{start_of(contour.pieces.front())};
    for (const Piece& piece : contour.pieces)
        points.push_back(end_of(piece));
    return points;
}

void compare_points(const std::vector<Vec2>& actual, const std::vector<Vec2>& expected,
                    double tolerance = 1e-9) {
    QCOMPARE(actual.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        QVERIFY2(near(actual[i], expected[i], tolerance),
                 qPrintable(QString("point %1: %2, %3 where %4, %5 is expected")
                                .arg(i)
                                .arg(actual[i].x, 0, 'g', 17)
                                .arg(actual[i].y, 0, 'g', 17)
                                .arg(expected[i].x, 0, 'g', 17)
                                .arg(expected[i].y, 0, 'g', 17)));
}

void expect_refusal(const std::string& text, const std::string& word) {
    const auto sheet = sheet_from_svg(text);
    QVERIFY2(!sheet.ok(), "was read");
    const std::string sentence = sheet.error();
    QVERIFY2(sentence.find(word) != std::string::npos, sentence.c_str());
    QVERIFY2(sentence.size() > 20 && sentence.ends_with('.') && sentence.find('\n') == std::string::npos,
             sentence.c_str());
}

} // namespace

class DrawingTest : public QObject {
    Q_OBJECT

private slots:
    // Size

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

    // Path commands

    void commands_data() {
        QTest::addColumn<QByteArray>("shorthand");
        QTest::addColumn<QByteArray>("spelt_out");
        const auto row = [](const char* name, const char* shorthand, const char* spelt_out) {
            QTest::newRow(name) << QByteArray(shorthand) << QByteArray(spelt_out);
        };
        row("relative_lines", "m10 10 5 0 l0 5 -5,0", "M10 10 L15 10 L15 15 L10 15");
        row("horizontal_and_vertical", "M10 10H15V20h-5v-5 1", "M10 10 L15 10 L15 20 L10 20 L10 15 L10 16");
        row("implicit_lines", "M1 1 2 2 3 1", "M1 1L2 2L3 1");
        row("smooth_cubic", "M0 0C1 2 3 4 5 6S9 8 9 9", "M0 0C1 2 3 4 5 6C7 8 9 8 9 9");
        row("smooth_cubic_relative", "M0 0c1 2 3 4 5 6s4 2 4 3", "M0 0C1 2 3 4 5 6C7 8 9 8 9 9");
        row("smooth_cubic_after_line", "M0 0L5 6S9 8 9 9", "M0 0L5 6C5 6 9 8 9 9");
        row("smooth_quadratic", "M0 0Q1 2 3 3T6 6t3 3", "M0 0Q1 2 3 3Q5 4 6 6Q7 8 9 9");
        row("smooth_quadratic_after_line", "M0 0L5 6T9 9", "M0 0L5 6Q5 6 9 9");
        row("relative_quadratic", "M1 1q1 2 3 3", "M1 1Q2 3 4 4");
        row("numbers_run_together", "M1.5.5-.5-1e0.25 3", "M1.5 0.5L-0.5 -1L.25 3");
        row("closed", "M0 0 5 0 5 5z", "M0 0L5 0L5 5L0 0Z");
        row("white_space_and_commas", "\n M 0,0\t,5 ,5 ", "M0 0L5 5");
    }
    void commands() {
        QFETCH(QByteArray, shorthand);
        QFETCH(QByteArray, spelt_out);
        const Contour a = path(shorthand.toStdString());
        const Contour b = path(spelt_out.toStdString());
        QCOMPARE(a.closed, b.closed);
        QCOMPARE(a.pieces.size(), b.pieces.size());
        for (std::size_t i = 0; i < a.pieces.size(); ++i) {
            QCOMPARE(a.pieces[i].index(), b.pieces[i].index());
            for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
                QVERIFY(near(point_at(a.pieces[i], t), point_at(b.pieces[i], t)));
        }
    }

    void pieces_keep_their_kind() {
        const Contour contour = path("M0 0L1 1Q2 2 3 1C4 4 5 5 6 1");
        QVERIFY(std::holds_alternative<Line>(contour.pieces[0]));
        QVERIFY(std::holds_alternative<Quadratic>(contour.pieces[1]));
        QVERIFY(std::holds_alternative<Cubic>(contour.pieces[2]));
    }

    void closed_only_where_it_says_so() {
        QVERIFY(path("M0 0L5 0L5 5L0 0Z").closed);
        QCOMPARE(path("M0 0L5 0L5 5L0 0Z").pieces.size(), std::size_t{3});
        QCOMPARE(path("M0 0L5 0L5 5Z").pieces.size(), std::size_t{3});
        QVERIFY(!path("M0 0L5 0L5 5L0 0").closed);
        QVERIFY(!path("M0 0L5 0L5 5L1e-10 0").closed);
    }

    void ends_that_almost_meet_are_joined() {
        for (const char* data : {"M0 0L5 0L5 5L1e-10 1e-10Z", "m0 0l5 0 0 5 -5 -4.9999999999z"}) {
            const Contour contour = path(data);
            QVERIFY(contour.closed);
            QCOMPARE(contour.pieces.size(), std::size_t{3});
            QVERIFY(end_of(contour.pieces.back()) == start_of(contour.pieces.front()));
        }
        QCOMPARE(path("M0 0L5 0L5 5L.8e-9 0Z").pieces.size(), std::size_t{3});
        QCOMPARE(path("M0 0L5 0L5 5L1.2e-9 0Z").pieces.size(), std::size_t{4});
        QCOMPARE(path("M0 0L5 0L5 5L1e-8 0Z").pieces.size(), std::size_t{4});
    }

    void subpaths_become_contours() {
        const auto contours = drawn("<path id='lips' d='M0 0L5 0L5 5ZM1 1L2 1L2 2zl3 3m1 1 1 0'/>");
        QCOMPARE(contours.size(), std::size_t{4});
        QCOMPARE(contours[0].name, std::string("lips"));
        QCOMPARE(contours[1].name, std::string("lips 2"));
        QVERIFY(contours[0].closed && contours[1].closed && !contours[2].closed && !contours[3].closed);
        compare_points(corners(contours[2]), {{1, 1}, {4, 4}}); // goes on where the closed one started
        compare_points(corners(contours[3]), {{5, 5}, {6, 5}});
    }

    void paths_that_draw_nothing() {
        QVERIFY(drawn("<path/><path d=''/><path d='  '/><path d='M5 5'/><path d='M1 1M2 2m3 3'/>").empty());
        const Contour dot = path("M5 6z"); // a dot, as drawing programs show it
        QVERIFY(dot.closed);
        compare_points(corners(dot), {{5, 6}, {5, 6}});
    }

    void broken_path_data_data() {
        QTest::addColumn<QByteArray>("data");
        for (const char* data :
             {"L5 5", "5 5", "M", "M5", "M0 0 L", "M0 0 L5", "M0 0 X5 5", "M0 0 C1 2 3 4 5", "M nan 0 L1 1",
              "M0 0 L inf 1", "M0 0 A5 5 0 2 0 9 9", "M0 0 L1 1 garbage", "M0 0 L1,,1", "M0 0 L1e400 1",
              "M0 0 L1 -1e999", "M1e308 0 l1e308 0", "M0 0 A1e400 5 0 0 1 9 9"})
            QTest::newRow(data) << QByteArray(data);
    }
    void broken_path_data() {
        QFETCH(QByteArray, data);
        expect_refusal(on_sheet("<path id=\"left eye\" d=\"" + data.toStdString() + "\"/>"), "left eye");
    }

    // Arcs

    void arcs_data() {
        QTest::addColumn<double>("rx");
        QTest::addColumn<double>("ry");
        QTest::addColumn<double>("degrees");
        QTest::newRow("circle") << 20.0 << 20.0 << 0.0;
        QTest::newRow("ellipse") << 30.0 << 10.0 << 0.0;
        QTest::newRow("turned_ellipse") << 30.0 << 10.0 << 33.0;
        QTest::newRow("needle") << 40.0 << 0.01 << 70.0;
        QTest::newRow("wall") << 1e5 << 1e5 << 0.0;
        QTest::newRow("grain") << 1e-4 << 1e-4 << 0.0;
    }
    /// Each of the four arcs between two points of an ellipse, against the ellipse itself.
    void arcs() {
        QFETCH(double, rx);
        QFETCH(double, ry);
        QFETCH(double, degrees);
        const double turn = degrees * pi / 180.0;
        const auto on_ellipse = [&](double angle) {
            const Vec2 p(rx * std::cos(angle), ry * std::sin(angle));
            return Vec2(std::cos(turn) * p.x - std::sin(turn) * p.y,
                        std::sin(turn) * p.x + std::cos(turn) * p.y);
        };
        for (const double extent : {0.5, 2.0, 3.0, 3.3, 5.0, 6.2})
            for (const bool clockwise : {true, false}) {
                const double start = 0.7;
                const double sweep = clockwise ? extent : -extent;
                const Vec2 a = on_ellipse(start);
                const Vec2 b = on_ellipse(start + sweep);
                const QString data = QString("M%1 %2A%3 %4 %5 %6 %7 %8 %9")
                                         .arg(a.x, 0, 'g', 17)
                                         .arg(a.y, 0, 'g', 17)
                                         .arg(rx, 0, 'g', 17)
                                         .arg(ry, 0, 'g', 17)
                                         .arg(degrees, 0, 'g', 17)
                                         .arg(extent > pi ? 1 : 0)
                                         .arg(clockwise ? 1 : 0)
                                         .arg(b.x, 0, 'g', 17)
                                         .arg(b.y, 0, 'g', 17);
                const Contour contour = path(data.toStdString());
                QVERIFY(start_of(contour.pieces.front()) == a);
                QVERIFY(end_of(contour.pieces.back()) == b);
                for (const Piece& piece : contour.pieces)
                    QVERIFY(std::holds_alternative<Cubic>(piece));
                if (ry > 0.1) // the measure of `off_ellipse` is of first order
                    QVERIFY(off_ellipse(contour, {0, 0}, {rx, ry}, turn) < arc_tolerance);
                if (rx < 1000) // beyond, the reference would need millions of segments
                    QVERIFY(deviation(contour, [&](double t) { return on_ellipse(start + t * sweep); }) <
                            arc_tolerance);
            }
    }

    void arcs_keep_their_tolerance_when_enlarged() {
        const Contour contour = only("<g transform='scale(1e4)'><path d='M-.01 0A.01 .01 0 0 1 .01 0'/></g>");
        QVERIFY(off_ellipse(contour, {0, 0}, {100, 100}) < arc_tolerance);
    }

    /// Each piece of a curve is searched a thousand times a second: as few as keep within the tolerance,
    /// however the circle got its size.
    void a_circle_is_no_more_pieces_than_it_needs_data() {
        QTest::addColumn<QByteArray>("drawing");
        QTest::addColumn<int>("pieces");
        const auto row = [](const char* name, const char* drawing, int pieces) {
            QTest::newRow(name) << QByteArray(drawing) << pieces;
        };
        row("grain", "<circle r='.0017'/>", 4);
        row("larger_grain", "<circle r='.0019'/>", 8);
        row("eye", "<circle r='40'/>", 24);
        row("face", "<circle r='60'/>", 24);
        row("half_of_one", "<path d='M-40 0A40 40 0 0 1 40 0'/>", 11);
        row("planet", "<circle r='1e12'/>", 324); // beyond, rounding hides the difference
        row("enlarged", "<g transform='scale(100)'><circle r='.4'/></g>", 24);
        row("made_smaller", "<g transform='scale(.01)'><circle r='4000'/></g>", 24);
        row("turned_and_pressed", "<g transform='rotate(30) scale(1 .1)'><circle r='40'/></g>", 24);
        row("pressed_and_turned", "<g transform='scale(.1 1) rotate(60)'><circle r='40'/></g>", 24);
        row("mirrored", "<g transform='scale(-1 1) rotate(20)'><circle r='40'/></g>", 24);
        row("made_a_line", "<g transform='scale(0 0)'><circle r='40'/></g>", 24);
    }
    void a_circle_is_no_more_pieces_than_it_needs() {
        QFETCH(QByteArray, drawing);
        QFETCH(int, pieces);
        QCOMPARE(static_cast<int>(only(drawing.toStdString()).pieces.size()), pieces);
    }

    /// Where nobody could tell it from an arc, and only there.
    void an_arc_that_is_flat_is_a_line_data() {
        QTest::addColumn<QByteArray>("data");
        QTest::addColumn<bool>("flat");
        const auto row = [](const char* data, bool flat) { QTest::newRow(data) << QByteArray(data) << flat; };
        row("M0 0A6e5 6e5 0 0 1 1 0", true);
        row("M0 0A6e5 6e5 0 0 0 1 0", true);
        row("M0 0A4e5 4e5 0 0 1 1 0", false);
        row("M0 0A6e5 6e5 0 1 1 1 0", false); // the long way round
        row("M0 0A1e-6 1e-6 0 0 1 .8e-7 0", true);
        row("M0 0A1e-6 1e-6 0 0 1 1.2e-7 0", false);
    }
    void an_arc_that_is_flat_is_a_line() {
        QFETCH(QByteArray, data);
        QFETCH(bool, flat);
        const Contour contour = path(data.toStdString());
        QCOMPARE(contour.pieces.size() == 1 && std::holds_alternative<Line>(contour.pieces[0]), flat);
    }

    void radius_too_small_grows_until_it_fits() {
        const Contour contour = path("M10 0A1 1 0 0 1 30 0");
        QVERIFY(off_ellipse(contour, {20, 0}, {10, 10}) < arc_tolerance);
        QVERIFY(std::abs(arc_length(contour) - 10 * pi) < 1e-5);
    }

    void radius_zero_is_a_straight_line() {
        const Contour contour = path("M0 0A0 5 0 0 1 8 8");
        QCOMPARE(contour.pieces.size(), std::size_t{1});
        QVERIFY(std::holds_alternative<Line>(contour.pieces[0]));
    }

    void radius_negative_counts_as_positive() {
        QVERIFY(off_ellipse(path("M10 0A-10 -10 0 0 1 30 0"), {20, 0}, {10, 10}) < arc_tolerance);
    }

    void radius_1e15_is_a_straight_line() {
        for (const char* data :
             {"M0 0A1e15 1e15 0 0 1 9 9", "M0 0A1e15 1e15 0 0 0 9 9", "M0 0A1e300 1e300 0 0 0 9 9"}) {
            const Contour contour = path(data);
            for (const Vec2 p : sampled(contour))
                QVERIFY2(std::abs(p.x - p.y) < 1e-6 && p.x > -1e-6 && p.x < 9.000001, data);
        }
    }

    void arc_to_where_the_pen_is_draws_nothing() {
        QCOMPARE(path("M0 0L5 5A3 3 0 1 1 5 5L9 0").pieces.size(), std::size_t{2});
    }

    void arc_flags_may_run_together() {
        compare_points(corners(path("M0 0a5 5 0 0110 0")), corners(path("M0 0A5 5 0 0 1 10 0")));
    }

    // Shapes

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

    // What is drawn and what is not

    void left_out() {
        const auto contours =
            drawn("<defs><path d='M0 0L1 1'/></defs><symbol><path d='M0 0L1 1'/></symbol><clipPath><path "
                  "d='M0 0L1 1'/>"
                  "</clipPath><mask><g><path d='M0 0L1 1'/></g></mask><marker><path d='M0 0L1 "
                  "1'/></marker><pattern>"
                  "<path d='M0 0L1 1'/></pattern><text>M0 0</text><foreignObject><path d='M0 0L1 "
                  "1'/></foreignObject>"
                  "<use href='#seen'/><image href='a.png'/><x:path xmlns:x='urn:x' d='M0 0L1 1'/>"
                  "<!-- <path d='M0 0L1 1'/> --><path id='seen' d='M0 0L1 1'/>");
        QCOMPARE(contours.size(), std::size_t{1});
        QCOMPARE(contours[0].name, std::string("seen"));
    }

    void broken_elements_that_are_not_drawn_do_no_harm() {
        QVERIFY(drawn("<defs><path d='nonsense'/></defs><g display='none'><path d='nonsense'/></g>").empty());
    }

    void display_none_data() {
        QTest::addColumn<QByteArray>("attributes");
        QTest::addColumn<bool>("seen");
        QTest::newRow("attribute") << QByteArray("display='none'") << false;
        QTest::newRow("style") << QByteArray("style='fill:red;display:none'") << false;
        QTest::newRow("style_with_spaces")
            << QByteArray("style=' Display : NONE !important ; fill:red'") << false;
        QTest::newRow("style_beats_attribute") << QByteArray("display='none' style='display:inline'") << true;
        QTest::newRow("last_declaration_holds") << QByteArray("style='display:none;display:block'") << true;
        QTest::newRow("other_property") << QByteArray("style='-x-display:none;note:display'") << true;
        QTest::newRow("inline") << QByteArray("display='inline'") << true;
    }
    void display_none() {
        QFETCH(QByteArray, attributes);
        QFETCH(bool, seen);
        const std::string text = attributes.toStdString();
        const std::size_t expected = seen ? 1 : 0;
        QCOMPARE(drawn("<path d='M0 0L1 1' " + text + "/>").size(), expected);
        QCOMPARE(drawn("<g " + text + "><path d='M0 0L1 1'/></g>").size(), expected);
        QCOMPARE(read("<svg width='9' height='9' " + text + "><path d='M0 0L1 1'/></svg>").contours.size(),
                 expected);
    }

    void names() {
        const auto contours =
            drawn("<path d='M0 0L1 1'/><path id='left eye' d='M0 0L1 1'/><path id='contour 1' d='M0 0L1 1'/>"
                  "<path id='left eye' d='M0 0L1 1'/><path id=' ' d='M0 0L1 1'/>");
        const std::vector<std::string> expected = {"contour 2", "left eye", "contour 1", "left eye 2",
                                                   "contour 3"};
        QCOMPARE(contours.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i)
            QCOMPARE(contours[i].name, expected[i]);
    }

    void elements_with_a_prefix() {
        const ContourSheet sheet =
            read("<?xml version='1.0'?><s:svg xmlns:s='http://www.w3.org/2000/svg' width='5' height='5'>"
                 "<s:g><s:path id='a' d='M0 0L1 1'/><path d='M0 0L1 1'/></s:g></s:svg>");
        QCOMPARE(sheet.contours.size(), std::size_t{1});
    }

    void moved_by_style() {
        expect_refusal(on_sheet("<g id='face' style='transform:translate(5px)'/>"), "face");
        QCOMPARE(drawn("<path style='transform:none' d='M0 0L1 1'/>").size(), std::size_t{1});
    }

    void utf16() {
        QByteArray bytes("\xFF\xFE");
        for (const QChar c : QString::fromUtf8(on_sheet("<path id='œil 目' d='M0 0L1 1'/>"))) {
            bytes.append(static_cast<char>(c.unicode() & 0xFF));
            bytes.append(static_cast<char>(c.unicode() >> 8));
        }
        QCOMPARE(read(bytes.toStdString()).contours.at(0).name, std::string("œil 目"));
    }

    // Files that are no drawings

    void refused_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("word");
        const auto row = [](const char* name, const QByteArray& text, const char* word) {
            QTest::newRow(name) << text << QByteArray(word);
        };
        row("nothing", "", "nothing in it");
        row("white_space", " \n ", "nothing in it");
        row("prose", "Dear Anna,", "nothing in it");
        row("zero_bytes", QByteArray(1000, '\0'), "not an SVG");
        row("a_jpeg", QByteArray("\xFF\xD8\xFF\xE0\x00\x10JFIF", 10), "not an SVG");
        row("compressed", "\x1F\x8B\x08", "svgz");
        row("html", "<html><body/></html>", "<html>");
        row("cut_off", "<svg width='5' height='5'>\n<path d='M0 0L1", "line 2");
        row("mismatched", "<svg width='5'\nheight='5'>\n<g></svg>", "line 3");
        row("two_attributes_run_together", "<svg width='5'height='5'/>", "line 1");
        row("no_size", "<svg/>", "how large");
        row("width_alone", "<svg width='5mm'/>", "how large");
        row("percent_alone", "<svg width='100%' height='100%'/>", "how large");
        row("width_zero", "<svg width='0' height='5'/>", "width");
        row("height_negative", "<svg width='5' height='-5mm'/>", "height");
        row("width_too_large", "<svg width='1e400' height='5'/>", "width");
        row("width_word", "<svg width='wide' height='5'/>", "wide");
        row("width_nan", "<svg width='nan' height='5'/>", "nan");
        row("width_em", "<svg width='5em' height='5'/>", "5em");
        row("width_cm_overflows", "<svg width='1e308cm' height='5'/>", "width");
        row("view_box_three_numbers", "<svg viewBox='0 0 5'/>", "viewBox");
        row("view_box_flat", "<svg width='5' height='5' viewBox='0 0 5 0'/>", "viewBox");
        row("view_box_negative", "<svg viewBox='0 0 -5 5'/>", "viewBox");
        row("view_box_words", "<svg viewBox='a b c d'/>", "viewBox");
        row("view_box_infinite", "<svg viewBox='0 0 1e400 5'/>", "viewBox");
        row("aspect_beyond_double", "<svg width='1e300' viewBox='0 0 1e-300 1'/>", "size");
        row("root_moved_wrongly", "<svg width='5' height='5' transform='jump'/>", "transform");
    }
    void refused() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, word);
        expect_refusal(text.toStdString(), word.toStdString());
    }

    /// A sentence is spoken: at most sixty bytes of a name, no half letter, no line break.
    void a_name_in_a_sentence_is_cut_between_letters_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("said");
        const QByteArray letters(57, 'x');
        QTest::newRow("sixty_bytes") << letters + "abc" << letters + "abc\"";
        QTest::newRow("sixty_one_bytes") << letters + "abcd" << letters + "abc…";
        QTest::newRow("a_letter_across_the_end") << letters + "ab눈" << letters + "ab…";
        QTest::newRow("a_letter_at_the_end") << letters + "눈b" << letters + "눈…";
        QTest::newRow("half_a_letter_at_the_end") << letters + "a눈b" << letters + "a…";
        QTest::newRow("line_break") << QByteArray("left&#10;eye") << QByteArray("left eye");
        QTest::newRow("unit_separator") << QByteArray("left&#31;eye") << QByteArray("left eye");
        QTest::newRow("exclamation_mark_stays") << QByteArray("left!eye") << QByteArray("left!eye");
    }
    void a_name_in_a_sentence_is_cut_between_letters() {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, said);
        expect_refusal(on_sheet("<path id='" + name.toStdString() + "' d='broken'/>"), said.toStdString());
    }

    void what_has_no_name_is_told_by_its_kind() {
        expect_refusal(on_sheet("<path d='broken'/>"), "The path without an id");
        expect_refusal(on_sheet("<g transform='broken'/>"), "The group without an id");
        expect_refusal(on_sheet("<rect id='frame' width='wide' height='broad'/>"),
                       "\"width\""); // the first of two
    }

    void a_number_too_small_to_be_told_from_zero_is_zero() {
        compare_points(corners(only("<line x1='1e-400' x2='-1e-4000' y2='3'/>")), {{0, 0}, {0, 3}});
    }

    void long_names_are_short_in_sentences() {
        const auto sheet =
            sheet_from_svg(on_sheet("<path id='" + std::string(100'000, 'x') + "' d='broken'/>"));
        QVERIFY(!sheet.ok());
        QVERIFY(sheet.error().size() < 200);
    }
};

QTEST_GUILESS_MAIN(DrawingTest)
#include "drawing_test.moc"
