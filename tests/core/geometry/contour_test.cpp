// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/contour.hpp"
#include "test_program.hpp"

#include <QTest>

#include <limits>

namespace contour_test {

using namespace tp;

class ContourTest : public QObject {
    Q_OBJECT

private slots:
    void points_of_each_kind() {
        const Vec2 a(0, 0);
        const Vec2 b(4, 8);
        const Vec2 c(2, -1);
        for (const Piece& piece : {Piece(Line{a, b}), Piece(Quadratic{a, c, b}), Piece(Cubic{a, c, c, b})}) {
            QVERIFY(start_of(piece) == a);
            QVERIFY(end_of(piece) == b);
            QVERIFY(point_at(piece, 0.0) == a);
            QVERIFY(point_at(piece, 1.0) == b);
        }
        QVERIFY(point_at(Line{a, b}, 0.25) == Vec2(1, 2));
        QVERIFY(point_at(Quadratic{a, c, b}, 0.5) == 0.25 * a + 0.5 * c + 0.25 * b);
        QVERIFY(point_at(Cubic{a, c, Vec2(8, 8), b}, 0.5) == 0.125 * (a + 3.0 * c + 3.0 * Vec2(8, 8) + b));
    }

    void a_piece_that_was_given_no_points_is_one_at_the_origin() {
        for (const Piece& piece : {Piece(Line{}), Piece(Quadratic{}), Piece(Cubic{})})
            for (const double t : {0.0, 0.3, 0.7, 1.0})
                QVERIFY(point_at(piece, t) == Vec2(0.0));
        QVERIFY(!Contour{}.closed);
    }

    void not_finite_in_any_point() {
        for (const double bad :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity()}) {
            const Vec2 p(1, bad);
            const Vec2 q(1, 2);
            for (const Piece& piece :
                 {Piece(Line{p, q}), Piece(Line{q, p}), Piece(Quadratic{p, q, q}), Piece(Quadratic{q, p, q}),
                  Piece(Quadratic{q, q, p}), Piece(Cubic{p, q, q, q}), Piece(Cubic{q, p, q, q}),
                  Piece(Cubic{q, q, p, q}), Piece(Cubic{q, q, q, p})})
                QVERIFY(!is_finite(piece));
        }
        QVERIFY(is_finite(Piece(Cubic{})));
    }

    void contour_through_points() {
        const Contour open = contour_through("a", {{0, 0}, {1, 0}, {1, 1}}, false);
        QCOMPARE(open.pieces.size(), std::size_t{2});
        const Contour closed = contour_through("a", {{0, 0}, {1, 0}, {1, 1}}, true);
        QCOMPARE(closed.pieces.size(), std::size_t{3});
        QVERIFY(end_of(closed.pieces.back()) == start_of(closed.pieces.front()));
        for (const bool both : {false, true}) {
            const Contour dot = contour_through("a", {{3, 4}}, both);
            QCOMPARE(dot.pieces.size(), std::size_t{1});
            QVERIFY(start_of(dot.pieces[0]) == end_of(dot.pieces[0]));
            QVERIFY(contour_through("a", {}, both).pieces.empty());
        }
    }

    void mapped_keeps_name_kind_and_form() {
        const Contour contour{
            "lip",
            {Line{{0, 0}, {1, 0}}, Quadratic{{1, 0}, {2, 0}, {2, 1}}, Cubic{{2, 1}, {3, 1}, {3, 2}, {0, 0}}},
            true};
        const Contour moved = mapped(contour, [](Vec2 p) { return Vec2(2 * p.x + p.y + 1, 3 * p.y - 2); });
        QCOMPARE(moved.name, contour.name);
        QVERIFY(moved.closed);
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(moved.pieces[i].index(), contour.pieces[i].index());
            for (const double t : {0.0, 0.3, 0.5, 1.0}) { // an affine map of the points maps the curve
                const Vec2 p = point_at(contour.pieces[i], t);
                QVERIFY(length(point_at(moved.pieces[i], t) - Vec2(2 * p.x + p.y + 1, 3 * p.y - 2)) < 1e-14);
            }
        }
    }
};

} // namespace contour_test

TP_TEST(contour_test, ContourTest, event_loop)
#include "contour_test.moc"
