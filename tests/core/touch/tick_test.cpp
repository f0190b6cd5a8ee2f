// SPDX-License-Identifier: Apache-2.0
#include "core/touch/tick.hpp"
#include "test_program.hpp"

#include <QTest>

#include <limits>

namespace tick_test {

using namespace tp;

class TickTest : public QObject {
    Q_OBJECT
private slots:
    void what_lies_within_the_bounds_is_kept() {
        const Tick tick(0.25, 0.5, 0.01);
        QCOMPARE(tick.amplitude(), 0.25);
        QCOMPARE(tick.sharpness(), 0.5);
        QCOMPARE(tick.seconds(), 0.01);
        QVERIFY(!tick.empty());
    }

    void nothing_goes_beyond_them() {
        const double infinity = std::numeric_limits<double>::infinity();
        for (const double much : {1.5, 1e300, infinity}) {
            const Tick tick(much, much, much);
            QCOMPARE(tick.amplitude(), 1.0);
            QCOMPARE(tick.sharpness(), 1.0);
            QCOMPARE(tick.seconds(), 0.05);
        }
        for (const double nothing : {-1.0, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
            const Tick tick(nothing, nothing, nothing);
            QCOMPARE(tick.amplitude(), 0.0);
            QCOMPARE(tick.sharpness(), 0.0);
            QCOMPARE(tick.seconds(), 0.0);
        }
    }

    void what_has_no_amplitude_or_no_duration_is_nothing() {
        QVERIFY(Tick().empty());
        QVERIFY(Tick(0.0, 1.0, 0.01).empty());
        QVERIFY(Tick(1.0, 1.0, 0.0).empty());
    }

    void a_share_of_it_is_softer_and_as_sharp_and_long() {
        QVERIFY(Tick(0.5, 0.3, 0.01).scaled(0.5) == Tick(0.25, 0.3, 0.01));
        QVERIFY(Tick(0.5, 0.3, 0.01).scaled(std::numeric_limits<double>::quiet_NaN()).empty());
    }
};

} // namespace tick_test

TP_TEST(tick_test, TickTest, nothing)
#include "tick_test.moc"
