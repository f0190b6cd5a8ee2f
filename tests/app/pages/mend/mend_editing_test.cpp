// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_editing.hpp"
#include "mend_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <string>

namespace mend_editing_test {

using namespace tp;

namespace {

struct EditingBench : MendParts {
    MendDrag drag{photo, view, selection, history, narrator};
    MendEditing editing{photo, view, selection, history, drag, narrator};

    explicit EditingBench(int faces = 1) { show(faces); }
};

} // namespace

class MendEditingTest : public QObject {
    Q_OBJECT
private slots:
    void a_nudge_moves_the_point_and_tells_its_place() {
        EditingBench bench;
        bench.editing.nudge(1, 0);
        QVERIFY(bench.said().startsWith("No point is selected"));
        QVERIFY(!bench.history.canUndo());
        bench.selection.chooseHandle(0);
        bench.editing.nudge(10, 0);
        bench.editing.nudge(0.2, -1);
        QCOMPARE(bench.said(), QString("222.2 across, 119 down."));
        QVERIFY(length(bench.node(0).at - Vec2(222.2, 119)) < 1e-9);
        QVERIFY(bench.selection.featureMended());
        bench.editing.nudge(std::nan(""), 0);
        QVERIFY(length(bench.node(0).at - Vec2(222.2, 119)) < 1e-9);
        bench.history.undo(); // both at once
        QCOMPARE(bench.node(0).at, Vec2(212, 120));
    }
    void a_screen_reader_nudges_a_point_by_its_number() {
        EditingBench bench;
        const Vec2 before = bench.node(2).at;
        bench.editing.nudgeHandle(99, 1, 0);
        bench.editing.nudgeHandle(2, 0, 1);
        QCOMPARE(bench.selection.handle(), 2);
        QVERIFY(bench.node(2).at == before + Vec2(0, 1));
    }
    void nothing_is_nudged_while_a_hand_drags_or_another_photograph_is_read() {
        EditingBench bench;
        const std::string before = bench.text();
        bench.selection.chooseHandle(0);
        const QPointF at = bench.window(0);
        bench.drag.grab(at.x(), at.y(), 10.0);
        bench.editing.nudge(1, 0);
        bench.drag.drop();
        bench.photo.look();
        bench.editing.nudge(1, 0);
        bench.editing.addFace();
        QCOMPARE(bench.text(), before);
    }
    void the_whole_feature_moves() {
        EditingBench bench;
        bench.selection.setWholeFeature(true);
        const MendContour before = *bench.selection.line();
        bench.editing.nudge(3, 4);
        for (std::size_t i = 0; i < before.nodes.size(); ++i)
            QVERIFY(bench.selection.line()->nodes[i].at == before.nodes[i].at + Vec2(3, 4));
        QCOMPARE(bench.said(), QString("left eye: 233 across, 124 down."));
    }
    void points_are_added_deleted_and_turned() {
        EditingBench bench;
        const int count = bench.selection.handles()->rowCount();
        bench.editing.deletePoint();
        QVERIFY(bench.said().startsWith("No point is selected"));
        bench.selection.chooseHandle(0);
        bench.editing.addPoint();
        QVERIFY(bench.said().startsWith("Added. Point "));
        QCOMPARE(bench.selection.handles()->rowCount(), count + 2); // the point and a control more
        bench.editing.deletePoint();
        QCOMPARE(bench.selection.handles()->rowCount(), count);
        bench.selection.chooseHandle(0);
        bench.editing.turnCorner();
        QCOMPARE(bench.said(), QString("Smooth now."));
        QVERIFY(!bench.selection.handleIsCorner());
        const QPointF beside = bench.window(4);
        bench.editing.addPointAt(beside.x(), beside.y());
        QCOMPARE(bench.selection.handles()->rowCount(), count + 2);
    }
    void a_feature_keeps_its_last_points() {
        EditingBench bench;
        bench.selection.chooseFeature(nose); // not felt: there is no line yet
        bench.editing.addFeature();
        std::string before;
        for (int i = 0; i < 20 && bench.text() != before; ++i) {
            before = bench.text();
            bench.selection.chooseHandle(0);
            bench.editing.deletePoint();
        }
        QCOMPARE(bench.said(), QString("The nose needs its last points. The whole feature can be removed."));
    }
    void a_feature_is_removed_and_added_as_it_was_found() {
        EditingBench bench;
        const std::string before = bench.text();
        bench.editing.removeFeature();
        QVERIFY(!bench.selection.featureThere());
        QVERIFY(bench.text() != before);
        bench.editing.removeFeature();
        QCOMPARE(bench.said(), QString("left eye: missing. It can be added."));
        bench.editing.addFeature();
        QVERIFY(bench.selection.featureThere());
        QCOMPARE(bench.text(), before);
        bench.editing.addFeature();
        QCOMPARE(bench.said(), QString("The left eye is there already."));
    }
    void a_feature_that_was_not_found_is_added_in_its_usual_shape() {
        EditingBench bench;
        bench.selection.chooseFeature(mouth_opening);
        bench.editing.addFeature();
        QVERIFY(bench.selection.featureThere());
        const Rect box = bounds_of(*bench.selection.line());
        QVERIFY(bounds_of(*bench.feature(lips).line).contains(box.centre())); // where the mouth is
        bench.editing.resetFeature();
        QVERIFY(!bench.selection.featureThere());
        bench.selection.chooseFeature(nose);
        bench.editing.addFeature(); // one of the extras: as it was found
        QVERIFY(bench.said().contains("as the program found it"));
        QVERIFY(bench.selection.featureMended());
    }
    void an_eye_that_is_missing_is_the_other_one_in_a_mirror() {
        EditingBench bench;
        bench.editing.removeFeature();
        MendFace face = bench.photo.work().faces[0];
        const MendContour eye = template_for(face, feature::left_eye);
        const Rect box = bounds_of(eye);
        QVERIFY(std::abs(box.centre().x - 230.0) < 2.0 && std::abs(box.centre().y - 120.0) < 2.0);
        face.features[right_eye].line.reset();
        const Rect usual = bounds_of(template_for(face, feature::left_eye));
        QVERIFY(std::abs(usual.centre().x - 230.0) < 15.0 && std::abs(usual.centre().y - 120.0) < 15.0);
    }
    void one_feature_is_reset_and_the_others_stay() {
        EditingBench bench;
        const MendContour found = *bench.selection.line();
        bench.editing.nudgeHandle(0, 5, 5);
        bench.selection.chooseFeature(right_eye);
        bench.editing.nudgeHandle(0, -3, 0);
        const MendContour other = *bench.selection.line();
        bench.selection.chooseFeature(left_eye);
        bench.editing.resetFeature();
        QVERIFY(*bench.selection.line() == found);
        QVERIFY(*bench.feature(right_eye).line == other);
        bench.editing.resetFeature();
        QCOMPARE(bench.said(), QString("The left eye is as the program found it."));
    }
    void a_face_of_usual_shape_is_added_where_none_was_found() {
        EditingBench bench(0);
        bench.editing.addPoint();
        bench.editing.removeFeature();
        bench.editing.addFeature();
        QVERIFY(!bench.history.canUndo());
        bench.editing.addFace();
        QCOMPARE(bench.selection.features().size(), 5);
        QCOMPARE(bench.selection.feature(), 0);
        QVERIFY(bench.selection.featureThere());
        bench.history.undo();
        QVERIFY(bench.selection.features().isEmpty());
    }
    void a_second_face_is_taken_in_hand() {
        EditingBench bench;
        bench.editing.addFace();
        QCOMPARE(bench.selection.featureName(), QString("left eye of face 2"));
    }
};

} // namespace mend_editing_test

TP_TEST(mend_editing_test, MendEditingTest, window)
#include "mend_editing_test.moc"
