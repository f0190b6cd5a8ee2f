// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/experiment_file.hpp"
#include "core/experiment/trial_order.hpp"
#include "core/experiment/trial_table.hpp"
#include "core/files/whole_file.hpp"
#include "experiment_check.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <random>
#include <set>
#include <string>

namespace experiment_file_test {

using namespace tp;
using namespace tp::test;

namespace {

constexpr const char* least = "experiment: a\ntask: follow\nfactor range: 2, 4 mm\n";

Experiment shipped(const std::string& name) {
    const auto text =
        read_whole(in_source(("resources/studies/" + name + ".study").c_str()), most_experiment_bytes);
    const auto experiment = read_experiment(text ? *text : std::string());
    if (!experiment)
        qFatal("%s: %s", name.c_str(), experiment.error().c_str());
    return *experiment;
}

} // namespace

class ExperimentFileTest : public QObject {
    Q_OBJECT
private slots:
    /// As Lim, Yoo and Choi (2019) say it.
    void the_published_experiments_have_the_published_trials() {
        const Experiment tracking = shipped("tracking");
        QCOMPARE(tracking.trials(), std::size_t{5 * 5 * 3 * 2});
        QVERIFY(tracking.task == StudyTask::follow && !tracking.answer &&
                tracking.order == StudyOrder::random);
        QCOMPARE(level_words(tracking.factors[0], 4), std::string("0.5 N/mm"));
        QCOMPARE(level_words(tracking.factors[2], 1), std::string("triangle"));
        const Experiment primitives = shipped("primitives");
        QCOMPARE(primitives.trials(), std::size_t{45});
        QCOMPARE(primitives.repetitions, 3);
        const Experiment expressions = shipped("expressions");
        QCOMPARE(expressions.trials(), std::size_t{16});
        QCOMPARE(*expressions.longest_trial_s, 60.0);
        QVERIFY(*expressions.answer == StudyParameter::expression);
        QCOMPARE(shipped("laws-tracking").trials(), std::size_t{2 * 3 * 6});
        QCOMPARE(shipped("laws-expressions").trials(), std::size_t{32});
    }
    /// Lim, Yoo and Choi (2019): Experiments I and II by Eq. 1, III by Algorithm 1; I with K = 0.1 to 0.5 N/mm and d = 2 to 10 mm, II and
    /// III with K = 0.2 N/mm and d = 4 mm; II with circumscribed circles of radius 2, 5 and 8 cm.
    void the_published_experiments_have_the_published_guidance() {
        const auto values = [](const char* name, StudyParameter parameter) {
            const Experiment experiment = shipped(name);
            std::set<std::string> all;
            for (std::size_t condition = 0; condition < experiment.conditions(); ++condition)
                all.insert(experiment.value_of(parameter, condition));
            return all;
        };
        using Values = std::set<std::string>;
        const auto is = [&](const char* name, StudyParameter parameter, const Values& published) {
            QCOMPARE(values(name, parameter), published);
        };
        is("tracking", StudyParameter::law, {"exact"});
        is("tracking", StudyParameter::stiffness, {"0.1", "0.2", "0.3", "0.4", "0.5"});
        is("tracking", StudyParameter::range, {"2", "4", "6", "8", "10"});
        is("primitives", StudyParameter::law, {"exact"});
        is("primitives", StudyParameter::radius, {"20", "50", "80"});
        is("expressions", StudyParameter::law, {"published"});
        for (const char* const name : {"laws-tracking", "laws-expressions"})
            is(name, StudyParameter::law, {"exact", "published"});
        for (const char* const name : {"primitives", "expressions", "laws-tracking", "laws-expressions"}) {
            is(name, StudyParameter::stiffness, {"0.2"});
            is(name, StudyParameter::range, {"4"});
        }
    }
    /// The same: a straight line (I); a straight, a broken and a curved line, about a minute (II); four faces that are not asked later (III).
    void the_published_experiments_are_trained_as_published() {
        const auto trained = [](const char* name, StudyParameter parameter) {
            const Experiment experiment = shipped(name), training = experiment.in_training();
            std::multiset<std::string> all;
            for (const PlannedTrial& planned : trials_of(experiment, 3, 5))
                if (planned.training)
                    all.insert(training.value_of(parameter, planned.condition));
            return all;
        };
        using Values = std::multiset<std::string>;
        QCOMPARE(trained("tracking", StudyParameter::path), (Values{"line", "line", "line"}));
        QCOMPARE(trained("primitives", StudyParameter::shape), (Values{"line", "broken-line", "curve"}));
        const Experiment primitives = shipped("primitives");
        QCOMPARE(primitives.training * primitives.longest_training_s.value(), 60.0);
        QVERIFY(!primitives.asks(true) && primitives.asks(false));
        QCOMPARE(trained("expressions", StudyParameter::expression),
                 (Values{"smiling", "surprised", "sad", "angry"}));
        QVERIFY(shipped("expressions").asks(true));
        for (const char* const name : {"expressions", "laws-expressions"}) {
            const Experiment experiment = shipped(name);
            for (std::size_t condition = 0; condition < experiment.conditions(); ++condition)
                QVERIFY(!trained(name, StudyParameter::face)
                             .contains(experiment.value_of(StudyParameter::face, condition)));
        }
    }
    void training_has_its_own_levels_in_place_of_a_factor_s() {
        const Experiment experiment =
            read_experiment("experiment: a\ntask: name\nanswer: shape\nfactor shape: circle, square\n"
                            "factor radius: 20, 50 mm\ntraining: 4\ntraining shape: line, square\n"
                            "training radius: 30 mm\nlongest training: 9 s\n")
                .value();
        const Experiment training = experiment.in_training();
        QCOMPARE(training.conditions(), std::size_t{2});
        QCOMPARE(training.value_of(StudyParameter::shape, 1), std::string("square"));
        QCOMPARE(training.value_of(StudyParameter::radius, 1), std::string("30"));
        QCOMPARE(experiment.conditions(), std::size_t{4});
        QVERIFY(!experiment.asks(true)); // a line is no answer
        QCOMPARE(*experiment.longest_training_s, 9.0);
        QCOMPARE(complaint_about_experiment(experiment_text(experiment)), std::string());
        const TrialRecord record{1, 1, 1, true, 0, {}, 4.0, "", false, 7};
        const std::string line = trial_line(experiment, record);
        QCOMPARE(line, std::string("a,1,1,1,yes,line,30,,4,,,no,7\n"));
        QCOMPARE(read_trials(experiment, trial_columns(experiment) + line)->records.front(), record);
        const auto counted =
            read_trials(experiment, trial_columns(experiment) + "a,1,1,1,no,line,20,,4,,,no,7\n");
        QVERIFY2(counted.error().find("has a shape that the experiment does not know") != std::string::npos,
                 counted.error().c_str());
    }
    void what_is_shipped_is_the_same_again_when_it_was_written() {
        for (const char* const name :
             {"tracking", "primitives", "expressions", "laws-tracking", "laws-expressions"})
            QCOMPARE(complaint_about_experiment(experiment_text(shipped(name))), std::string());
    }
    void a_condition_has_its_levels_and_values() {
        const Experiment small = small_experiment();
        QCOMPARE(small.conditions(), std::size_t{4});
        QCOMPARE(small.levels_of(2), (std::vector<std::size_t>{1, 0}));
        QCOMPARE(small.value_of(StudyParameter::shape, 2), std::string("square"));
        QCOMPARE(small.value_of(StudyParameter::radius, 1), std::string("50"));
        QCOMPARE(small.value_of(StudyParameter::law, 1), std::string());
    }
    void numbers_are_kept_in_one_form() {
        const auto experiment =
            read_experiment("experiment: a\ntask: follow\nfactor stiffness: 0.10,5e-1 N/mm\r\n");
        QVERIFY2(experiment.ok(), experiment.error().c_str());
        QCOMPARE(experiment->factors[0].levels, (std::vector<std::string>{"0.1", "0.5"}));
    }
    void what_is_wrong_is_said_with_its_line_data() {
        QTest::addColumn<QString>("added");
        QTest::addColumn<QString>("said");
        QTest::newRow("no colon") << "words"
                                  << "Line 4 of the experiment has no colon.";
        QTest::newRow("unknown") << "colour: red"
                                 << "Line 4 of the experiment is not understood.";
        QTest::newRow("unknown parameter") << "factor stifness: 1, 2 N/mm"
                                           << "Line 4 of the experiment speaks of what is no parameter.";
        QTest::newRow("no unit") << "factor stiffness: 0.1, 0.2"
                                 << "Line 4 of the experiment needs its unit at the end, N/mm.";
        QTest::newRow("other unit") << "factor radius: 2, 8 cm"
                                    << "Line 4 of the experiment needs its unit at the end, mm.";
        QTest::newRow("too strong") << "factor stiffness: 0.1, 20 N/mm"
                                    << "Line 4 of the experiment needs numbers from 0.01 to 2.";
        QTest::newRow("no number") << "factor stiffness: nan, 0.2 N/mm"
                                   << "Line 4 of the experiment needs numbers from 0.01 to 2.";
        QTest::newRow("one level twice") << "factor stiffness: 0.1, 0.10 N/mm"
                                         << "Line 4 of the experiment has 0.1 twice.";
        QTest::newRow("one level") << "factor stiffness: 0.1 N/mm"
                                   << "Line 4 of the experiment needs at least two values.";
        QTest::newRow("two settings") << "set stiffness: 0.1, 0.2 N/mm"
                                      << "Line 4 of the experiment sets more than one value.";
        QTest::newRow("unknown word") << "factor law: exact, other"
                                      << "Line 4 of the experiment knows only exact, published.";
        QTest::newRow("said twice") << "task: follow"
                                    << "Line 4 of the experiment says it a second time.";
        QTest::newRow("a factor that is set") << "set range: 4 mm"
                                              << "The experiment speaks twice of range.";
        QTest::newRow("half a repetition") << "repetitions: 2.5"
                                           << "Line 4 of the experiment needs a whole number from 1 to 100.";
        QTest::newRow("an answer without a question") << "answer: range"
                                                      << "Where a contour is followed there is no answer.";
        QTest::newRow("a short trial") << "longest trial: 0 s"
                                       << "Line 4 of the experiment needs seconds from 1 to 3600: 60 s.";
        QTest::newRow("a strip") << "surface: 200 x 1 mm"
                                 << "Line 4 of the experiment needs sides from 20 to 1000 mm.";
        QTest::newRow("training of what does not vary")
            << "training path: line"
            << "The path can be another in training only where it is a factor.";
        QTest::newRow("training said twice") << "training range: 8 mm\ntraining range: 9 mm"
                                             << "Line 5 of the experiment says it a second time.";
        QTest::newRow("no order") << "order: as I like"
                                  << "Line 4 of the experiment needs random or latin-square.";
    }
    void what_is_wrong_is_said_with_its_line() {
        QFETCH(QString, added);
        QFETCH(QString, said);
        QVERIFY(read_experiment(least).ok());
        QCOMPARE(QString::fromStdString(read_experiment(least + added.toStdString()).error()), said);
    }
    void what_is_missing_is_said() {
        for (const char* const text : {"", "experiment: a\nfactor range: 1, 2 mm\n"})
            QCOMPARE(read_experiment(text).error(),
                     std::string("The experiment does not say what is done: a line "
                                 "\"task: follow\" or \"task: name\" is missing."));
        QCOMPARE(read_experiment("task: follow\n").error(),
                 std::string("The experiment has no name: a line \"experiment: NAME\" is missing."));
        QCOMPARE(read_experiment("task: follow\nexperiment: a\n").error(),
                 std::string("The experiment varies nothing: a line \"factor …\" is missing."));
        QCOMPARE(
            read_experiment("task: name\nexperiment: a\nfactor range: 1, 2 mm\n").error(),
            std::string("The experiment does not say what is to be named: a line \"answer: …\" is missing."));
        QCOMPARE(read_experiment("task: name\nexperiment: a\nanswer: shape\nfactor range: 1, 2 mm\n").error(),
                 std::string("What is to be named must be a factor."));
    }
    void nobody_can_be_asked_for_a_year() {
        std::string many = "experiment: a\ntask: follow\nrepetitions: 100\nfactor face: 1";
        for (int i = 2; i <= 101; ++i)
            many += "," + std::to_string(i);
        QCOMPARE(read_experiment(many).error(), std::string("The experiment has more than 10000 trials."));
        QCOMPARE(read_experiment(std::string(most_experiment_bytes + 1, '\n')).error(),
                 std::string("The experiment is longer than 64 KB."));
    }
    void any_bytes_are_refused_in_a_sentence() {
        std::mt19937 random(7);
        const std::string whole = experiment_text(shipped("primitives"));
        for (int round = 0; round < 3000; ++round) {
            std::string text = whole;
            for (std::size_t change = 1 + random() % 4; change > 0; --change) {
                const std::size_t place = random() % text.size();
                if (random() % 3 == 0)
                    text.erase(place, 1 + random() % 20);
                else
                    text[place] = static_cast<char>(random() % 256);
                if (text.empty())
                    break;
            }
            QCOMPARE(complaint_about_experiment(text), std::string());
        }
    }
};

} // namespace experiment_file_test

TP_TEST(experiment_file_test, ExperimentFileTest, nothing)
#include "experiment_file_test.moc"
