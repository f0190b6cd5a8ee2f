// SPDX-License-Identifier: Apache-2.0
#include "lab_parts.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTest>

namespace lab_hand_test {

using namespace tp;

class LabHandTest : public QObject {
    Q_OBJECT
private slots:
    void the_laws_differ_at_a_corner_and_the_page_says_where_the_finger_is() {
        LabParts bench;
        bench.scene.choose(1);
        bench.tuning.setNumber("vertexSpacing", 10.0, "Spacing");
        const auto told = [&](int law, double x, double y) {
            bench.tuning.chooseLaw(law);
            bench.touch(x, y);
            bench.hand.whereAmI();
            return bench.last();
        };
        int different = 0;
        for (double x = -6.0; x <= 6.0; x += 2.0)
            for (double y = 24.0; y <= 34.0; y += 2.0)
                different += told(1, x, y) != told(0, x, y) ? 1 : 0;
        QVERIFY(different > 0);
        // Beyond the top corner both pull to it.
        QCOMPARE(told(1, 2.0, 36.0), told(0, 2.0, 36.0));
        QVERIFY2(bench.last().startsWith("The finger is 2.0 mm right, 36.0 mm above of the middle."),
                 qPrintable(bench.last()));
        QVERIFY(bench.last().contains("from triangle"));
        bench.touch(100.0, 70.0);
        bench.hand.whereAmI();
        QVERIFY(bench.last().endsWith("No line pulls there."));
    }

    void places_are_those_of_the_drawn_sheet() {
        LabParts bench;
        bench.touch(0.0, 0.0);
        QCOMPARE(bench.hand.pointer(), QPointF(110, 80));
        bench.hand.nudge(-10, 20);
        QVERIFY(bench.hand.place() == Vec2(-10, -20));
        bench.hand.moveTo(-50, 1000); // beyond the border
        QCOMPARE(bench.hand.pointer(), QPointF(0, 160));
        bench.hand.show({20, 30}, {0.3, 0.4});
        QCOMPARE(bench.hand.finger(), QPointF(130, 50));
        QCOMPARE(bench.hand.force(), QPointF(0.3, -0.4));
        QCOMPARE(bench.hand.newtons(), 0.5);
        QCOMPARE(bench.hand.pointer(), QPointF(0, 160));
        bench.hand.replay({0, 0}, {});
        QCOMPARE(bench.hand.pointer(), QPointF(110, 80));
    }
    void the_finger_is_under_the_hand_unless_a_device_has_it() {
        LabParts bench;
        QSignalSpy placed(&bench.hand, &LabHand::placed);
        QSignalSpy led(&bench.hand, &LabHand::led);
        bench.touch(5.0, 5.0);
        QCOMPARE(bench.hand.finger(), bench.hand.pointer());
        bench.activity.become(LabActivity::Running);
        bench.hand.nudge(2, 0);
        QCOMPARE(bench.hand.finger() + QPointF(2, 0), bench.hand.pointer());
        QCOMPARE(placed.size(), 1);
        QCOMPARE(led.size(), 1);
        bench.hand.show({1, 1}, {1, 0});
        bench.hand.release();
        QCOMPARE(bench.hand.newtons(), 0.0);
    }
};

} // namespace lab_hand_test

TP_TEST(lab_hand_test, LabHandTest, window)
#include "lab_hand_test.moc"
