// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/next_trial.hpp"
#include "core/experiment/split_mix.hpp"
#include "experiment_check.hpp"
#include "test_program.hpp"

#include <QTest>

#include <set>

namespace next_trial_test {

using namespace tp;
using namespace tp::test;

namespace {

/// 4 conditions, twice each, and one trial of training.
Experiment with_breaks(int between) {
    Experiment experiment = small_experiment();
    experiment.trials_between_breaks = between;
    return experiment;
}

struct Person {
    Experiment experiment = with_breaks(3);
    std::vector<PlannedTrial> plan = trials_of(experiment, 4, 9);
    std::vector<TrialRecord> records;

    std::optional<NextTrial> next() const { return next_trial(experiment, plan, records); }
    void does(bool repeated = false) {
        TrialRecord record = begun_record(next().value(), 4);
        record.repeated = repeated;
        records.push_back(record);
    }
    std::optional<int> unplanned() const { return first_unplanned(experiment, plan, records); }
};

} // namespace

class NextTrialTest : public QObject {
    Q_OBJECT
private slots:
    void a_person_does_the_plan_from_its_first_trial_to_its_last() {
        Person person;
        QCOMPARE(person.plan.size(), std::size_t{9});
        for (std::size_t i = 0; i < person.plan.size(); ++i) {
            const auto next = person.next();
            QVERIFY(next.has_value());
            QCOMPARE(next->planned, person.plan[i]);
            QCOMPARE(next->number, static_cast<int>(i) + 1);
            QCOMPARE(next->attempts, 0);
            QCOMPARE(next->left, person.plan.size() - i);
            person.does();
        }
        QVERIFY(!person.next());
        QVERIFY(!person.unplanned());
    }
    /// Before it is done again the shape lies elsewhere, and the number of the trial is a new one.
    void a_trial_that_went_wrong_comes_again_at_once_with_another_seed() {
        Person person;
        person.does();
        std::set<std::uint64_t> seeds;
        for (int attempt = 0; attempt < 5; ++attempt) {
            const NextTrial next = person.next().value();
            QCOMPARE(next.planned.condition, person.plan[1].condition);
            QCOMPARE(next.planned.repetition, person.plan[1].repetition);
            QCOMPARE(next.attempts, attempt);
            QCOMPARE(next.number, 2 + attempt);
            QCOMPARE(next.left, std::size_t{8});
            QCOMPARE(next, person.next().value());
            seeds.insert(next.planned.seed);
            person.does(true);
        }
        QCOMPARE(seeds.size(), std::size_t{5});
        QVERIFY(seeds.contains(person.plan[1].seed));
        person.does();
        QCOMPARE(person.next()->planned, person.plan[2]);
        QCOMPARE(person.next()->number, 8);
        QVERIFY(!person.unplanned());
    }
    void the_last_trial_can_go_wrong_too() {
        Person person;
        while (person.next()->left > 1)
            person.does();
        person.does(true);
        QCOMPARE(person.next()->left, std::size_t{1});
        person.does();
        QVERIFY(!person.next());
    }
    /// Training does not tire; a trial that went wrong brings no break, and takes none away.
    void a_break_is_due_after_as_many_counted_trials_as_the_experiment_says() {
        Person person;
        std::vector<bool> due;
        while (const auto next = person.next()) {
            due.push_back(next->break_due);
            const bool wrong = next->number == 5; // right after the first break
            person.does(wrong);
        }
        //                                   training, 1st …                  again
        QCOMPARE(due,
                 (std::vector<bool>{false, false, false, false, true, false, false, false, true, false}));
    }
    void without_breaks_none_is_due() {
        Person person;
        person.experiment = with_breaks(0);
        for (; person.next(); person.does())
            QVERIFY(!person.next()->break_due);
    }
    void a_trial_begins_with_all_that_is_planned() {
        Person person;
        person.does();
        person.does();
        const TrialRecord record = begun_record(person.next().value(), 4);
        QCOMPARE(record.participant, 4);
        QCOMPARE(record.trial, 3);
        QCOMPARE(record.repetition, person.plan[2].repetition + 1);
        QCOMPARE(record.condition, person.plan[2].condition);
        QCOMPARE(record.seed, person.plan[2].seed);
        QVERIFY(!record.training && !record.repeated && record.answer.empty() && !record.error_mm);
        QVERIFY(person.records[0].training);
    }
    void what_was_not_planned_is_found_data() {
        QTest::addColumn<int>("which");
        for (int which = 0; which < 6; ++which)
            QTest::addRow("%d", which) << which;
    }
    void what_was_not_planned_is_found() {
        QFETCH(int, which);
        Person person;
        for (int i = 0; i < 5; ++i)
            person.does(i == 2);
        QVERIFY(!person.unplanned());
        TrialRecord& record = person.records[3];
        const int number = which == 4 ? 40 : record.trial;
        switch (which) {
        case 0:
            record.condition = (record.condition + 1) % 4;
            break;
        case 1:
            record.seed ^= 1;
            break;
        case 2:
            record.repetition = 3 - record.repetition;
            break;
        case 3:
            record.training = true;
            break;
        case 4:
            record.trial = 40;
            break;
        default:
            person.records.erase(person.records.begin() + 2); // the attempt before is missing
        }
        QCOMPARE(person.unplanned(), std::optional(number));
    }
    /// Each attempt has the next number of SplitMix64 from the trial's own seed. A table of a hundred thousand is looked at
    /// in one go, not again from the start for each line.
    void a_trial_may_be_done_again_a_hundred_thousand_times() {
        Person person;
        person.does();
        SplitMix seeds(person.plan[1].seed);
        person.does(true);
        TrialRecord record = person.records.back();
        while (record.trial < 100'000) {
            ++record.trial;
            record.seed = seeds.next();
            person.records.push_back(record);
        }
        QVERIFY(!person.unplanned());
        QCOMPARE(person.next()->planned.seed, seeds.next());
        person.records.back().repeated = false;
        QCOMPARE(person.next()->planned, person.plan[2]);
        person.records.back().seed ^= 1;
        QCOMPARE(person.unplanned(), std::optional(100'000));
    }
    /// Of two trials that go wrong, the second does not go on with the numbers of the first.
    void each_trial_has_seeds_of_its_own() {
        Person one, other;
        one.does(true);
        one.does();
        one.does(true);
        other.does();
        other.does(true);
        QCOMPARE(one.next()->planned, other.next()->planned);
    }
    void a_trial_after_the_last_is_not_planned() {
        Person person;
        while (person.next())
            person.does();
        TrialRecord more = person.records.back();
        more.trial = 10;
        person.records.push_back(more);
        QCOMPARE(person.unplanned(), std::optional(10));
    }
};

} // namespace next_trial_test

TP_TEST(next_trial_test, NextTrialTest, nothing)
#include "next_trial_test.moc"
