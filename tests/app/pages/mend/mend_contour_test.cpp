// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_contour.hpp"
#include "core/geometry/flatten.hpp"
#include "core/svg/contour_sheet.hpp"
#include "faces/pieces/fewest_pieces.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace mend_contour_test {

using namespace tp;

namespace {

using Kind = MendNode::Kind;

/// A closed smooth line with two corners, as the extraction makes them, a little different for every `seed`.
Contour an_eye(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> off(-2.0, 2.0);
    std::vector<Vec2> points;
    for (int i = 0; i < 24; ++i) {
        const double a = 2.0 * 3.14159265358979 * i / 24.0;
        points.emplace_back(200.0 + 60.0 * std::cos(a) + off(random), 150.0 + 25.0 * std::sin(a) + off(random));
    }
    return fewest_pieces("left_eye", points, true, {0, 12}, 0.8);
}

Contour an_outline(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> off(-2.0, 2.0);
    std::vector<Vec2> points;
    for (int i = 0; i <= 20; ++i) {
        const double a = 3.14159265358979 * i / 20.0;
        points.emplace_back(200.0 + 100.0 * std::cos(a) + off(random), 150.0 + 130.0 * std::sin(a) + off(random));
    }
    return fewest_pieces("outline", points, false, {}, 0.8);
}

/// The largest turn at a point that says it is smooth, radians.
double worst_turn(const MendContour& contour) {
    double worst = 0.0;
    const std::size_t count = contour.nodes.size();
    for (std::size_t i = 0; i < count; ++i)
        if (contour.nodes[i].kind == Kind::smooth) {
            const Vec2 in = contour.nodes[i].at - contour.nodes[(i + count - 1) % count].at;
            const Vec2 out = contour.nodes[(i + 1) % count].at - contour.nodes[i].at;
            worst = std::max(worst, std::abs(std::atan2(cross(in, out), glm::dot(in, out))));
        }
    return worst;
}

double apart(const Contour& one, const Contour& other) {
    double largest = 0.0;
    const Polyline line = flatten(other, {0.002, 10.0});
    for (const Vec2 p : flatten(one, {0.002, 10.0}).points)
        largest = std::max(largest, distance_to(line, p));
    return largest;
}

int count_of(const MendContour& contour, Kind kind) {
    return static_cast<int>(
        std::count_if(contour.nodes.begin(), contour.nodes.end(), [&](const MendNode& n) { return n.kind == kind; }));
}

std::string svg_of(const Contour& contour) {
    return sheet_to_svg({400.0, 300.0, ContourSheet::Unit::pixel, {contour}});
}

} // namespace

