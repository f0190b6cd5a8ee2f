// SPDX-License-Identifier: Apache-2.0
#include "core/statistics/repeated_anova.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <random>
#include <utility>

namespace repeated_anova_test {

using namespace tp;

namespace {

/// Each participant's numbers, cell by cell.
WithinMeans means(std::vector<Factor> factors, const std::vector<std::vector<double>>& values) {
    WithinMeans result;
    result.factors = std::move(factors);
    for (const auto& one : values) {
        result.participants.push_back(std::to_string(result.participants.size() + 1));
        result.values.insert(result.values.end(), one.begin(), one.end());
    }
    return result;
}

bool near(double one, double other, double within = 1e-9) { return std::abs(one - other) <= within; }

std::vector<std::vector<double>> chance(std::size_t participants, std::size_t cells, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<std::vector<double>> values(participants);
    for (auto& one : values) {
        const double own = noise(random);
        for (std::size_t cell = 0; cell < cells; ++cell)
            one.push_back(own + noise(random) + 0.3 * static_cast<double>(cell));
    }
    return values;
}

} // namespace

class RepeatedAnovaTest : public QObject {
    Q_OBJECT
private slots:
    /// By hand: two levels are the paired t test squared.
    void two_levels_are_a_paired_t_test() {
        const auto anova =
            repeated_anova(means({{"law", {"exact", "published"}}}, {{1, 2}, {2, 4}, {3, 6}, {4, 5}}));
        // Differences 1, 2, 3, 1: mean 1.75, variance 0.9166667, t = 1.75 / sqrt(0.9166667 / 4) = 3.655631.
        const WithinEffect& law = anova.effects.front();
        QVERIFY(near(*law.f, 1.75 * 1.75 / (0.91666666666666666 / 4)));
        QCOMPARE(law.df, 1.0);
        QCOMPARE(law.error_df, 3.0);
        QVERIFY(near(*law.p, 0.0353531, 1e-6)); // pt(3.655631, 3, lower.tail = FALSE) * 2
        QVERIFY(near(*law.epsilon, 1.0));       // two levels are always spherical
        QVERIFY(near(*law.p, *law.p_spherical));
    }
    /// A textbook's way for one factor: sums of squares from row and column means.
    void one_factor_is_as_by_row_and_column_means() {
        const auto values = chance(7, 5, 3);
        double grand = 0.0;
        std::vector<double> columns(5), rows(7);
        for (std::size_t i = 0; i < 7; ++i)
            for (std::size_t j = 0; j < 5; ++j) {
                grand += values[i][j] / 35;
                columns[j] += values[i][j] / 7;
                rows[i] += values[i][j] / 5;
            }
        double between = 0.0, error = 0.0, people = 0.0;
        for (std::size_t j = 0; j < 5; ++j)
            between += 7 * std::pow(columns[j] - grand, 2);
        for (std::size_t i = 0; i < 7; ++i) {
            people += 5 * std::pow(rows[i] - grand, 2);
            for (std::size_t j = 0; j < 5; ++j)
                error += std::pow(values[i][j] - rows[i] - columns[j] + grand, 2);
        }
        const auto anova = repeated_anova(means({{"a", {"1", "2", "3", "4", "5"}}}, values));
        const WithinEffect& effect = anova.effects.front();
        QVERIFY(near(effect.sum, between));
        QVERIFY(near(effect.error_sum, error));
        QVERIFY(near(anova.participants_sum, people));
        QVERIFY(near(*effect.f, between / 4 / (error / 24)));
        QVERIFY(near(*effect.eta_squared, between / (between + error + people)));
        QVERIFY(*effect.epsilon >= 0.25 && *effect.epsilon < 1.0);
        QVERIFY(*effect.p_spherical > *effect.p);
    }
    void the_sums_of_squares_are_all_that_varies() {
        const auto values = chance(6, 24, 5);
        double grand = 0.0, all = 0.0;
        for (const auto& one : values)
            for (const double value : one)
                grand += value / (6 * 24);
        for (const auto& one : values)
            for (const double value : one)
                all += std::pow(value - grand, 2);
        const auto anova = repeated_anova(
            means({{"a", {"1", "2"}}, {"b", {"1", "2", "3"}}, {"c", {"1", "2", "3", "4"}}}, values));
        double sum = anova.participants_sum, df = 5.0;
        for (const WithinEffect& effect : anova.effects) {
            sum += effect.sum + effect.error_sum;
            df += effect.df + effect.error_df;
        }
        QCOMPARE(anova.effects.size(), std::size_t{7});
        QVERIFY(near(sum, all));
        QCOMPARE(df, 6.0 * 24.0 - 1.0);
    }
    void an_effect_that_is_there_is_found_and_no_other() {
        auto values = chance(10, 6, 8); // grows with the cell: 0.9 from one level of "a" to the other
        for (auto& one : values)
            for (std::size_t cell = 0; cell < 6; ++cell)
                one[cell] += cell >= 3 ? 3.0 : 0.0;
        const auto anova = repeated_anova(means({{"a", {"1", "2"}}, {"b", {"1", "2", "3"}}}, values));
        QCOMPARE(words_for(anova.effects[0], {{"a", {}}, {"b", {}}}), std::string("a"));
        QCOMPARE(words_for(anova.effects[2], {{"a", {}}, {"b", {}}}), std::string("a × b"));
        QVERIFY(*anova.effects[0].p < 0.001);
        QVERIFY(*anova.effects[2].p > 0.05);
    }
    void numbers_far_from_zero_lose_nothing() {
        auto values = chance(8, 6, 2);
        const std::vector<Factor> factors{{"a", {"1", "2"}}, {"b", {"1", "2", "3"}}};
        const auto near_zero = repeated_anova(means(factors, values));
        for (auto& one : values)
            for (double& value : one)
                value += 1e6;
        const auto far = repeated_anova(means(factors, values));
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(near(*far.effects[i].f / *near_zero.effects[i].f, 1.0, 1e-7));
    }
    void the_order_of_factors_and_participants_is_nothing() {
        const auto values = chance(5, 6, 11);
        auto turned = values;
        for (std::size_t i = 0; i < 5; ++i)
            for (std::size_t a = 0; a < 2; ++a)
                for (std::size_t b = 0; b < 3; ++b)
                    turned[4 - i][2 * b + a] = values[i][3 * a + b];
        const auto one = repeated_anova(means({{"a", {"1", "2"}}, {"b", {"1", "2", "3"}}}, values));
        const auto other = repeated_anova(means({{"b", {"1", "2", "3"}}, {"a", {"1", "2"}}}, turned));
        for (const auto& [i, j] : {std::pair(0U, 1U), std::pair(1U, 0U), std::pair(2U, 2U)}) {
            QVERIFY(near(*one.effects[i].f, *other.effects[j].f));
            QVERIFY(near(*one.effects[i].p_spherical, *other.effects[j].p_spherical));
        }
    }
    void differences_count_however_small_beside_the_numbers_and_in_whatever_unit() {
        const std::vector<Factor> factors{{"a", {"1", "2"}}, {"b", {"1", "2", "3"}}};
        const auto values = chance(8, 6, 2);
        const auto plain = repeated_anova(means(factors, values));
        for (const auto& [scale, offset] : {std::pair{1e-9, 1.0}, {1e-15, 0.0}, {1e15, 0.0}}) {
            auto others = values;
            for (auto& one : others)
                for (double& value : one)
                    value = offset + scale * value;
            const auto anova = repeated_anova(means(factors, others));
            for (std::size_t i = 0; i < 3; ++i)
                QVERIFY(anova.effects[i].f && near(*anova.effects[i].f / *plain.effects[i].f, 1.0, 1e-5));
        }
    }
    void two_participants_are_enough() {
        const auto anova = repeated_anova(means({{"a", {"1", "2"}}}, {{1, 2}, {2, 5}}));
        QVERIFY(anova.effects.front().f.has_value() && anova.remark.empty());
        QVERIFY(near(*anova.effects.front().f, 4.0)); // differences 1 and 3: t = 2 / (√2 / √2)
        QVERIFY(near(*anova.effects.front().p, 2.0 * std::atan2(1.0, 2.0) / std::acos(-1.0)));
        QVERIFY(repeated_anova(means({{"a", {"1", "2"}}}, {{1, 2}, {2, 5}, {0, 2}})).remark.empty());
    }
    void one_participant_is_said() {
        const auto anova = repeated_anova(means({{"a", {"1", "2"}}}, {{1, 2}}));
        QVERIFY(!anova.effects.front().f && !anova.effects.front().p && !anova.effects.front().epsilon);
        QCOMPARE(anova.remark, std::string("With one participant nothing can be said about others."));
    }
    void people_who_are_all_alike_are_said_and_nothing_is_no_number() {
        for (const auto& values :
             {std::vector<std::vector<double>>{{0.1, 0.7, 0.3}, {0.1, 0.7, 0.3}, {0.1, 0.7, 0.3}},
              {{0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}},
              {{0, 0, 0}, {0, 0, 0}},
              {{1e-3, 2e-3, 3e-3}, {1e6 + 1e-3, 1e6 + 2e-3, 1e6 + 3e-3}}}) {
            const auto anova = repeated_anova(means({{"a", {"1", "2", "3"}}}, values));
            QVERIFY(!anova.effects.front().f);
            QCOMPARE(anova.remark,
                     std::string("Where the participants do not differ at all there is nothing to "
                                 "weigh an effect against."));
            QVERIFY(!anova.effects.front().eta_squared || std::isfinite(*anova.effects.front().eta_squared));
        }
    }
    void fewer_participants_than_contrasts_still_have_an_epsilon() {
        const auto anova = repeated_anova(means({{"a", {"1", "2", "3", "4", "5"}}}, chance(3, 5, 1)));
        QVERIFY(*anova.effects.front().epsilon >= 0.25 &&
                *anova.effects.front().epsilon <= 0.5 + 1e-12); // rank 2 of 4
    }
};

} // namespace repeated_anova_test

TP_TEST(repeated_anova_test, RepeatedAnovaTest, nothing)
#include "repeated_anova_test.moc"
