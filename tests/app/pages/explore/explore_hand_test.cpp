// SPDX-License-Identifier: Apache-2.0
#include "explore_parts.hpp"
#include "test_program.hpp"

#include <QStringList>
#include <QTest>

#include <vector>

namespace explore_hand_test {

using namespace tp;

class ExploreHandTest : public QObject {
    Q_OBJECT
private slots:
    void tab_order_goes_through_the_features_and_out() {
        ExploreParts bench;
        bench.voice.clear();
        for (int i = 0; i < 4; ++i)
            QVERIFY(bench.hand.stepFeature(1));
        QVERIFY(!bench.hand.stepFeature(1));
        QCOMPARE(bench.voice.said(), QStringList({"left eye", "right eye", "lips", "face outline"}));
        QVERIFY(bench.hand.stepFeature(-1)); // back in from the other side
        QCOMPARE(bench.voice.said().back(), QString("face outline"));
    }

    void a_hand_that_moves_ends_the_tour_and_one_that_trembles_does_not() {
        ExploreParts bench;
        bench.hand.goToFeature(left_eye);
        bench.hand.moveTo(20.0, 20.0);
        bench.tour.toggle();
        bench.hand.moveTo(22.0, 22.0);
        QVERIFY(bench.tour.touring());
        bench.hand.moveTo(25.0, 22.0);
        QVERIFY(!bench.tour.touring());
        QCOMPARE(bench.voice.said().back(), QString("Tour ended."));
    }

    void a_second_finger_ends_exploring_until_all_are_lifted() {
        ExploreParts bench;
        bench.down(bench.left_of_outline(10.0), 0);
        bench.down(bench.left_of_outline(40.0), 1);
        QVERIFY(!bench.sounds.guide.sounds());
        bench.move(bench.left_of_outline(5.0));
        QVERIFY(!bench.sounds.guide.sounds());
        bench.hand.fingersCancelled();
        bench.down(bench.left_of_outline(10.0), 0);
        QVERIFY(bench.sounds.guide.sounds());
    }

    void what_fingers_meant_is_told_when_they_are_lifted() {
        ExploreParts bench;
        std::vector<TouchGestures::Gesture> meant;
        QObject::connect(&bench.hand, &ExploreHand::meant,
                         [&](TouchGestures::Gesture gesture) { meant.push_back(gesture); });
        for (int i = 0; i < 3; ++i)
            bench.down(bench.left_of_outline(20.0 * i), i);
        QVERIFY(meant.empty());
        for (int i = 0; i < 3; ++i)
            bench.hand.fingerUp(i);
        QVERIFY(meant.back() == TouchGestures::Gesture::three_finger_tap);
        meant.clear();
        bench.down(bench.left_of_outline(20.0));
        bench.hand.fingersCancelled();
        QVERIFY(meant.empty());
    }

    void a_key_moves_the_hand_of_who_touches_and_ends_a_tour() {
        ExploreParts bench;
        const QPointF place = bench.left_of_outline(20.0);
        bench.down(place);
        bench.tour.toggle();
        bench.hand.nudge(2.0, -1.0);
        QCOMPARE(bench.said(), QString("Tour ended."));
        QVERIFY(bench.finger.hand().is() == HandState::Is::pointing);
    }

    void before_any_photograph_nothing_moves() {
        ExploreParts bench(0);
        bench.hand.touchDown(10.0, 10.0);
        bench.hand.moveTo(12.0, 10.0);
        bench.hand.nudge(1.0, 1.0);
        bench.hand.goToFeature(0);
        QVERIFY(!bench.hand.stepFeature(1));
        bench.down({50.0, 50.0});
        bench.move({60.0, 50.0});
        bench.hand.fingerUp(0);
        QVERIFY(!bench.sounds.guide.sounds());
        QCOMPARE(bench.voice.said(), QStringList());
        QVERIFY(bench.servo.pointer() == Vec2(0.0));
    }
};

} // namespace explore_hand_test

TP_TEST(explore_hand_test, ExploreHandTest, event_loop)
#include "explore_hand_test.moc"
