// SPDX-License-Identifier: Apache-2.0
#include "app/parts/finger/fault_watch.hpp"

#include <QTest>

using namespace tp;

class FaultWatchTest : public QObject {
    Q_OBJECT
private slots:
    void a_disabling_fault_is_told_at_once_and_once() {
        FaultWatch watch;
        QVERIFY(!watch.must_tell(Fault::none, 10.0));
        QVERIFY(watch.must_tell(Fault::device_lost, 10.02));
        QVERIFY(!watch.must_tell(Fault::device_lost, 20.0));
        QCOMPARE(watch.shown(), Fault::device_lost);
        QVERIFY(!watch.must_tell(Fault::none, 20.1));
        QCOMPARE(watch.shown(), Fault::none);
    }
    void a_fault_at_the_very_beginning_is_told() {
        FaultWatch watch;
        QVERIFY(watch.must_tell(Fault::stalled, 0.0));
    }
    void a_fault_of_a_moment_is_not_told() {
        FaultWatch watch;
        QVERIFY(!watch.must_tell(Fault::late_ticks, 10.0));
        QVERIFY(!watch.must_tell(Fault::none, 10.1));
        QVERIFY(!watch.must_tell(Fault::late_ticks, 10.6));
        QCOMPARE(watch.shown(), Fault::none);
    }
    void a_fault_that_lasts_is_told() {
        FaultWatch watch;
        QVERIFY(!watch.must_tell(Fault::over_speed, 10.0));
        QVERIFY(watch.must_tell(Fault::over_speed, 10.6));
    }
    void a_graver_fault_is_told_after_a_lighter_one() {
        FaultWatch watch;
        watch.must_tell(Fault::late_ticks, 10.0);
        QVERIFY(watch.must_tell(Fault::late_ticks, 11.0));
        QVERIFY(watch.must_tell(Fault::device_lost, 11.1));
    }
    void motors_that_wait_for_a_person_are_told_again_a_few_times() {
        FaultWatch watch;
        int told = 0;
        for (double now = 0.0; now < 200.0; now += 0.25)
            told += watch.must_tell(Fault::motors_off, now);
        QCOMPARE(told, 1 + FaultWatch::most_reminders);
        watch.must_tell(Fault::over_speed, 300.0);
        for (double now = 300.0; now < 400.0; now += 0.25) // another is told once
            told += watch.must_tell(Fault::over_speed, now);
        QCOMPARE(told, 2 + FaultWatch::most_reminders);
    }
    void that_motors_obey_again_is_told_once() {
        FaultWatch watch;
        QVERIFY(!watch.must_tell(Fault::motors_off, 10.0));
        QVERIFY(!watch.must_tell(Fault::none, 10.1));
        QVERIFY(!watch.must_tell_ready(10.7)); // that they were off was not told
        watch.must_tell(Fault::motors_off, 11.0);
        QVERIFY(watch.must_tell(Fault::motors_off, 11.6));
        QVERIFY(!watch.must_tell_ready(11.6));
        QVERIFY(!watch.must_tell(Fault::none, 12.0));
        QVERIFY(!watch.must_tell_ready(12.1)); // perhaps only for a moment
        watch.must_tell(Fault::none, 12.6);
        QVERIFY(watch.must_tell_ready(12.6));
        QVERIFY(!watch.must_tell_ready(12.7));
        watch.must_tell(Fault::motors_off, 13.0);
        QVERIFY(watch.must_tell(Fault::motors_off, 13.6)); // it was said that they obey
        watch.must_tell(Fault::device_lost, 14.0);
        watch.must_tell(Fault::none, 15.0);
        QVERIFY(!watch.must_tell_ready(16.0)); // of another fault nothing is said
    }
    void the_same_fault_is_told_again_only_after_a_while() {
        FaultWatch watch;
        QVERIFY(watch.must_tell(Fault::stalled, 10.0));
        watch.must_tell(Fault::none, 10.1);
        QVERIFY(!watch.must_tell(Fault::stalled, 11.0));
        watch.must_tell(Fault::none, 11.1);
        watch.must_tell(Fault::none, 15.0);
        QVERIFY(watch.must_tell(Fault::stalled, 15.1));
    }
};

QTEST_GUILESS_MAIN(FaultWatchTest)
#include "fault_watch_test.moc"
