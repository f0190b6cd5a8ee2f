// SPDX-License-Identifier: Apache-2.0
#include "mend_bench.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTest>

namespace mend_selection_test {

using namespace tp;

namespace {

struct SelectionBench : MendParts {
    explicit SelectionBench(int faces = 1) { show(faces); }
};

} // namespace

class MendSelectionTest : public QObject {
    Q_OBJECT
private slots:
    void a_photograph_comes_with_its_first_feature_in_hand_and_no_point() {
        SelectionBench bench;
        QCOMPARE(bench.selection.features(),
                 QStringList({"left eye", "right eye", "lips", "mouth opening", "face outline", "nose"}));
        QCOMPARE(bench.selection.feature(), left_eye);
        QVERIFY(bench.selection.featureThere() && !bench.selection.featureMended());
        QCOMPARE(bench.selection.handle(), -1);
        QVERIFY(bench.selection.handleName().isEmpty() && bench.selection.handlePlace().isEmpty());
        SelectionBench nobody(0);
        QCOMPARE(nobody.selection.feature(), -1);
        QVERIFY(!nobody.selection.featureThere() && nobody.selection.featureName().isEmpty());
        QVERIFY(!nobody.selection.stepHandle(1));
    }
    void several_faces_are_told_apart() {
        SelectionBench bench(2);
        QCOMPARE(bench.selection.features().size(), 12);
        QCOMPARE(bench.selection.features()[6], QString("left eye of face 2"));
        bench.selection.chooseFeature(6);
        QVERIFY(bench.said().startsWith("left eye of face 2, "));
        QVERIFY(bench.selection.face() == &bench.photo.work().faces[1]);
    }
    void features_are_stepped_through_in_a_ring() {
        SelectionBench bench;
        bench.selection.stepFeature(-1);
        QCOMPARE(bench.selection.feature(), nose);
        bench.selection.stepFeature(1);
        QCOMPARE(bench.selection.feature(), left_eye);
        bench.selection.chooseFeature(mouth_opening);
        QCOMPARE(bench.said(), QString("mouth opening: missing. It can be added."));
        bench.selection.chooseFeature(99);
        QCOMPARE(bench.selection.feature(), mouth_opening);
    }
    void tab_goes_from_point_to_point_and_out() {
        SelectionBench bench;
        const int count = bench.selection.handles()->rowCount();
        for (int i = 0; i < count; ++i)
            QVERIFY(bench.selection.stepHandle(1));
        QVERIFY(bench.said().contains(QString("%1 of %1").arg(count)));
        QVERIFY(!bench.selection.stepHandle(1));
        QVERIFY(bench.selection.stepHandle(-1));
        QCOMPARE(bench.selection.handle(), count - 1);
    }
    void a_point_in_hand_is_told_and_in_sight() {
        SelectionBench bench;
        bench.view.panBy(5000, 5000);
        bench.selection.chooseHandle(0);
        QCOMPARE(bench.said(), "Corner 1 of " + QString::number(bench.selection.handles()->rowCount()) +
                                   ": 212 across, 120 down.");
        QVERIFY(QRectF(0, 0, 800, 600).contains(bench.window(0)));
        QVERIFY(bench.selection.handleIsCorner() && bench.selection.handleTurns());
        bench.selection.chooseHandle(99);
        QCOMPARE(bench.selection.handle(), 0);
    }
    void a_tap_takes_a_point_or_another_feature() {
        SelectionBench bench;
        bench.view.showAll();
        const QPointF corner = bench.window(0);
        bench.selection.tap(corner.x() + 2, corner.y(), 10.0);
        QCOMPARE(bench.selection.handle(), 0);
        const QPointF at = bench.view.to_window(bench.feature(outline).line->nodes[0].at);
        bench.selection.tap(at.x(), at.y(), 10.0);
        QCOMPARE(bench.selection.feature(), outline);
        QCOMPARE(bench.selection.handle(), -1);
        QVERIFY(bench.said().startsWith("face outline, "));
    }
    void where_one_is_is_told() {
        SelectionBench bench;
        bench.selection.whereAmI();
        QVERIFY(bench.said().startsWith("left eye, ") && bench.said().endsWith(", none selected."));
        bench.selection.chooseHandle(0);
        bench.selection.whereAmI();
        QVERIFY(bench.said().contains(" of the left eye: 212 across, 120 down."));
        bench.selection.chooseFeature(mouth_opening);
        bench.selection.whereAmI();
        QCOMPARE(bench.said(), QString("mouth opening: missing. It can be added."));
        SelectionBench nobody(0);
        QSignalSpy asked(&nobody.selection, &MendSelection::nothingInHand);
        nobody.selection.whereAmI();
        QCOMPARE(asked.size(), 1);
        bench.photo.look();
        QSignalSpy meanwhile(&bench.selection, &MendSelection::nothingInHand);
        bench.selection.whereAmI();
        QCOMPARE(meanwhile.size(), 1);
    }
    void what_is_left_is_said_before_something_else_is_taken() {
        SelectionBench bench;
        QStringList left;
        connect(&bench.selection, &MendSelection::leavingFeature,
                [&] { left << QString("feature %1").arg(bench.selection.feature()); });
        connect(&bench.selection, &MendSelection::leavingPoint,
                [&] { left << QString("point %1").arg(bench.selection.handle()); });
        bench.selection.chooseHandle(3);
        bench.selection.chooseFeature(lips);
        bench.selection.setWholeFeature(true);
        QCOMPARE(bench.said(), QString("The whole feature moves."));
        bench.selection.setWholeFeature(true);
        QCOMPARE(left, QStringList({"point -1", "feature 0", "point 3", "point -1"}));
    }
    void it_follows_the_contours() {
        SelectionBench bench;
        const int count = bench.selection.handles()->rowCount();
        bench.selection.chooseHandle(count - 1);
        bench.photo.change([&](MendWork& work) { delete_node(*bench.selection.own_in(work).line, 2); });
        QVERIFY(bench.selection.handles()->rowCount() < count);
        QCOMPARE(bench.selection.handle(), bench.selection.handles()->rowCount() - 1);
        bench.move(7.0);
        QCOMPARE(bench.selection.handles()->rows()[0].place, QPointF(219, 120));
        QVERIFY(bench.selection.featureMended());
        bench.selection.chooseFeature(nose);
        bench.photo.change([](MendWork& work) { work.faces[0].features.pop_back(); });
        QCOMPARE(bench.selection.feature(), outline); // the last one that there is
        bench.photo.change([](MendWork& work) { work.faces.clear(); });
        QCOMPARE(bench.selection.feature(), -1);
    }
    void what_is_in_hand_stays_under_the_hand_while_it_grows() {
        SelectionBench bench;
        bench.selection.chooseHandle(2);
        const QPointF before = bench.window(2);
        bench.selection.zoomBy(1.5);
        QVERIFY((bench.window(2) - before).manhattanLength() < 1e-9);
        bench.selection.chooseFeature(right_eye);
        const Vec2 middle = bench.view.to_photo(bench.view.middle());
        bench.selection.zoomBy(1 / 1.5);
        QVERIFY(length(bench.view.to_photo(bench.view.middle()) - middle) < 1e-9);
    }
    void a_feature_that_is_not_there_shows_its_face() {
        SelectionBench bench;
        const double close = bench.view.scale();
        bench.selection.chooseFeature(mouth_opening);
        QVERIFY(bench.view.scale() < close);
        const Vec2 middle = bench.view.to_photo(bench.view.middle());
        QVERIFY(length(middle - bench.selection.face()->box.centre()) < 1e-9);
    }
};

} // namespace mend_selection_test

TP_TEST(mend_selection_test, MendSelectionTest, window)
#include "mend_selection_test.moc"
