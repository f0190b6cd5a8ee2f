// SPDX-License-Identifier: Apache-2.0
// Arcs of paths lie within the tolerance of the ellipses that they are of.
#include "drawn_sheet.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>

namespace drawn_arcs_test {

using namespace tp;
using namespace tp::testing;

class DrawnArcsTest : public QObject {
    Q_OBJECT

private slots:
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
};

} // namespace drawn_arcs_test

TP_TEST(drawn_arcs_test, DrawnArcsTest, event_loop)
#include "drawn_arcs_test.moc"
