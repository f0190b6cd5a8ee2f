// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/trial_table.hpp"
#include "corpus.hpp"
#include "experiment_check.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <random>
#include <set>
#include <string>

namespace trial_table_test {

using namespace tp;
using namespace tp::test;

namespace {

TrialRecord record() {
    TrialRecord one;
    one.participant = 7;
    one.trial = 12;
    one.repetition = 2;
    one.condition = 3;
    one.time_s = 7.25;
    one.answer = "square";
    one.seed = 18446744073709551615U;
    return one;
}

const std::string columns = "experiment,participant,trial,repetition,training,shape,radius,error_mm,time_s,"
                            "answer,correct,repeated,seed\n";
const std::string line = "small,7,12,2,no,square,50,,7.25,square,yes,no,18446744073709551615\n";

} // namespace

class TrialTableTest : public QObject {
    Q_OBJECT
private slots:
    void a_trial_is_a_line_under_columns_with_its_factors() {
        QCOMPARE(trial_columns(small_experiment()), columns);
        QCOMPARE(trial_line(small_experiment(), record()), line);
        TrialRecord followed = record();
        followed.error_mm = 1.0 / 3.0;
        followed.answer.clear();
        followed.repeated = followed.training = true;
        QCOMPARE(
            trial_line(small_experiment(), followed),
            std::string("small,7,12,2,yes,square,50,0.3333333333333333,7.25,,no,yes,18446744073709551615\n"));
        for (const TrialRecord& one : {record(), followed}) {
            const auto table = read_trials(small_experiment(), columns + trial_line(small_experiment(), one));
            QVERIFY2(table.ok(), table.error().c_str());
            QCOMPARE(table->records, std::vector<TrialRecord>{one});
            QVERIFY(!table->torn);
        }
    }
    void no_answer_and_a_wrong_one_are_not_right() {
        TrialRecord one = record();
        QVERIFY(is_right(small_experiment(), one));
        one.answer = "circle";
        QVERIFY(!is_right(small_experiment(), one));
        one.answer.clear();
        QVERIFY(!is_right(small_experiment(), one));
    }
    /// A program that was killed while it wrote: at each byte.
    void a_line_that_was_being_written_is_left_out() {
        for (std::size_t cut = 1; cut < line.size(); ++cut) {
            const auto table = read_trials(small_experiment(), columns + line + line.substr(0, cut));
            QVERIFY2(table.ok(), table.error().c_str());
            QCOMPARE(table->records.size(), std::size_t{1});
            QVERIFY(table->torn);
        }
    }
    void what_a_spreadsheet_has_written_is_read() {
        const auto table = read_trials(
            small_experiment(), columns.substr(0, columns.size() - 1) + "\r\n" +
                                    "\"small\",\"7\",12,2,\"no\",\"square\",50,,7.25,square,yes,no,1\r\n");
        QVERIFY2(table.ok(), table.error().c_str());
        QCOMPARE(table->records.front().condition, std::size_t{3});
    }
    void what_is_wrong_is_said_with_its_line_data() {
        QTest::addColumn<QString>("bad");
        QTest::addColumn<QString>("said");
        QTest::newRow("cells") << "small,7"
                               << "has another number of cells than there are columns";
        QTest::newRow("quotation mark") << "\"small"
                                        << "has another number of cells than there are columns";
        QTest::newRow("experiment") << "other,7,12,2,no,square,50,,7.25,square,yes,no,1"
                                    << "is of another experiment";
        QTest::newRow("participant") << "small,Anna,12,2,no,square,50,,7.25,square,yes,no,1"
                                     << "has no participant";
        QTest::newRow("level") << "small,7,12,2,no,square,51,,7.25,square,yes,no,1"
                               << "has a radius that the experiment does not know";
        QTest::newRow("error") << "small,7,12,2,no,square,50,-1,7.25,square,yes,no,1"
                               << "has an error that is no distance";
        QTest::newRow("nan") << "small,7,12,2,no,square,50,nan,7.25,square,yes,no,1"
                             << "has an error that is no distance";
        QTest::newRow("time") << "small,7,12,2,no,square,50,,inf,square,yes,no,1"
                              << "has no time";
        QTest::newRow("answer") << "small,7,12,2,no,square,50,,7.25,star,yes,no,1"
                                << "has an answer that nobody could give";
        QTest::newRow("repeated") << "small,7,12,2,no,square,50,,7.25,square,yes,,1"
                                  << "does not say whether it was repeated";
        QTest::newRow("seed") << "small,7,12,2,no,square,50,,7.25,square,yes,no,-1"
                              << "has no seed";
    }
    void what_is_wrong_is_said_with_its_line() {
        QFETCH(QString, bad);
        QFETCH(QString, said);
        QCOMPARE(QString::fromStdString(
                     read_trials(small_experiment(), columns + line + bad.toStdString() + "\n").error()),
                 "Line 3 of the table of trials " + said + ".");
    }
    void another_experiments_table_is_refused() {
        QCOMPARE(read_trials(small_experiment(), "a,b\n").error(),
                 std::string("The table of trials is not one of this experiment: its columns are others."));
        QCOMPARE(read_trials(small_experiment(), "").error(), std::string("The table of trials is empty."));
    }
    void of_the_fuzzer_s_corpus_only_what_is_whole_is_read() {
        const std::set<std::string> whole{
            "two_trials",  "no_trials", "no_trials_and_no_end", "torn", "ends_of_another_system",
            "fifty_trials"};
        for (const Seed& seed : corpus(in_source("tests/core/experiment/trial_corpus"))) {
            QCOMPARE(complaint_about_trials(seed.text), std::string());
            QVERIFY2(read_trials(small_experiment(), seed.text).ok() == whole.contains(seed.name),
                     seed.name.c_str());
        }
    }
    void any_bytes_are_refused_in_a_sentence() {
        std::mt19937 random(3);
        for (int round = 0; round < 5000; ++round) {
            std::string text = columns + line + line;
            for (std::size_t change = 1 + random() % 3; change > 0; --change)
                text[random() % text.size()] =
                    random() % 3 == 0 ? static_cast<char>(random() % 256) : ",\"\n0.e-yn"[random() % 9];
            QCOMPARE(complaint_about_trials(text), std::string());
        }
    }
};

} // namespace trial_table_test

TP_TEST(trial_table_test, TrialTableTest, nothing)
#include "trial_table_test.moc"
