// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/experiment_file.hpp"
#include "core/experiment/trial_order.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <map>
#include <set>

namespace trial_order_test {

using namespace tp;

namespace {

Experiment experiment(const std::string& order) {
    return read_experiment(
               "experiment: a\ntask: follow\nfactor range: 2, 4, 6 mm\nfactor path: circle, curve\n"
               "repetitions: 3\ntraining: 8\norder: " +
               order + "\n")
        .value();
}

std::vector<std::size_t> conditions(const std::vector<PlannedTrial>& trials) {
    std::vector<std::size_t> all;
    for (const PlannedTrial& trial : trials)
        all.push_back(trial.condition);
    return all;
}

} // namespace

class TrialOrderTest : public QObject {
    Q_OBJECT
private slots:
    void each_condition_comes_as_often_as_it_should_after_the_training() {
        for (const char* const order : {"random", "latin-square"}) {
            const auto trials = trials_of(experiment(order), 4, 1);
            QCOMPARE(trials.size(), std::size_t{8 + 18});
            std::map<std::pair<std::size_t, int>, int> times;
            for (std::size_t i = 0; i < trials.size(); ++i) {
                QCOMPARE(trials[i].training, i < 8);
                if (!trials[i].training)
                    ++times[{trials[i].condition, trials[i].repetition}];
            }
            QCOMPARE(times.size(), std::size_t{18});
        }
    }
    void the_same_numbers_give_the_same_order_and_others_another() {
        const Experiment random = experiment("random");
        QCOMPARE(trials_of(random, 3, 7), trials_of(random, 3, 7));
        QVERIFY(trials_of(random, 3, 7) != trials_of(random, 4, 7));
        QVERIFY(trials_of(random, 3, 7) != trials_of(random, 3, 8));
        QVERIFY(conditions(trials_of(random, 3, 7)) != conditions(trials_of(random, 4, 7)));
    }
    /// What was recorded with a study must lead to the same trials on another computer and in years.
    void an_order_that_was_given_stays() {
        const auto trials = trials_of(experiment("random"), 1, 1);
        QCOMPARE(conditions(trials), (std::vector<std::size_t>{4, 2, 5, 3, 0, 1, 4, 2, 1, 3, 4, 0, 3,
                                                               0, 1, 2, 0, 4, 5, 1, 5, 4, 2, 5, 3, 2}));
        QCOMPARE(trials.front().seed, std::uint64_t{16444145387650486336U});
    }
    void every_condition_is_first_about_as_often() {
        std::map<std::size_t, int> first;
        for (int participant = 1; participant <= 6000; ++participant)
            ++first[trials_of(experiment("random"), participant, 2)[8].condition];
        for (std::size_t condition = 0; condition < 6; ++condition)
            QVERIFY2(std::abs(first[condition] - 1000) < 120,
                     qPrintable(QString::number(first[condition]))); // 4 sigma
    }
    void two_trials_have_two_seeds() {
        std::set<std::uint64_t> seeds;
        for (int participant = 1; participant <= 20; ++participant)
            for (const PlannedTrial& trial : trials_of(experiment("random"), participant, 2))
                seeds.insert(trial.seed);
        QCOMPARE(seeds.size(), std::size_t{20 * 26});
    }
    void a_latin_square_is_balanced_data() {
        QTest::addColumn<int>("count");
        for (const int count : {2, 3, 4, 5, 6, 7, 12, 15})
            QTest::newRow(std::to_string(count).c_str()) << count;
    }
    void a_latin_square_is_balanced() {
        QFETCH(int, count);
        const auto conditions = static_cast<std::size_t>(count);
        const std::size_t rows = conditions % 2 == 0 ? conditions : 2 * conditions;
        std::map<std::pair<std::size_t, std::size_t>, std::size_t> at, after;
        for (std::size_t row = 0; row < rows; ++row) {
            const auto order = latin_row(conditions, row);
            QCOMPARE(std::set<std::size_t>(order.begin(), order.end()).size(), conditions);
            for (std::size_t i = 0; i < conditions; ++i) {
                ++at[{order[i], i}];
                if (i > 0)
                    ++after[{order[i - 1], order[i]}];
            }
        }
        QCOMPARE(at.size(), conditions * conditions);
        QCOMPARE(after.size(), conditions * (conditions - 1));
        const std::size_t often = rows / conditions;
        for (const auto& times : {at, after})
            for (const auto& [which, number] : times)
                QCOMPARE(number, often);
    }
    void repetitions_of_a_latin_square_are_other_rows() {
        const auto trials = trials_of(experiment("latin-square"), 2, 1);
        for (std::size_t repetition = 0; repetition < 3; ++repetition)
            for (std::size_t i = 0; i < 6; ++i)
                QCOMPARE(trials[8 + 6 * repetition + i].condition, latin_row(6, 1 + repetition)[i]);
    }
};

} // namespace trial_order_test

TP_TEST(trial_order_test, TrialOrderTest, nothing)
#include "trial_order_test.moc"