class MendContourTest : public QObject {
    Q_OBJECT
private slots:
    void there_and_back_is_the_same_contour() {
        for (unsigned seed = 0; seed < 50; ++seed)
            for (const Contour& contour : {an_eye(seed), an_outline(seed)}) {
                const auto mended = mendable(contour);
                QVERIFY(mended);
                QCOMPARE(svg_of(contour_of(*mended)), svg_of(contour));
                QVERIFY(mendable(contour_of(*mended)) == mended);
            }
    }
    void cubics_lines_and_gaps() {
        const Contour contour{"x", {Line{{0, 0}, {10, 0}}, Cubic{{10, 0}, {15, 0}, {20, 5}, {20, 10}}, Line{{30, 10}, {0, 0}}}, true};
        const auto mended = mendable(contour);
        QVERIFY(mended);
        QCOMPARE(mended->nodes.size(), 6u); // the gap has a straight piece
        QVERIFY(mended->nodes[1].kind == Kind::smooth);
        QCOMPARE(contour_of(*mended).pieces.size(), 4u);
    }
    void without_a_piece_there_is_nothing() {
        QVERIFY(!mendable({"x", {}, true}));
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!mendable({"x", {Line{{nan, 0}, {1, 1}}}, false}));
    }
    void an_eye_has_two_corners() {
        const auto mended = mendable(an_eye(3));
        QCOMPARE(count_of(*mended, Kind::corner), 2);
        QVERIFY(count_of(*mended, Kind::smooth) > 0);
    }

    void a_moved_point_is_where_it_was_put_and_smooth_joins_stay_smooth() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> off(-15.0, 15.0);
        for (unsigned seed = 0; seed < 60; ++seed)
            for (const Contour& contour : {an_eye(seed), an_outline(seed)}) {
                MendContour mended = *mendable(contour);
                const int smooth = count_of(mended, Kind::smooth);
                for (int i = 0; i < 12; ++i) {
                    const std::size_t node = random() % mended.nodes.size();
                    const Vec2 to = mended.nodes[node].at + Vec2(off(random), off(random));
                    move_node(mended, node, to);
                    QCOMPARE(mended.nodes[node].at.x, to.x);
                    QCOMPARE(mended.nodes[node].at.y, to.y);
                    QVERIFY2(worst_turn(mended) < 0.02, qPrintable(QString::number(worst_turn(mended))));
                }
                QVERIFY(count_of(mended, Kind::smooth) >= smooth - 12);
                QCOMPARE(count_of(mended, Kind::control), count_of(*mendable(contour), Kind::control));
            }
    }
    void a_moved_control_leaves_the_rest_of_the_line_alone() {
        MendContour mended = *mendable(an_eye(1));
        const MendContour before = mended;
        std::size_t control = 0;
        while (mended.nodes[control].on_curve())
            ++control;
        move_node(mended, control, mended.nodes[control].at + Vec2(5, -3));
        int moved = 0;
        for (std::size_t i = 0; i < mended.nodes.size(); ++i)
            moved += mended.nodes[i] == before.nodes[i] ? 0 : 1;
        QVERIFY(moved >= 1 && moved <= 3);
    }
    void what_is_not_a_number_moves_nothing() {
        MendContour mended = *mendable(an_eye(1));
        const MendContour before = mended;
        const double nan = std::numeric_limits<double>::quiet_NaN();
        move_node(mended, 0, {nan, 1.0});
        move_all(mended, {1.0, std::numeric_limits<double>::infinity()});
        QVERIFY(mended == before);
    }
    void a_smooth_point_between_two_corners_becomes_a_corner() {
        MendContour mended = *mendable(contour_through("x", {{0, 0}, {10, 0}, {20, 0}, {20, 20}}, true));
        QVERIFY(mended.nodes[1].kind == Kind::smooth);
        move_node(mended, 1, {10, 5});
        QVERIFY(mended.nodes[1].kind == Kind::corner);
        QVERIFY(mended.nodes[1].at == Vec2(10, 5));
        QVERIFY(mended.nodes[2].at == Vec2(20, 0));
    }
    void the_whole_line_moves() {
        MendContour mended = *mendable(an_outline(4));
        const MendContour before = mended;
        move_all(mended, {3, 4});
        for (std::size_t i = 0; i < mended.nodes.size(); ++i)
            QVERIFY(mended.nodes[i].at == before.nodes[i].at + Vec2(3, 4));
    }

    void a_new_point_leaves_the_curve_as_it_is() {
        std::mt19937 random(5);
        for (unsigned seed = 0; seed < 12; ++seed)
            for (const Contour& contour : {an_eye(seed), an_outline(seed)}) {
                MendContour mended = *mendable(contour);
                const int joints = count_of(mended, Kind::corner) + count_of(mended, Kind::smooth);
                for (int i = 0; i < 4; ++i) {
                    const std::size_t node =
                        i % 2 ? add_node_after(mended, random() % mended.nodes.size())
                              : add_node_near(mended, {double(random() % 400), double(random() % 300)});
                    QVERIFY(mended.nodes[node].kind == Kind::smooth);
                }
                QCOMPARE(count_of(mended, Kind::corner) + count_of(mended, Kind::smooth), joints + 4);
                QVERIFY(apart(contour_of(mended), contour) < 0.01);
                QVERIFY(apart(contour, contour_of(mended)) < 0.01);
                QVERIFY(worst_turn(mended) < 0.02);
            }
    }
    void a_new_point_lies_nearest_to_where_it_was_wanted() {
        MendContour line = *mendable(contour_through("x", {{0, 0}, {100, 0}, {100, 100}}, false));
        const std::size_t node = add_node_near(line, {30, 7});
        QVERIFY(length(line.nodes[node].at - Vec2(30, 0)) < 1e-3);
    }
    void adding_and_deleting_a_point_is_no_change() {
        for (unsigned seed = 0; seed < 12; ++seed) {
            const Contour contour = an_eye(seed);
            MendContour mended = *mendable(contour);
            for (std::size_t node = 0; node < mended.nodes.size(); node += 3) {
                MendContour trial = mended;
                QVERIFY(delete_node(trial, add_node_after(trial, node)));
                QCOMPARE(trial.nodes.size(), mended.nodes.size());
                QVERIFY(apart(contour_of(trial), contour) < 0.01);
            }
        }
    }
    void every_point_can_be_deleted_until_the_last_ones() {
        for (unsigned seed = 0; seed < 12; ++seed)
            for (const Contour& contour : {an_eye(seed), an_outline(seed)}) {
                std::mt19937 random(seed);
                MendContour mended = *mendable(contour);
                for (int refused = 0; refused < 20;) {
                    const std::size_t before = mended.nodes.size();
                    const bool done = delete_node(mended, random() % mended.nodes.size());
                    refused += done ? 0 : 1;
                    QVERIFY(done ? mended.nodes.size() < before : mended.nodes.size() == before);
                    QVERIFY(mended.nodes.front().on_curve());
                    QVERIFY(contour.closed || mended.nodes.back().on_curve());
                    QVERIFY(worst_turn(mended) < 0.02);
                    QVERIFY(!contour_of(mended).pieces.empty());
                    QVERIFY(mendable(contour_of(mended)));
                }
                QVERIFY(count_of(mended, Kind::corner) + count_of(mended, Kind::smooth) >= 2);
            }
    }
    void a_corner_becomes_smooth_and_a_corner_again() {
        MendContour mended = *mendable(an_eye(2));
        QVERIFY(mended.nodes[0].kind == Kind::corner);
        QVERIFY(toggle_corner(mended, 0));
        QVERIFY(mended.nodes[0].kind == Kind::smooth);
        QVERIFY(worst_turn(mended) < 0.02);
        QVERIFY(toggle_corner(mended, 0));
        QVERIFY(mended.nodes[0].kind == Kind::corner);
        QVERIFY(!toggle_corner(mended, 1)); // a control
        MendContour open = *mendable(an_outline(2));
        QVERIFY(!toggle_corner(open, 0));
        MendContour square = *mendable(contour_through("x", {{0, 0}, {9, 0}, {9, 9}, {0, 9}}, true));
        QVERIFY(!toggle_corner(square, 1));
    }
};

} // namespace mend_contour_test

TP_TEST(mend_contour_test, MendContourTest, event_loop)
#include "mend_contour_test.moc"
