// SPDX-License-Identifier: Apache-2.0
#include "core/statistics/pairwise.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pairwise_test {

using namespace tp;

namespace {

std::vector<LevelPair> differing(std::initializer_list<std::pair<std::size_t, std::size_t>> pairs) {
    std::vector<LevelPair> result;
    for (const auto& [one, other] : pairs)
        result.push_back({one, other, 1.0, 0.01});
    return result;
}

using Letters = std::vector<std::string>;

} // namespace

class PairwiseTest : public QObject {
    Q_OBJECT
private slots:
    void letters_of_levels_that_differ() {
        QCOMPARE(letter_groups(3, {}), (Letters{"a", "a", "a"}));
        QCOMPARE(letter_groups(3, differing({{0, 1}, {0, 2}, {1, 2}})), (Letters{"a", "b", "c"}));
        QCOMPARE(letter_groups(3, differing({{0, 2}})), (Letters{"a", "ab", "b"}));
        QCOMPARE(letter_groups(5, differing({{0, 2}, {0, 3}, {0, 4}, {1, 3}, {1, 4}, {2, 4}})),
                 (Letters{"a", "ab", "bc", "cd", "d"}));
    }
    /// Whatever pairs differ: two have a letter in common exactly where they do not.
    void letters_say_exactly_which_pairs_differ() {
        std::mt19937 random(4);
        for (int round = 0; round < 300; ++round) {
            const std::size_t count = 2 + random() % 6;
            std::vector<LevelPair> pairs;
            std::set<std::pair<std::size_t, std::size_t>> apart;
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t j = i + 1; j < count; ++j)
                    if (random() % 2 == 0) {
                        pairs.push_back({i, j, 1.0, 0.01});
                        apart.insert({i, j});
                    }
            const Letters letters = letter_groups(count, pairs);
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t j = i + 1; j < count; ++j)
                    QCOMPARE(letters[i].find_first_of(letters[j]) == std::string::npos,
                             apart.contains({i, j}));
        }
    }
    void levels_that_are_far_apart_have_letters_in_the_order_of_their_means() {
        WithinMeans means;
        means.factors = {{"size", {"2 cm", "5 cm", "8 cm"}}, {"path", {"circle", "square"}}};
        std::mt19937 random(1);
        std::normal_distribution<double> noise(0.0, 0.1);
        for (int i = 0; i < 8; ++i) {
            means.participants.push_back(std::to_string(i));
            const double own = 3.0 * noise(random);
            for (const double size : {9.0, 1.0, 1.02})
                for (const double path : {-2.0, 2.0})
                    means.values.push_back(size + path + own + noise(random));
        }
        const Pairwise sizes = tukey_hsd(means, 0);
        QCOMPARE(sizes.levels[0].letters, std::string("b"));
        QCOMPARE(sizes.levels[1].letters, std::string("a"));
        QCOMPARE(sizes.levels[2].letters, std::string("a"));
        QVERIFY(std::abs(sizes.levels[0].mean - 9.0) < 0.5); // over both paths
        QVERIFY(std::abs(sizes.pairs[0].difference + 8.0) < 0.5);
        QVERIFY(sizes.pairs[0].p < 1e-6 && sizes.pairs[2].p > 0.05);
        const Pairwise paths = tukey_hsd(means, 1);
        QCOMPARE(paths.levels[0].letters, std::string("a"));
        QCOMPARE(paths.levels[1].letters, std::string("b"));
        QVERIFY(std::abs(paths.levels[1].mean - paths.levels[0].mean - 4.0) < 0.2);
    }
    void two_levels_differ_where_p_is_below_a_twentieth() {
        WithinMeans means;
        means.factors = {{"law", {"exact", "published"}}};
        means.participants = {"1", "2", "3", "4"};
        means.values = {1, 2, 2, 4, 3, 6, 4, 5}; // a paired t test: p = 0.0354
        const Pairwise apart = tukey_hsd(means, 0);
        QVERIFY(std::abs(apart.pairs[0].p - 0.0353531) < 1e-6);
        QVERIFY(apart.levels[0].letters == "a" && apart.levels[1].letters == "b");
        means.values.back() = 4.5; // p = 0.061
        const Pairwise alike = tukey_hsd(means, 0);
        const double p = alike.pairs[0].p;
        QVERIFY(p > 0.055 && p < 0.07);
        QVERIFY(alike.levels[0].letters == "a" && alike.levels[1].letters == "a");
        QCOMPARE(tukey_hsd(means, 0, p).levels[1].letters, std::string("a"));
        QCOMPARE(tukey_hsd(means, 0, std::nextafter(p, 1.0)).levels[1].letters, std::string("b"));
    }
    void the_standard_error_is_that_of_the_participants_means_over_the_other_factors() {
        WithinMeans means;
        means.factors = {{"a", {"1", "2"}}, {"b", {"1", "2"}}};
        means.participants = {"1", "2", "3"};
        means.values = {0, 2, 5, 5, 1, 3,
                        5, 7, 3, 3, 4, 9}; // at the first level 1, 2, 3; at the second 5, 6, 6.5
        const Pairwise pairwise = tukey_hsd(means, 0);
        QCOMPARE(pairwise.levels[0].mean, 2.0);
        QVERIFY(std::abs(*pairwise.levels[0].standard_error - 1.0 / std::sqrt(3.0)) < 1e-12);
        QVERIFY(std::abs(*pairwise.levels[1].standard_error - 0.44095855184409843) < 1e-12); // √(7/12 / 3)
    }
    void one_participant_and_people_who_are_all_alike_have_means_and_no_letters() {
        WithinMeans means;
        means.factors = {{"a", {"1", "2", "3"}}};
        means.participants = {"1"};
        means.values = {1, 2, 3};
        const Pairwise alone = tukey_hsd(means, 0);
        QCOMPARE(alone.levels[1].mean, 2.0);
        QVERIFY(!alone.levels[1].standard_error && alone.pairs.empty() && alone.levels[1].letters.empty());
        means.participants = {"1", "2"};
        means.values = {1, 2, 3, 1, 2, 3};
        const Pairwise alike = tukey_hsd(means, 0);
        QVERIFY(alike.levels[1].standard_error.has_value());
        QCOMPARE(*alike.levels[1].standard_error, 0.0);
        QVERIFY(alike.pairs.empty());
    }
};

} // namespace pairwise_test

TP_TEST(pairwise_test, PairwiseTest, nothing)
#include "pairwise_test.moc"
