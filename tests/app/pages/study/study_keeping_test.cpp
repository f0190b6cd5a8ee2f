// SPDX-License-Identifier: Apache-2.0
// A study's folder behind the page: read, opened, written, let go, one thing after the other.
#include "app/pages/study/study_keeping.hpp"
#include "core/experiment/experiment_file.hpp"
#include "core/experiment/next_trial.hpp"
#include "core/experiment/trial_order.hpp"
#include "core/study_folder/path_file.hpp"
#include "test_program.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace study_keeping_test {

using namespace tp;
using Known = StudyKeeping::Known;
namespace fs = std::filesystem;

namespace {

const Experiment& shapes(int repetitions = 2) {
    static const auto of = [](const char* times) {
        return *read_experiment(
            "experiment: shapes\ntask: name\nfactor shape: circle, square\nanswer: shape\n" +
            std::string("repetitions: ") + times + "\n");
    };
    static const Experiment two = of("2"), three = of("3");
    return repetitions == 2 ? two : three;
}

struct Bench {
    QTemporaryDir folder;
    std::unique_ptr<StudyKeeping> keeping = std::make_unique<StudyKeeping>();

    fs::path study() const { return fs::path(folder.path().toStdString()) / "shapes"; }
    StudyKeeping::Sitting sitting(int participant = 1, std::uint64_t seed = 7) const {
        return {study(), shapes(), participant, seed, {"2026-11-26", "touchphoto test", "mouse", ""}};
    }
    /// What is answered, on this thread.
    Known answer(const std::function<void(StudyKeeping::Then)>& ask) const {
        Known known;
        bool answered = false;
        ask([&](const Known& what) {
            known = what;
            answered = QThread::currentThread() == QCoreApplication::instance()->thread();
        });
        [&] { QTRY_VERIFY_WITH_TIMEOUT(answered, 60000); }();
        return known;
    }
    Known look(int participant = 1, const Experiment& experiment = shapes()) const {
        return answer([&](StudyKeeping::Then then) {
            keeping->look(study(), experiment, participant, std::move(then));
        });
    }
    Known open(const StudyKeeping::Sitting& sitting) const {
        return answer([&](StudyKeeping::Then then) { keeping->open(sitting, std::move(then)); });
    }
    /// What is the participant's next after those trials, answered with a circle.
    static TrialRecord next(const std::vector<TrialRecord>& done, int participant = 1,
                            std::uint64_t seed = 7) {
        TrialRecord record =
            begun_record(*next_trial(shapes(), trials_of(shapes(), participant, seed), done), participant);
        record.answer = "circle";
        record.time_s = 1.99;
        return record;
    }
    static std::vector<FingerSample> path() {
        std::vector<FingerSample> path;
        for (int i = 0; i < 200; ++i)
            path.push_back({i * 0.01, i * 0.1, -1.0, 0.25, -0.5});
        return path;
    }
    QString keep(const TrialRecord& record) const {
        QString problem = "none answered";
        bool answered = false;
        keeping->keep(record, path(), [&](const QString& what) {
            problem = what;
            answered = true;
        });
        [&] { QTRY_VERIFY_WITH_TIMEOUT(answered, 60000); }();
        return problem;
    }
};

} // namespace

class StudyKeepingTest : public QObject {
    Q_OBJECT
private slots:
    void where_nothing_lies_the_study_begins_and_looking_writes_nothing() {
        Bench bench;
        const Known known = bench.look();
        QVERIFY(!known.seed && known.records.empty());
        QCOMPARE(known.next_participant, 1);
        QCOMPARE(known.problem + known.notice, QString());
        QVERIFY(!fs::exists(bench.study()));
    }

