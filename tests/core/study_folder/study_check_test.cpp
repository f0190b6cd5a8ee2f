// SPDX-License-Identifier: Apache-2.0
// What `study check` finds in a folder, and what `study export` takes along.
#include "album_folder.hpp"
#include "core/study_folder/path_file.hpp"
#include "core/study_folder/study_check.hpp"
#include "core/study_folder/study_export.hpp"
#include "worked_study.hpp"

#include <QProcess>
#include <QTest>

#include <initializer_list>

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

struct Study {
    AlbumFolder dir;
    fs::path folder = dir / "study";

    explicit Study(int participants = 2) {
        const auto writer = StudyWriter::open(folder, worked_experiment(), worked_terms, worked_mouse);
        for (int participant = 1; participant <= participants; ++participant)
            while (const auto next = (*writer)->next(participant)) {
                const TrialRecord record = worked_record(*next, participant);
                if (!(*writer)->keep(record, worked_path(record)).empty())
                    qFatal("nothing is kept");
            }
    }
    fs::path path_of(int participant, int trial) const {
        return folder / "paths" / path_file_name(participant, trial);
    }
    StudyFindings found() const { return check_study(folder, read_study(folder).value()); }
    std::string fault() const {
        const auto faults = found().faults;
        return faults.size() == 1 ? faults[0] : std::to_string(faults.size()) + " faults";
    }
    /// What another program finds in the zip: a line a file, its size and its bytes' beginning.
    QByteArray zip(const std::string& what) const {
        QProcess python;
        python.start("/usr/bin/python3", {"-c",
                                          "import sys, zipfile\n"
                                          "z = zipfile.ZipFile(sys.argv[1])\n"
                                          "assert z.testzip() is None\n" +
                                              QString::fromStdString(what),
                                          QString::fromStdString((dir / "x.zip").string())});
        python.waitForFinished();
        return python.readAllStandardError() + python.readAllStandardOutput();
    }
};

} // namespace

