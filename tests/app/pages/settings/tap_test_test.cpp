// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/tap_test.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <vector>

namespace tap_test_test {

using namespace tp;

namespace {

TapTest of_delays(const std::vector<double>& delays) {
    TapTest test;
    double time = 10.0;
    for (const double delay : delays) {
        test.ticked(time);
        test.tapped(time + delay);
        time += 2.0;
    }
    return test;
}

} // namespace

class TapTestTest : public QObject {
    Q_OBJECT
private slots:
    void the_median_less_a_usual_reaction_is_the_latency() {
        const TapTest test = of_delays({0.25, 0.23, 0.6, 0.24, 0.22});
        QVERIFY(std::abs(*test.latency() - (0.24 - TapTest::reaction_s)) < 1e-9);
        const TapTest even = of_delays({0.22, 0.26, 0.24, 0.20});
        QVERIFY(std::abs(*even.latency() - (0.23 - TapTest::reaction_s)) < 1e-9);
    }

    void it_is_bounded() {
        QCOMPARE(*of_delays({0.12, 0.12, 0.12, 0.12}).latency(), 0.0);
        QCOMPARE(*of_delays({0.7, 0.7, 0.7, 0.7}).latency(), TapTest::longest_latency_s);
    }

    void guesses_and_misses_do_not_count() {
        QVERIFY(!of_delays({0.05, 0.05, 0.05, 0.05}).latency());
        QVERIFY(!of_delays({0.9, 0.9, 0.9, 0.9}).latency());
        QVERIFY(!of_delays({0.2, 0.2, 0.2}).latency());
        QVERIFY(!TapTest().latency());
    }

    void only_the_first_tap_after_a_tick_counts() {
        TapTest test = of_delays({0.2, 0.2, 0.2});
        test.ticked(50.0);
        test.tapped(50.05); // a guess
        test.tapped(50.2);
        QVERIFY(!test.latency());
        test.tapped(60.0); // no tick
        QVERIFY(!test.latency());
    }

    void pauses_are_uneven() {
        for (int i = 1; i < TapTest::ticks; ++i)
            QVERIFY(TapTest::pause_before(i) != TapTest::pause_before(i - 1));
    }
};

} // namespace tap_test_test

TP_TEST(tap_test_test, TapTestTest, nothing)
#include "tap_test_test.moc"
