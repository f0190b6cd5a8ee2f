// SPDX-License-Identifier: Apache-2.0
#include "core/servo/fresh_readings.hpp"
#include "test_program.hpp"
#include "troubled_stamps.hpp"

#include <QTest>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace fresh_readings_test {

using namespace tp;
using namespace tp::testing;

class FreshReadingsTest : public QObject {
    Q_OBJECT
private slots:
    /// To the last bit, so that a device without a clock of its own loses nothing.
    void a_stamp_of_the_servos_clock_is_taken_as_it_is() {
        FreshReadings readings;
        std::mt19937 random(1);
        double now = 12.3456;
        for (int i = 0; i < 10'000; ++i) {
            QCOMPARE(readings.taken(now, now), std::optional(now));
            now += 1e-4 + 1e-7 * static_cast<double>(random() % 100'000);
        }
    }

    void the_same_stamp_is_the_same_reading() {
        FreshReadings readings;
        QVERIFY(readings.taken(5.0, 1.0));
        for (int i = 1; i < 100; ++i)
            QVERIFY(!readings.taken(5.0, 1.0 + 0.001 * i));
        QVERIFY(FreshReadings().taken(5.0, 1.0)); // nothing is known yet
    }

    /// One in ten comes up to 4 ms late, and holds the next ones up; of a clock that begins anywhere.
    void what_comes_late_was_taken_when_it_was() {
        FreshReadings readings;
        std::mt19937 random(2);
        double came = 0.0;
        double before = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const double at = 0.001 * i;
            came = std::max(came + 1e-5,
                            at + 1e-6 * static_cast<double>(random() % (random() % 10 == 0 ? 4000 : 100)));
            const std::optional<double> taken = readings.taken(at - 1e6, came);
            QVERIFY2(taken, qPrintable(QString::number(i)));
            QVERIFY2(std::abs(*taken - at) < 6e-4, qPrintable(QString::number(*taken - at)));
            QVERIFY(i == 0 || std::abs(*taken - before - 0.001) < 6e-4);
            before = *taken;
        }
    }

    /// A queue that grows on the way: what comes is newer than what came, and too old.
    void a_reading_of_more_than_20_ms_ago_does_not_count() {
        FreshReadings readings;
        int counted = 0;
        for (int i = 0; i < 1000; ++i)
            counted += readings.taken(0.0009 * i, 0.001 * i)
                           ? 1
                           : 0; // 0.1 ms later with each, of which the clock may be 0.03
        QVERIFY2(counted > 280 && counted < 292, qPrintable(QString::number(counted)));
    }

    void after_a_pause_of_any_length_the_next_reading_counts() {
        FreshReadings readings;
        QVERIFY(readings.taken(0.0, 50.0));
        QVERIFY(readings.taken(1000.0, 1050.0));
        QVERIFY(readings.taken(5000.0, 5045.0)); // of a clock that is off by one part in a thousand
    }

    void each_trouble_of_a_clock_costs_as_many_readings_as_it_must_data() {
        QTest::addColumn<std::size_t>("number");
        for (std::size_t i = 0; i < survived_stamps().size(); ++i)
            QTest::newRow(survived_stamps()[i].name) << i;
    }
    void each_trouble_of_a_clock_costs_as_many_readings_as_it_must() {
        QFETCH(std::size_t, number);
        const StampTrouble& trouble = survived_stamps()[number];
        FreshReadings readings;
        for (int i = 0; i < 100; ++i)
            QVERIFY(readings.taken(7.0 + 0.001 * i, 0.001 * i));
        double before = 0.099;
        int blind = 0;
        for (int i = 0; i < 2000; ++i) {
            const double now = 0.100 + 0.001 * i;
            const std::optional<double> taken =
                readings.taken(trouble.stamped(7.0 + now, 7.0 + 0.099, i), now);
            ++blind;
            QVERIFY2(blind <= trouble.blind, qPrintable(QString::number(i)));
            if (!taken)
                continue;
            QVERIFY(*taken > before && *taken <= now);
            before = *taken;
            blind = 0;
        }
    }

    void stamps_of_readings_that_are_no_newer_do_not_count_data() {
        QTest::addColumn<std::size_t>("number");
        for (std::size_t i = 0; i < stale_stamps().size(); ++i)
            QTest::newRow(stale_stamps()[i].name) << i;
    }
    void stamps_of_readings_that_are_no_newer_do_not_count() {
        QFETCH(std::size_t, number);
        const StampTrouble& trouble = stale_stamps()[number];
        FreshReadings readings;
        for (int i = 0; i < 100; ++i)
            QVERIFY(readings.taken(7.0 + 0.001 * i, 0.001 * i));
        for (int i = 0; i < 2000; ++i) {
            const double now = 0.100 + 0.001 * i;
            const bool taken = readings.taken(trouble.stamped(7.0 + now, 7.0 + 0.099, i), now).has_value();
            QVERIFY2(!taken || 0.001 * i < trouble.stale_within - 0.020, qPrintable(QString::number(i)));
        }
        int blind = 0; // and the clock as it was is known again
        while (!readings.taken(7.0 + 2.1 + 0.001 * blind, 2.1 + 0.001 * blind))
            QVERIFY(++blind <= trouble.back_after);
    }

    /// Whatever comes, a reading was taken after the one before and not before 20 ms ago.
    void any_stamps_at_any_times() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const std::array<double, 10> odd{0.0,   -0.0,   infinity, -infinity, std::nan(""),
                                         1e308, -1e308, 5e-324,   1e17,      -1e-9};
        std::mt19937 random(3);
        for (int run = 0; run < 200; ++run) {
            FreshReadings readings;
            double now = 1e4 * run;
            double stamp = 0.0;
            double before = -infinity;
            for (int i = 0; i < 500; ++i) {
                now += random() % 4 == 0 ? 0.0 : 1e-6 * static_cast<double>(random() % 3000);
                stamp = random() % 20 == 0 ? odd[random() % odd.size()]
                                           : stamp + 1e-6 * static_cast<double>(random() % 3000) - 2e-4;
                if (const std::optional<double> taken = readings.taken(stamp, now)) {
                    QVERIFY(*taken > before && *taken <= now && *taken >= now - 0.020 - 1e-9);
                    before = *taken;
                }
            }
        }
    }
};

} // namespace fresh_readings_test

TP_TEST(fresh_readings_test, FreshReadingsTest, nothing)
#include "fresh_readings_test.moc"
