// SPDX-License-Identifier: Apache-2.0
// The commands of a path become the pieces they look like.
#include "drawn_sheet.hpp"
#include "test_program.hpp"

#include <QTest>

#include <string>

namespace drawn_paths_test {

using namespace tp;
using namespace tp::testing;

class DrawnPathsTest : public QObject {
    Q_OBJECT

private slots:
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
        for (const char* data : {"M0 0L5 0L5 5L1e-10 1e-10Z", "m0 0l5 0 0 5 -5 -4.9999999999z",
                                 "M40 30L45 30L45 35L40.0000000001 30Z"}) {
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
};

} // namespace drawn_paths_test

TP_TEST(drawn_paths_test, DrawnPathsTest, event_loop)
#include "drawn_paths_test.moc"
