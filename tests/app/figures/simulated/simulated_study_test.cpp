// SPDX-License-Identifier: Apache-2.0
#include "app/figures/simulated/simulated_study.hpp"
#include "core/experiment/experiment_file.hpp"
#include "core/files/whole_file.hpp"
#include "test_program.hpp"

#include <QDir>
#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>

#include <map>
#include <memory>

namespace simulated_study_test {

using namespace tp;

namespace {

const Experiment small =
    read_experiment("experiment: a\ntask: follow\nset path: circle\nset stiffness: 0.4 N/mm\nfactor "
                    "range: 4, 8 mm\ntraining: 1\nrepetitions: 2\n")
        .value();

std::map<QString, std::string> files_in(const QString& folder) {
    std::map<QString, std::string> files;
    QDirIterator at(folder, QDir::Files, QDirIterator::Subdirectories);
    while (at.hasNext()) {
        const QString file = at.next();
        files[QDir(folder).relativeFilePath(file)] = read_whole(file.toStdString(), 1 << 24).value();
    }
    return files;
}

std::unique_ptr<StudyWriter> writer_in(const QString& folder, std::uint64_t seed = 1,
                                       const Experiment& experiment = small) {
    return StudyWriter::open(folder.toStdString(), experiment, {seed, true}, {"", "test", "simulated", ""})
        .value();
}

bool never() { return false; }

std::map<QString, std::string> simulated(int jobs, std::uint64_t seed = 1, int at_a_time = 3) {
    const QTemporaryDir folder;
    for (int first = 1; first <= 3; first += at_a_time) {
        const auto writer = writer_in(folder.filePath("study"), seed);
        const auto study = simulate_study(*writer, first, at_a_time, {}, nullptr, jobs, {}, never);
        if (!study)
            qFatal("%s", study.error().c_str());
    }
    return files_in(folder.filePath("study"));
}

} // namespace

class SimulatedStudyTest : public QObject {
    Q_OBJECT
private slots:
    void the_same_seed_writes_the_same_bytes_however_many_work_and_in_however_many_goes() {
        const auto once = simulated(1);
        QVERIFY(once.size() > 15); // three tables, a path a trial, protocol, terms
        QVERIFY(simulated(3) == once);
        QVERIFY(simulated(1, 1, 1) == once);
        QVERIFY(simulated(1, 2) != once);
    }
    void everything_that_was_planned_is_done() {
        const QTemporaryDir folder;
        const auto writer = writer_in(folder.filePath("study"));
        std::size_t told = 0, of = 0;
        const auto study = simulate_study(
            *writer, 1, 2, {}, nullptr, 1,
            [&](std::size_t done, std::size_t planned) {
                told = done;
                of = planned;
            },
            never);
        QVERIFY(study && study->remarks.empty());
        QCOMPARE(study->trials, std::size_t{2 * 5});
        QCOMPARE(told, std::size_t{10});
        QCOMPARE(of, std::size_t{10});
        for (int person = 1; person <= 2; ++person) {
            QVERIFY(!writer->next(person));
            for (const TrialRecord& record : writer->records_of(person))
                QVERIFY(record.repeated || (record.error_mm && record.time_s > 1.0));
        }
    }
    void one_that_was_stopped_goes_on_as_if_it_had_not_been() {
        const auto whole = simulated(1);
        const QTemporaryDir folder;
        int asked = 0;
        QVERIFY(simulate_study(*writer_in(folder.filePath("study")), 1, 3, {}, nullptr, 1, {},
                               [&] { return ++asked > 8; }));
        QVERIFY(files_in(folder.filePath("study")).size() < whole.size());
        QVERIFY(simulate_study(*writer_in(folder.filePath("study")), 1, 3, {}, nullptr, 1, {}, never));
        QVERIFY(files_in(folder.filePath("study")) == whole);
    }
    void who_cannot_do_it_ends_and_is_named() {
        const Experiment hopeless =
            read_experiment("experiment: a\ntask: follow\nset path: triangle\nset stiffness: 0.01 "
                            "N/mm\nlongest trial: 3 s\nfactor range: 0.5, 0.6 mm\n")
                .value();
        const QTemporaryDir folder;
        const auto writer = writer_in(folder.filePath("study"), 1, hopeless);
        const auto study = simulate_study(*writer, 1, 2, {}, nullptr, 2, {}, never);
        QVERIFY(study);
        QCOMPARE(study->trials, std::size_t{0});
        QCOMPARE(study->repeated, std::size_t{2 * most_simulated_attempts});
        QCOMPARE(study->remarks.size(), std::size_t{2});
        QVERIFY(study->remarks.front().starts_with("Participant 1 has missed trial"));
    }
    void faces_that_are_missing_are_said() {
        const Experiment faces =
            read_experiment(
                "experiment: a\ntask: name\nfactor expression: sad, angry\nset face: 1\nanswer: expression\n")
                .value();
        const QTemporaryDir folder;
        const auto writer = writer_in(folder.filePath("study"), 1, faces);
        const auto study = simulate_study(*writer, 1, 1, {}, nullptr, 1, {}, never);
        QVERIFY(study.error().find("needs faces") != std::string::npos);
    }
};

} // namespace simulated_study_test

TP_TEST(simulated_study_test, SimulatedStudyTest, nothing)
#include "simulated_study_test.moc"