class StudyCheckTest : public QObject {
    Q_OBJECT
private slots:
    void a_study_of_ours_has_no_faults() {
        const Study study;
        std::size_t done = 0, all = 0;
        const auto found =
            check_study(study.folder, *read_study(study.folder), [&](std::size_t now, std::size_t of) {
                QCOMPARE(now, ++done);
                all = of;
            });
        QVERIFY(found.faults.empty() && !found.running);
        QCOMPARE(done, std::size_t{14});
        QCOMPARE(all, done);
        const auto writer = StudyWriter::go_on(study.folder, worked_mouse);
        QVERIFY(study.found().running);
    }
    void paths_that_are_missing_are_named_once_a_person() {
        const Study study;
        const auto missing = [&](std::initializer_list<int> trials) {
            for (const int trial : trials)
                fs::remove(study.path_of(1, trial));
            return study.fault();
        };
        const std::string said = "Participant 1: the finger's path is missing in these trials: ";
        QCOMPARE(missing({2, 7}), said + "2, 7.");
        QCOMPARE(missing({3, 5}), said + "2, 3, 5, 7.");
        QCOMPARE(missing({4, 1}), said + "1–5, 7.");
        QCOMPARE(missing({6}), said + "1–7.");
    }
    void a_torn_path_is_named() {
        const Study study;
        const std::string bytes = *read_whole(study.path_of(2, 3), 100'000);
        QCOMPARE(replace_file(study.path_of(2, 3), bytes.substr(0, bytes.size() / 2)), std::string());
        QVERIFY(study.fault().ends_with(
            "participant-002-trial-0003.csv.gz\": The finger's path cannot be unpacked: it ends too soon."));
    }
    void a_path_with_too_few_samples_is_named() {
        const Study study;
        std::vector<FingerSample> path(198); // of 2 s: one may be missing at either end
        QCOMPARE(replace_file(study.path_of(2, 3), path_bytes(path)), std::string());
        QCOMPARE(study.fault(), std::string("0 faults"));
        path.resize(197);
        QCOMPARE(replace_file(study.path_of(2, 3), path_bytes(path)), std::string());
        QVERIFY(study.fault().ends_with(
            "trial-0003.csv.gz\" has 197 samples; in the trial's time there are 200 at least."));
    }
    void a_path_of_no_trial_is_named() {
        const Study study;
        for (const char* const name :
             {"participant-003-trial-0001.csv.gz", "participant-1-trial-1.csv.gz", "notes"}) {
            QCOMPARE(replace_file(study.folder / "paths" / name, "x"), std::string());
            QVERIFY(study.fault().ends_with(std::string(name) + "\" belongs to no trial that was kept."));
            fs::remove(study.folder / "paths" / name);
        }
        QCOMPARE(study.fault(), std::string("0 faults"));
    }
    void what_a_killed_program_left_is_named() {
        const Study study;
        for (const fs::path& folder : {study.folder, study.folder / "paths"}) {
            QCOMPARE(replace_file(folder / ".touchphoto-9-9.tmp", "x"), std::string());
            QVERIFY(study.fault().ends_with(".touchphoto-9-9.tmp\" was being written when the program ended; "
                                            "it goes when the study goes on."));
            fs::remove(folder / ".touchphoto-9-9.tmp");
        }
        const fs::path table = study.folder / "participant-002.csv";
        QCOMPARE(replace_file(table, *read_whole(table, 10'000) + "small,2"), std::string());
        QVERIFY(study.fault().ends_with("it is left out."));
    }
    void what_was_not_planned_is_named() {
        const Study study;
        QCOMPARE(replace_file(study.folder / "study.txt", terms_text({43, false})), std::string());
        const auto faults = study.found().faults;
        QCOMPARE(faults.size(), std::size_t{2});
        QCOMPARE(faults[0], std::string("Participant 1: trial 1 is not the one that was planned; protocol, "
                                        "seed or table were changed since."));
        fs::remove(study.folder / "study.txt");
        QCOMPARE(study.fault(),
                 std::string("There is no file \"study.txt\": nobody knows the seed of the study, or "
                             "whether its participants are simulated."));
    }
    void a_machine_that_nobody_noted_is_named() {
        const Study study;
        QCOMPARE(replace_file(study.folder / "sittings.csv",
                              sittings_text({{1, 1, worked_mouse}, {2, 2, worked_pad}})),
                 std::string());
        QCOMPARE(study.fault(),
                 std::string("Participant 2: nobody has noted with which machine the first trial "
                             "was done."));
    }
    void where_it_is_stopped_it_ends() {
        const Study study;
        std::stop_source stop;
        std::size_t done = 0;
        const StudyFindings found = check_study(
            study.folder, *read_study(study.folder),
            [&](std::size_t now, std::size_t) {
                done = now;
                stop.request_stop();
            },
            stop.get_token());
        QCOMPARE(done, std::size_t{1});
        QVERIFY(found.faults.empty()); // of paths that nobody has looked at nothing is said
        QCOMPARE(export_study(study.folder, study.dir / "x.zip", {}, stop.get_token()).error(),
                 std::string("The export was stopped; nothing was written."));
        QVERIFY(!name_taken(study.dir / "x.zip"));
    }

    void a_zip_has_the_whole_study_in_one_folder() {
        const Study study;
        const auto done = export_study(study.folder, study.dir / "x.zip");
        QVERIFY2(done.ok(), done.error().c_str());
        QCOMPARE(done->participants, std::size_t{2});
        QCOMPARE(done->trials, std::size_t{14});
        QCOMPARE(done->paths, std::size_t{14});
        QVERIFY(done->remarks.empty());
        QCOMPARE(study.zip("print(*[n for n in z.namelist() if 'paths' not in n], sep='\\n')"),
                 QByteArray("small/README.txt\nsmall/protocol.study\nsmall/study.txt\nsmall/sittings.csv\n"
                            "small/participant-001.csv\nsmall/participant-002.csv\n"));
        // Paths are packed once, tables in the zip: 0 is stored, 8 deflated.
        QCOMPARE(study.zip("print({('paths' in i.filename, i.compress_type) for i in z.infolist()} == "
                           "{(True, 0), (False, 8)})"),
                 QByteArray("True\n"));
        // Unpacked it is the folder again.
        QVERIFY(study.zip("z.extractall(sys.argv[1] + '.d')").isEmpty());
        auto files = study.dir.files();
        std::map<std::string, std::string> before, after;
        for (const auto& [name, bytes] : files)
            if (name.starts_with("study/"))
                before[name.substr(6)] = bytes;
            else if (name.starts_with("x.zip.d/small/"))
                after[name.substr(14)] = bytes;
        QVERIFY(before == after);
        QCOMPARE(after.size(), std::size_t{4 + 2 + 14});
    }
    void the_same_study_is_the_same_zip() {
        const Study study;
        QVERIFY(export_study(study.folder, study.dir / "x.zip").ok());
        QVERIFY(export_study(study.folder, study.dir / "y.zip").ok());
        QVERIFY(study.dir.read("x.zip") == study.dir.read("y.zip"));
        const auto into_itself = export_study(study.folder, study.folder / "z.zip");
        QVERIFY(into_itself.ok() && into_itself->remarks.empty());
        QVERIFY(*read_whole(study.folder / "z.zip", 1 << 20) == study.dir.read("x.zip"));
    }
    /// In each place where a person might have put one.
    void no_name_goes_along() {
        const Study study;
        const auto put = [&](const char* file, const std::string& text) {
            QCOMPARE(replace_file(study.folder / file, text), std::string());
        };
        put("protocol.study", "# Anna's protocol\n" + study.dir.read("study/protocol.study"));
        put("study.txt", "# Anna was here\n" + study.dir.read("study/study.txt"));
        put("README.txt", "1 is Anna");
        put("Anna.pdf", "consent");
        put(".touchphoto-9-9.tmp", "Anna");                  // of a program that was killed
        put("running.txt", "participant-001-Anna.csv.gz\n"); // of the same
        put("paths/participant-001-Anna.csv.gz", "x");
        fs::rename(study.folder / "participant-001.csv", study.folder / "participant-Anna.csv");
        fs::copy_file(study.path_of(1, 1), study.dir / "Anna");
        QProcess gzip; // notes the name of what it packs
        gzip.start("sh", {"-c", "cd '" + QString::fromStdString(study.dir.path().string()) +
                                    "' && zcat Anna > Anna.csv && gzip Anna.csv"});
        QVERIFY(gzip.waitForFinished());
        fs::copy_file(study.dir / "Anna.csv.gz", study.path_of(1, 1), fs::copy_options::overwrite_existing);
        QVERIFY(study.dir.read("Anna.csv.gz").find("Anna.csv") != std::string::npos);
        const auto done = export_study(study.folder, study.dir / "x.zip");
        QVERIFY2(done.ok(), done.error().c_str());
        QCOMPARE(done->remarks.size(), std::size_t{1});
        QVERIFY(done->remarks[0].ends_with("Anna.pdf\" is no file of the study; it is not in the zip."));
        QCOMPARE(
            study.zip(
                "print(any(b'Anna' in z.read(n) or 'Anna' in n for n in z.namelist()), len(z.namelist()))"),
            QByteArray("False 20\n"));
    }
    void what_cannot_be_read_is_left_out_and_said() {
        const Study study;
        fs::remove(study.path_of(1, 1));
        QCOMPARE(replace_file(study.path_of(1, 2), "x"), std::string());
        QCOMPARE(replace_file(study.folder / "participant-002.csv",
                              study.dir.read("study/participant-002.csv") + "small,2,"),
                 std::string());
        const auto done = export_study(study.folder, study.dir / "x.zip");
        QVERIFY2(done.ok(), done.error().c_str());
        QCOMPARE(done->paths, std::size_t{12});
        QCOMPARE(done->remarks.size(), std::size_t{3});
        QVERIFY(done->remarks[0].ends_with(
            "the last trial was being written when the program ended; it is left out."));
        QVERIFY(!export_study(study.dir.path(), study.dir / "y.zip").ok());
        QVERIFY(
            export_study(study.folder, study.dir / "no" / "where.zip").error().find("there is no folder") !=
            std::string::npos);
    }
};

QTEST_GUILESS_MAIN(StudyCheckTest)
#include "study_check_test.moc"
