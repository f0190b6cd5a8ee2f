// SPDX-License-Identifier: Apache-2.0
#include "core/statistics/studentized_range.hpp"
#include "test_program.hpp"

#include <QTest>

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numbers>

namespace studentized_range_test {

using namespace tp;

class StudentizedRangeTest : public QObject {
    Q_OBJECT
private slots:
    /// Printed tables: Pearson and Hartley, Biometrika Tables for Statisticians, 1966, table 29.
    void critical_values_of_the_tables_data() {
        QTest::addColumn<int>("means");
        QTest::addColumn<double>("df");
        QTest::addColumn<double>("q");
        QTest::addColumn<double>("p");
        QTest::newRow("3, 10") << 3 << 10.0 << 3.877 << 0.05;
        QTest::newRow("2, 1") << 2 << 1.0 << 17.97 << 0.05;
        QTest::newRow("5, 40") << 5 << 40.0 << 4.039 << 0.05;
        QTest::newRow("10, 20") << 10 << 20.0 << 5.008 << 0.05;
        QTest::newRow("3, 10, 1 %") << 3 << 10.0 << 5.270 << 0.01;
    }
    void critical_values_of_the_tables() {
        QFETCH(int, means);
        QFETCH(double, df);
        QFETCH(double, q);
        QFETCH(double, p);
        QVERIFY(std::abs(studentized_range_above(q, means, df) / p - 1.0) <
                0.002); // three digits are printed
    }
    /// Two means: the t distribution, which is elementary for one and two degrees of freedom.
    void two_means_are_a_t_test() {
        for (const double q : {1e-6, 0.1, 1.0, 3.0, 10.0, 100.0, 1e4}) {
            const double t = q / std::numbers::sqrt2;
            const double with_1 = 2.0 * std::atan2(1.0, t) / std::numbers::pi;
            const double with_2 =
                2.0 / ((2.0 + t * t) * (1.0 + t / std::sqrt(2.0 + t * t))); // 1 - t/√(2 + t²)
            QVERIFY2(std::abs(studentized_range_above(q, 2, 1.0) / with_1 - 1.0) < 1e-9,
                     qPrintable(QString::number(q)));
            QVERIFY2(std::abs(studentized_range_above(q, 2, 2.0) / with_2 - 1.0) < 1e-9,
                     qPrintable(QString::number(q)));
        }
    }
    /// The same by Boost, with few degrees of freedom and with many.
    void two_means_are_a_t_test_with_any_degrees_of_freedom() {
        for (const double df : {1.0, 3.0, 12.0, 17.0, 20.0, 21.0, 60.0, 4000.0})
            for (const double q : {0.01, 1.0, 8.0}) {
                const double t = q / std::numbers::sqrt2;
                const double by_t = 2.0 * cdf(complement(boost::math::students_t(df), t));
                QVERIFY2(std::abs(studentized_range_above(q, 2, df) / by_t - 1.0) < 2e-10,
                         qPrintable(QString("%1 degrees of freedom, %2").arg(df).arg(q)));
            }
    }
    /// With an error that is known well the range of two numbers is normal.
    void many_degrees_of_freedom_are_the_normal_range() {
        for (const double q : {0.5, 2.0, 6.0, 10.0})
            QVERIFY(std::abs(studentized_range_above(q, 2, 1e9) / std::erfc(0.5 * q) - 1.0) < 1e-6);
    }
    void it_falls_with_q_and_grows_with_the_number_of_means() {
        for (const double df : {1.0, 4.0, 36.0, 500.0}) {
            double before = 1.0;
            for (double q = 0.5; q < 12.0; q += 1.0) {
                const double here = studentized_range_above(q, 4, df);
                QVERIFY(here > 0.0 && here < before);
                QVERIFY(studentized_range_above(q, 5, df) > here);
                before = here;
            }
        }
        QCOMPARE(studentized_range_above(0.0, 3, 10.0), 1.0);
    }
};

} // namespace studentized_range_test

TP_TEST(studentized_range_test, StudentizedRangeTest, nothing)
#include "studentized_range_test.moc"
