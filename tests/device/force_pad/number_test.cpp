// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/firmware/number.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

namespace number_test {

using namespace tp::pad;

class PadNumberTest : public QObject {
    Q_OBJECT
private slots:
    void the_small_mathematics_is_as_good_as_the_library() {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> exponent(-30.0, 30.0);
        std::uniform_real_distribution<double> angle(-7.0, 7.0);
        for (int i = 0; i < 20000; ++i) {
            const double v = std::exp(exponent(random));
            QVERIFY(std::abs(square_root(v) / std::sqrt(v) - 1.0) < 4e-16);
            const auto f = static_cast<float>(v);
            QVERIFY(std::abs(square_root(f) / std::sqrt(f) - 1.0f) < 2.5e-7f);
            const double a = angle(random);
            const SineCosine<double> turn = sine_cosine(a);
            QVERIFY(std::abs(turn.sine - std::sin(a)) < 2e-15);
            QVERIFY(std::abs(turn.cosine - std::cos(a)) < 2e-15);
            const SineCosine<float> small = sine_cosine(static_cast<float>(a));
            QVERIFY(std::abs(static_cast<double>(small.sine) - std::sin(double(static_cast<float>(a)))) <
                    3e-7);
            QVERIFY(std::abs(static_cast<double>(small.cosine) - std::cos(double(static_cast<float>(a)))) <
                    3e-7);
        }
        QCOMPARE(square_root(0.0f), 0.0f);
        QCOMPARE(square_root(-1.0), 0.0);
        QCOMPARE(square_root(std::numeric_limits<double>::quiet_NaN()), 0.0);
    }

    /// Without a reduction only the series is left, which ends where the next term is below rounding.
    void within_an_eighth_of_a_turn_sine_and_cosine_are_exact_to_the_last_place() {
        for (int i = -1000; i <= 1000; ++i) {
            const double a = 0.785 * i / 1000.0;
            const SineCosine<double> turn = sine_cosine(a);
            QVERIFY(std::abs(turn.sine - std::sin(a)) < 2.3e-16);
            QVERIFY(std::abs(turn.cosine - std::cos(a)) < 2.3e-16);
            const auto f = static_cast<float>(a);
            const SineCosine<float> small = sine_cosine(f);
            QVERIFY(std::abs(double(small.sine) - std::sin(double(f))) < 1.2e-7);
            QVERIFY(std::abs(double(small.cosine) - std::cos(double(f))) < 1.2e-7);
        }
    }

    void an_angle_counts_up_to_a_thousand_and_no_further() {
        for (const double a : {999.9, -999.9, 600.0, -600.0, 333.3, -333.3}) {
            const SineCosine<double> turn = sine_cosine(a);
            QVERIFY(std::abs(turn.sine - std::sin(a)) < 1e-13);
            QVERIFY(std::abs(turn.cosine - std::cos(a)) < 1e-13);
        }
        const double infinite = std::numeric_limits<double>::infinity();
        for (const double a :
             {1000.0, -1000.0, 1e9, -1e9, infinite, -infinite, std::numeric_limits<double>::quiet_NaN()}) {
            const SineCosine<double> turn = sine_cosine(a);
            QVERIFY(std::isnan(turn.sine) && std::isnan(turn.cosine));
        }
    }

    void the_middle_of_three_is_what_is_within() {
        QCOMPARE(clamped(2.0, 1.0, 3.0), 2.0);
        QCOMPARE(clamped(0.5, 1.0, 3.0), 1.0);
        QCOMPARE(clamped(3.5, 1.0, 3.0), 3.0);
        QVERIFY(std::isnan(clamped(std::numeric_limits<double>::quiet_NaN(), 1.0, 3.0)));
        QVERIFY(smaller(1, 2) == 1 && smaller(2, 1) == 1);
        QVERIFY(larger(1, 2) == 2 && larger(2, 1) == 2);
        QVERIFY(absolute(-1.5) == 1.5 && absolute(1.5) == 1.5);
    }
};

} // namespace number_test

TP_TEST(number_test, PadNumberTest, nothing)
#include "number_test.moc"
