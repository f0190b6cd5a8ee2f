// SPDX-License-Identifier: Apache-2.0
#include "core/servo/timing_statistics.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace timing_statistics_test {

using tp::TimingStatistics;

class TimingStatisticsTest : public QObject {
    Q_OBJECT
private slots:
    void quantiles_are_at_most_a_bucket_too_high() {
        std::mt19937 random(9);
        std::lognormal_distribution<double> durations(-9.0, 1.5);
        TimingStatistics statistics;
        std::vector<double> all;
        for (int i = 0; i < 20000; ++i) {
            all.push_back(durations(random));
            statistics.record(all.back());
        }
        std::sort(all.begin(), all.end());
        for (const double q : {0.01, 0.5, 0.99, 0.999}) {
            const double truth = all[static_cast<std::size_t>(std::ceil(q * 20000.0)) - 1];
            QVERIFY(statistics.quantile(q) >= truth * (1.0 - 1e-12));
            QVERIFY(statistics.quantile(q) <= truth * 1.045);
        }
        QCOMPARE(statistics.max(), all.back());
        QCOMPARE(statistics.quantile(1.0), all.back());
        QCOMPARE(statistics.count(), std::uint64_t(20000));
    }

    void a_share_of_two_is_one_of_them() {
        TimingStatistics statistics;
        statistics.record(0.0);
        statistics.record(1.0);
        QVERIFY(statistics.quantile(0.1) <= 16e-9);
        QVERIFY(statistics.quantile(0.5) <= 16e-9);
        QCOMPARE(statistics.quantile(0.51), 1.0);
        TimingStatistics one;
        one.record(1.0);
        QCOMPARE(one.quantile(0.0), 1.0);
    }

    void nothing_recorded_and_hostile_values() {
        TimingStatistics statistics;
        QCOMPARE(statistics.quantile(0.5), 0.0);
        for (const double value : {-1.0, std::nan(""), 0.0})
            statistics.record(value);
        QCOMPARE(statistics.max(), 0.0);
        QCOMPARE(statistics.quantile(0.99), 0.0);
        statistics.record(std::numeric_limits<double>::infinity());
        statistics.record(1e9);
        QCOMPARE(statistics.count(), std::uint64_t(5));
        QVERIFY(statistics.quantile(0.6) <= 16e-9);
        QVERIFY(statistics.quantile(0.8) > 16.0 &&
                statistics.quantile(0.8) < 17.2); // as long as is told apart
        QVERIFY(std::isinf(statistics.max()));
        for (const double beyond : {1.5, 2.0, 1e300}) // no share is more than all
            QCOMPARE(statistics.quantile(beyond), statistics.quantile(1.0));
        QCOMPARE(statistics.quantile(-1.0), statistics.quantile(0.0));
    }
};

} // namespace timing_statistics_test

TP_TEST(timing_statistics_test, TimingStatisticsTest, nothing)
#include "timing_statistics_test.moc"