    void a_trial_and_its_path_are_on_the_disk_when_that_is_told() {
        Bench bench;
        const Known opened = bench.open(bench.sitting());
        QCOMPARE(opened.problem, QString());
        QVERIFY(opened.seed == std::uint64_t(7) && opened.records.empty());
        const TrialRecord record = Bench::next({});
        QCOMPARE(bench.keep(record), QString());
        const auto study = read_study(bench.study());
        QVERIFY(study && study->records == std::vector{record});
        QCOMPARE(study->sittings.at(0).machine.software, std::string("touchphoto test"));
        const auto path = read_path(bench.study() / study_paths_folder / path_file_name(1, record.trial));
        QVERIFY(path && path->size() == Bench::path().size());
        QCOMPARE(bench.keep(Bench::next({record})), QString());
        QCOMPARE(read_study(bench.study())->records.size(), std::size_t(2));
    }

    void who_goes_on_has_the_study_s_seed_and_their_own_trials() {
        Bench bench;
        bench.open(bench.sitting());
        const TrialRecord record = Bench::next({});
        bench.keep(record);
        bench.keeping->close();
        const Known again = bench.open(bench.sitting(1, 99)); // the folder knows better
        QVERIFY(again.seed == std::uint64_t(7));
        QVERIFY(again.records == std::vector{record});
        const Known other = bench.open(bench.sitting(2, 99));
        QVERIFY(other.problem.isEmpty() && other.records.empty());
        bench.keep(Bench::next({}, 2));
        QCOMPARE(bench.look(2).records.size(), std::size_t(1));
        QVERIFY(bench.look(1).records == std::vector{record});
        QVERIFY(bench.look(1).seed == std::uint64_t(7));
        QCOMPARE(bench.look(1).next_participant, 3);
    }

    void a_folder_that_cannot_be_this_study_s_says_why() {
        Bench bench;
        bench.open(bench.sitting());
        bench.keeping->close();
        QVERIFY2(
            bench.look(1, shapes(3)).problem.startsWith("In this folder lies a study of another experiment"),
            qPrintable(bench.look(1, shapes(3)).problem));
        QFile terms(QString::fromStdString((bench.study() / study_terms_file).string()));
        QVERIFY(terms.open(QIODevice::WriteOnly));
        terms.write(QByteArray::fromStdString(terms_text({7, true})));
        terms.close();
        QVERIFY(bench.look().problem.startsWith("In this folder lies a study with simulated participants."));
        QVERIFY(terms.open(QIODevice::WriteOnly));
        terms.write("seed: many\n");
        terms.close();
        const QString unreadable = bench.look().problem;
        QVERIFY2(unreadable.contains("study.txt") && unreadable.endsWith('.'), qPrintable(unreadable));
        QVERIFY(!bench.open(bench.sitting()).problem.isEmpty());
        QCOMPARE(bench.keep(Bench::next({})), QString("The study's folder is not open."));
    }

    void nobody_else_writes_until_it_is_let_go() {
        Bench bench;
        QCOMPARE(bench.keep(Bench::next({})), QString("The study's folder is not open."));
        bench.open(bench.sitting());
        Bench second;
        const Known refused = second.open(bench.sitting(2));
        QVERIFY2(!refused.problem.isEmpty() && refused.problem.endsWith('.'), qPrintable(refused.problem));
        bench.keeping->close();
        bench.look(); // after it
        QCOMPARE(second.open(bench.sitting(2)).problem, QString());
        QCOMPARE(bench.keep(Bench::next({})), QString("The study's folder is not open."));
    }

    void a_trial_that_was_lost_with_the_program_is_told() {
        Bench bench;
        bench.open(bench.sitting());
        bench.keep(Bench::next({}));
        bench.keeping->begins(1);
        bench.keeping = std::make_unique<StudyKeeping>(); // it waits for what was asked for
        const QString notice = bench.look().notice;
        QCOMPARE(notice, QString("A trial was running when the program ended; it is done again."));
        QCOMPARE(bench.look().problem, QString());
    }

    void what_was_asked_for_is_done_although_it_ends() {
        Bench bench;
        bench.keeping->open(bench.sitting(), [](const Known&) {});
        bench.keeping->keep(Bench::next({}), Bench::path(), [](const QString&) {});
        bench.keeping.reset();
        const auto study = read_study(bench.study());
        QVERIFY(study && study->records.size() == 1);
    }
};

} // namespace study_keeping_test

TP_TEST(study_keeping_test, StudyKeepingTest, event_loop)
#include "study_keeping_test.moc"
