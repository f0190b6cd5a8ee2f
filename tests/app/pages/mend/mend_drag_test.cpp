// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_drag.hpp"
#include "mend_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <string>

namespace mend_drag_test {

using namespace tp;
using State = MendDrag::State;

namespace {

struct DragBench : MendParts {
    MendDrag drag{photo, view, selection, history, narrator};

    DragBench() { show(); }
    /// Takes a point by hand.
    bool grab(int index, QPointF beside = {}) {
        const QPointF at = window(index) + beside;
        return drag.grab(at.x(), at.y(), 30.0);
    }
    void drag_by(QPointF from, QPointF by) { drag.dragTo(from.x() + by.x(), from.y() + by.y()); }
};

} // namespace

class MendDragTest : public QObject {
    Q_OBJECT
private slots:
    void the_table_of_its_states_holds() {
        for (const State from : {State::Free, State::Held, State::Moving}) {
            const auto after = [from](auto&& happens) {
                DragBench bench;
                const QPointF at = bench.window(1);
                if (from != State::Free)
                    bench.grab(1);
                if (from == State::Moving)
                    bench.drag_by(at, {9, 9});
                [&] { QCOMPARE(bench.drag.state(), from); }();
                happens(bench, at);
                return bench.drag.state();
            };
            QCOMPARE(after([](DragBench& bench, QPointF) { bench.grab(2); }), State::Held);
            QCOMPARE(after([](DragBench& bench, QPointF at) {
                         bench.drag_by(at, {20, 5});
                     }),
                     from == State::Free ? State::Free : State::Moving);
            QCOMPARE(after([](DragBench& bench, QPointF) { bench.drag.drop(); }), State::Free);
            QCOMPARE(after([](DragBench& bench, QPointF) { bench.drag.cancel(); }), State::Free);
            QCOMPARE(after([](DragBench& bench, QPointF) { bench.history.undo(); }), State::Free);
            QCOMPARE(after([](DragBench& bench, QPointF) { bench.selection.chooseFeature(lips); }),
                     State::Free);
            QCOMPARE(after([](DragBench& bench, QPointF) { bench.show(); }), State::Free);
        }
        DragBench bench;
        bench.grab(1);
        const QPointF at = bench.window(1);
        bench.drag_by(at, {0, 0}); // the same place
        QCOMPARE(bench.drag.state(), State::Held);
    }
    void the_point_moves_by_as_much_as_the_hand() {
        DragBench bench;
        const QPointF from = bench.window(2) + QPointF(5, 3);
        const Vec2 before = bench.node(2).at;
        QVERIFY(bench.grab(2, {5, 3}));
        QCOMPARE(bench.selection.handle(), 2);
        for (int i = 1; i <= 10; ++i)
            bench.drag_by(from, {4.0 * i, -2.0 * i});
        bench.drag.drop();
        QVERIFY(length(bench.node(2).at - before - Vec2(40, -20) / bench.view.scale()) < 1e-9);
        QVERIFY(bench.selection.featureMended());
        QCOMPARE(bench.said(), bench.selection.handleName() + ": " + bench.selection.handlePlace() + ".");
        const std::string moved = bench.text();
        bench.history.undo(); // all of the drag
        QVERIFY(bench.node(2).at == before);
        bench.history.redo();
        QCOMPARE(bench.text(), moved);
    }
    void the_nearest_point_is_taken() {
        DragBench bench;
        for (int i = 0; i < bench.selection.handles()->rowCount(); ++i) {
            QVERIFY(bench.grab(i, {0.5, 0}));
            QCOMPARE(bench.selection.handle(), i);
            bench.drag.drop();
        }
        QVERIFY(!bench.history.canUndo()); // nothing was moved
        QVERIFY(!bench.drag.grab(-500.0, -500.0, 40.0));
        bench.photo.look();
        QVERIFY(!bench.grab(0));
    }
    void a_drag_that_is_cancelled_never_was() {
        DragBench bench;
        const std::string before = bench.text();
        const QPointF at = bench.window(1);
        QVERIFY(bench.grab(1));
        bench.drag_by(at, {50, 0});
        QVERIFY(bench.text() != before);
        QVERIFY(bench.drag.cancel());
        QCOMPARE(bench.said(), QString("Put back."));
        QCOMPARE(bench.text(), before);
        QVERIFY(!bench.history.canUndo());
        QVERIFY(!bench.history.canRedo());
        QVERIFY(!bench.drag.cancel());
    }
    void who_turns_to_something_else_has_put_back_what_was_dragged() {
        DragBench bench;
        bench.move();
        const std::string moved = bench.text();
        const QPointF at = bench.window(1);
        bench.grab(1), bench.drag_by(at, {50, 0});
        bench.selection.chooseFeature(lips);
        QCOMPARE(bench.text(), moved);
        bench.selection.chooseFeature(left_eye);
        bench.grab(1), bench.drag_by(at, {50, 0});
        bench.history.undo(); // of what was before the drag
        QVERIFY(!bench.history.canUndo());
    }
    void a_point_can_be_placed_to_a_fifth_of_a_pixel() {
        DragBench bench;
        bench.selection.chooseHandle(0);
        while (bench.view.scale() < 39.0)
            bench.selection.zoomBy(2.0);
        const Vec2 wanted = bench.node(0).at + Vec2(1.3, -0.7);
        const QPointF to = bench.view.to_window(wanted);
        QVERIFY(bench.grab(0));
        bench.drag.dragTo(std::round(to.x()), std::round(to.y())); // whole pixels of the screen
        bench.drag.drop();
        QVERIFY(length(bench.node(0).at - wanted) < 0.2);
    }
    void the_whole_feature_is_dragged_by_any_of_its_places() {
        DragBench bench;
        bench.selection.setWholeFeature(true);
        const MendContour before = *bench.selection.line();
        const QPointF at = bench.window(0);
        QVERIFY(bench.grab(0));
        bench.drag_by(at, {bench.view.scale() * 10, 0});
        bench.drag.drop();
        QCOMPARE(bench.said(), QString("left eye moved."));
        for (std::size_t i = 0; i < before.nodes.size(); ++i)
            QVERIFY(length(bench.selection.line()->nodes[i].at - before.nodes[i].at - Vec2(10, 0)) < 1e-9);
    }
    void a_drag_whose_point_is_let_go_moves_nothing() {
        DragBench bench;
        const QPointF at = bench.window(0);
        QVERIFY(bench.grab(0));
        QVERIFY(!bench.selection.stepHandle(-1)); // the keyboard goes past the first point
        const std::string before = bench.text();
        bench.drag_by(at, {50, 0});
        QCOMPARE(bench.text(), before);
        bench.drag.drop();
        QVERIFY(!bench.history.canUndo());
    }
};

} // namespace mend_drag_test

TP_TEST(mend_drag_test, MendDragTest, window)
#include "mend_drag_test.moc"
