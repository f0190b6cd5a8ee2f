// SPDX-License-Identifier: Apache-2.0
#include "explore_parts.hpp"
#include "test_program.hpp"

#include <QTest>

namespace explore_finger_test {

using namespace tp;

class ExploreFingerTest : public QObject {
    Q_OBJECT
private slots:
    void the_finger_is_drawn_into_the_line() {
        ExploreParts bench;
        const QPointF corner = bench.view.frame().from_surface(bench.view.felt().lines[3].points[1]);
        const QPointF beside = corner + QPointF(-5.0, -30.0);
        bench.hand.touchDown(beside.x(), beside.y());
        QTRY_VERIFY(bench.finger.newtons() > 0.2);
        QTRY_VERIFY(bench.distance_to(3, bench.finger.place()) < 3.0);
        QCOMPARE(bench.finger.pointer(), beside);
    }

    void the_fingertip_counts_on_a_touchscreen_and_not_the_drawn_finger() {
        ExploreParts bench;
        const QPointF beside = bench.left_of_outline(6.0); // the force would draw the finger nearer
        bench.down(beside);
        bench.finger.whereAmI();
        QCOMPARE(bench.said(), QString("Beside the face. Face outline at 3 o'clock, 6 millimetre(s)."));
    }

    void where_am_i_is_answered() {
        ExploreParts bench;
        bench.hand.goToFeature(left_eye);
        bench.finger.whereAmI();
        QVERIFY2(bench.voice.said().back().startsWith("The face. On the left eye, at its "),
                 qPrintable(bench.voice.said().back()));
        QVERIFY(bench.voice.said().back().endsWith(" from its middle."));
    }

    void where_am_i_is_answered_everywhere() {
        ExploreParts bench(1, {"Anna"});
        bench.down(bench.by(left_eye, 0.0, 6.0));
        bench.finger.whereAmI();
        QCOMPARE(bench.said(), QString("Anna. Left eye at 6 o'clock, 6 millimetre(s)."));
        bench.hand.fingerUp(0);
        bench.down(bench.left_of_outline(12.0));
        bench.finger.whereAmI();
        QCOMPARE(bench.said(), QString("Beside Anna. Face outline at 3 o'clock, 12 millimetre(s)."));
        ExploreParts empty(0);
        empty.finger.whereAmI();
        QCOMPARE(
            empty.said(),
            QString("There is no photograph yet. Press O, or the button Open photograph, to choose one."));
    }

    void the_feature_that_is_meant_is_the_one_under_the_finger_or_the_last_or_the_nearest() {
        ExploreParts bench;
        bench.down(bench.by(lips, -5.0));
        QCOMPARE(bench.finger.feature(), -1);
        QCOMPARE(bench.finger.meant_feature(), lips);
        bench.hand.goToFeature(left_eye);
        bench.down(bench.left_of_outline(10.0));
        QCOMPARE(bench.finger.feature(), -1);
        QCOMPARE(bench.finger.meant_feature(), left_eye);
        bench.move(bench.by(outline));
        QCOMPARE(bench.finger.meant_feature(), outline);
        QCOMPARE(bench.finger.featureName(), QString("face outline"));
        bench.view.show(drawn_photo()); // of which nothing was felt yet
        QCOMPARE(bench.finger.feature(), -1);
        QCOMPARE(bench.finger.last_feature(), -1);
    }

    void it_is_told_once_it_has_stayed_and_again_after_another_touch() {
        ExploreParts bench;
        bench.timer.stop();
        const QPointF on = bench.by(left_eye);
        bench.finger.hand().one_finger();
        bench.finger.set_down(bench.view.frame().to_surface(on));
        QCOMPARE(bench.finger.follow(), left_eye);
        QCOMPARE(bench.finger.stays(100.0), -1);
        QCOMPARE(bench.finger.stays(100.2), left_eye);
        QCOMPARE(bench.finger.stays(101.0), -1);
        bench.finger.forget_stay();
        QCOMPARE(bench.finger.stays(102.0), -1);
        QCOMPARE(bench.finger.stays(102.2), left_eye);
        bench.finger.forget_stay();
        bench.finger.settle();
        QCOMPARE(bench.finger.stays(104.0), -1);
    }
};

} // namespace explore_finger_test

TP_TEST(explore_finger_test, ExploreFingerTest, event_loop)
#include "explore_finger_test.moc"
