// SPDX-License-Identifier: Apache-2.0
// What is seen of contours that are mended: the lines, and the points of the one in hand, each kind in a shape of its own.
#include "app/pages/mend/mend_lines_item.hpp"
#include "drawn_item.hpp"
#include "mend_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cstddef>

namespace mend_lines_item_test {

using namespace tp;
using namespace tp::testing;

namespace {

const QColor line(60, 200, 255), highlight(255, 210, 0), white(255, 255, 255);

struct Bench : MendBench {
    DrawnItem<MendLinesItem> drawn{{800, 600}};

    Bench() {
        drawn.set("lineColor", line);
        drawn.set("highlightColor", highlight);
        drawn.item.setSession(&session);
    }
    ~Bench() { drawn.item.setSession(nullptr); }
    /// The first point of that kind.
    int point(MendNode::Kind kind) {
        const auto& nodes = selection().line()->nodes;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (nodes[i].kind == kind)
                return static_cast<int>(i);
        return -1;
    }
    /// The colour beside a point, px.
    QColor beside(int point, QPoint by = {}) {
        return drawn.picture().pixelColor(window(point).toPoint() + by);
    }
};

} // namespace

class MendLinesItemTest : public QObject {
    Q_OBJECT
private slots:
    void the_feature_in_hand_is_highlighted_and_the_others_are_not() {
        Bench bench;
        bench.selection().take_feature(left_eye);
        bench.session.view()->show({{150.0, 100.0}, {250.0, 140.0}}); // both eyes
        QImage seen = bench.drawn.picture();
        const auto at = [&](int feature) { // all of it, with room for its points
            const auto& features = bench.session.photo()->work().faces[0].features;
            QRectF area;
            for (const MendNode& node : features[static_cast<std::size_t>(feature)].line->nodes)
                area |= QRectF(bench.session.view()->to_window(node.at) - QPointF(8, 8), QSizeF(16, 16));
            return area.toAlignedRect();
        };
        QVERIFY(extent_of(seen.copy(at(left_eye)), line).isEmpty());
        QVERIFY(!extent_of(seen.copy(at(left_eye)), white).isEmpty());
        QVERIFY(!extent_of(seen.copy(at(right_eye)), line).isEmpty());
        QVERIFY(extent_of(seen.copy(at(right_eye)), highlight).isEmpty());
        QVERIFY(extent_of(seen.copy(at(right_eye)), white).isEmpty()); // it shows no points
        bench.selection().take_feature(right_eye);
        seen = bench.drawn.picture();
        QVERIFY(!extent_of(seen.copy(at(left_eye)), line).isEmpty());
        QVERIFY(!extent_of(seen.copy(at(right_eye)), white).isEmpty());
        const QPointF corner = bench.window(0);
        bench.session.view()->zoomAt(1000.0, corner.x(), corner.y()); // its points do not cover it there
        QVERIFY(!extent_of(bench.drawn.picture(), highlight).isEmpty());
    }

    void a_corner_is_a_square_a_smooth_point_a_disc_and_a_control_a_ring() {
        Bench bench;
        bench.selection().take_feature(left_eye);
        bench.selection().fitIntoView();
        const int corner = bench.point(MendNode::Kind::corner), smooth = bench.point(MendNode::Kind::smooth),
                  control = bench.point(MendNode::Kind::control);
        QVERIFY(corner >= 0 && control >= 0);
        QVERIFY(is_near(bench.beside(corner), white));
        QVERIFY(is_near(bench.beside(corner, {-4, -4}), white) &&
                is_near(bench.beside(corner, {-4, 4}), white));
        if (smooth >= 0) {
            QVERIFY(is_near(bench.beside(smooth), white));
            QVERIFY(!is_near(bench.beside(smooth, {-5, -5}), white) &&
                    !is_near(bench.beside(smooth, {-5, 5}), white));
        }
        QVERIFY(bench.beside(control).lightness() < 60); // its hole
        QVERIFY(is_near(bench.beside(control, {3, 0}), white) ||
                is_near(bench.beside(control, {0, 3}), white));
    }

    void the_point_in_hand_is_filled_and_larger_and_all_are_where_all_move() {
        Bench bench;
        bench.selection().take_feature(left_eye);
        bench.selection().fitIntoView();
        const int corner = bench.point(MendNode::Kind::corner);
        const auto filled = [&] {
            const QRect around(bench.window(corner).toPoint() - QPoint(10, 10), QSize(21, 21));
            return extent_of(bench.drawn.picture().copy(around), highlight);
        };
        bench.selection().take_handle(corner);
        QVERIFY(is_near(bench.beside(corner), highlight));
        QVERIFY(filled().width() >= 13 && filled().height() >= 13);
        bench.selection().take_handle(corner == 0 ? 1 : 0);
        QVERIFY(is_near(bench.beside(corner), white));
        bench.selection().setWholeFeature(true);
        QVERIFY(is_near(bench.beside(corner), highlight));
    }

    void a_control_hangs_on_a_stalk() {
        Bench bench;
        bench.selection().take_feature(left_eye);
        bench.selection().fitIntoView();
        const int control = bench.point(MendNode::Kind::control);
        const int before =
            control == 0 ? static_cast<int>(bench.selection().line()->nodes.size()) - 1 : control - 1;
        const QPoint middle = (0.5 * (bench.window(control) + bench.window(before))).toPoint();
        const QImage seen = bench.drawn.picture();
        int whitest = 0; // neither the ground nor the highlighted line is blue
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                whitest = std::max(whitest, seen.pixelColor(middle + QPoint(x, y)).blue());
        QVERIFY2(whitest > 100, qPrintable(QString::number(whitest)));
    }

    void what_is_moved_is_seen_at_its_new_place() {
        Bench bench;
        bench.selection().take_feature(left_eye);
        bench.selection().fitIntoView();
        const QImage before = bench.drawn.picture();
        bench.session.view()->panBy(30, 0);
        const QImage after = bench.drawn.picture();
        QVERIFY(after != before);
        QVERIFY(is_near(bench.beside(bench.point(MendNode::Kind::corner)), white));
        bench.drawn.item.setSession(nullptr);
        QVERIFY(extent_of(bench.drawn.picture(), white).isEmpty());
    }
};

} // namespace mend_lines_item_test

TP_TEST(mend_lines_item_test, MendLinesItemTest, window)
#include "mend_lines_item_test.moc"
