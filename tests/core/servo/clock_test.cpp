// SPDX-License-Identifier: Apache-2.0
#include "core/servo/clock.hpp"
#include "test_program.hpp"

#include <QTest>

namespace clock_test {

using namespace tp;

class ClockTest : public QObject {
    Q_OBJECT
private slots:
    void the_machine_s_clock_goes_on_and_wakes_nobody_too_early() {
        SteadyClock clock;
        const double begun = clock.now();
        QVERIFY(begun > 0.0);
        const double due = begun + 0.005;
        clock.sleep_until(due);
        QVERIFY(clock.now() >= due);
        clock.sleep_until(begun); // has passed
        QVERIFY(clock.now() >= due);
    }

    void simulated_time_moves_by_sleeping_and_never_back() {
        VirtualClock clock;
        QCOMPARE(clock.now(), 0.0);
        clock.sleep_until(2.5);
        QCOMPARE(clock.now(), 2.5);
        clock.sleep_until(1.0);
        QCOMPARE(clock.now(), 2.5);
    }
};

} // namespace clock_test

TP_TEST(clock_test, ClockTest, nothing)
#include "clock_test.moc"
