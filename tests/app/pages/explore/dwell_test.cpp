// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/dwell.hpp"
#include "test_program.hpp"

#include <QTest>

namespace dwell_test {

using namespace tp;

class DwellTest : public QObject {
    Q_OBJECT
private slots:
    void a_feature_is_told_after_the_stay_and_once() {
        Dwell dwell(0.150);
        QCOMPARE(dwell.follow(3, 1.0), -1);
        QCOMPARE(dwell.follow(3, 1.149), -1);
        QCOMPARE(dwell.follow(3, 1.151), 3);
        QCOMPARE(dwell.follow(3, 9.0), -1);
    }
    void passing_over_is_silent() {
        Dwell dwell(0.150);
        for (int i = 0; i < 100; ++i)
            QCOMPARE(dwell.follow(i % 3 - 1, 0.1 * i), -1);
    }
    void leaving_and_coming_back_begins_anew() {
        Dwell dwell(0.150);
        dwell.follow(3, 1.0);
        QCOMPARE(dwell.follow(3, 2.0), 3);
        dwell.follow(-1, 2.1);
        QCOMPARE(dwell.follow(3, 2.2), -1);
        QCOMPARE(dwell.follow(3, 2.36), 3);
    }
    void what_was_told_already_is_not_told_again() {
        Dwell dwell(0.150);
        dwell.settle(2);
        QCOMPARE(dwell.follow(2, 5.0), -1);
        QCOMPARE(dwell.follow(4, 5.1), -1);
        QCOMPARE(dwell.follow(4, 5.3), 4);
    }
};

} // namespace dwell_test

TP_TEST(dwell_test, DwellTest, event_loop)
#include "dwell_test.moc"
