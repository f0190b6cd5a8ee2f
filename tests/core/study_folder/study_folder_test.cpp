// SPDX-License-Identifier: Apache-2.0
#include "core/study_folder/study_folder.hpp"
#include "drawn_study.hpp"

#include <QTemporaryDir>
#include <QTest>

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;

namespace {

const std::string protocol =
    "experiment: small\ntask: follow\nfactor range: 2, 4 mm\nrepetitions: 2\ntraining: 1\n";
const std::string columns =
    "experiment,participant,trial,repetition,training,range,error_mm,time_s,answer,correct,repeated,seed\n";

struct Folder {
    QTemporaryDir dir;
    fs::path path = fs::path(dir.path().toStdString());
    Folder() {
        draw_study(path, protocol, 2, [](int, const PlannedTrial&, TrialRecord& record) {
            record.error_mm = 1.0;
            record.time_s = 9.0;
        });
    }
    std::string problem() const { return read_study(path).error(); }
};

} // namespace

class StudyFolderTest : public QObject {
    Q_OBJECT
private slots:
    void all_participants_are_read_in_order_and_how_far_they_are() {
        Folder folder;
        const auto study = read_study(folder.path);
        QVERIFY2(study.ok(), study.error().c_str());
        QCOMPARE(study->records.size(), std::size_t{2 * 5});
        QCOMPARE(study->records.back().participant, 2);
        QVERIFY(study->remarks.empty());
        QCOMPARE(study_progress(*study), (std::vector<std::string>{"Participant 1: 4 trials of 4.",
                                                                   "Participant 2: 4 trials of 4."}));
        QCOMPARE(participant_file(7), std::string("participant-007.csv"));
        QCOMPARE(participant_file(12345), std::string("participant-12345.csv"));
    }
    void what_is_missing_and_was_done_again_is_told() {
        Folder folder;
        write_file(folder.path / "participant-003.csv", columns + "small,3,1,1,yes,2,1,9,,,no,1\n" +
                                                            "small,3,2,1,no,2,1,9,,,yes,1\n" +
                                                            "small,3,3,1,no,2,1,9,,,no,1\n");
        QCOMPARE(study_progress(*read_study(folder.path)).back(),
                 std::string("Participant 3: 1 trials of 4, 1 of them done again; 3 are missing."));
    }
    void a_torn_line_is_left_out_and_told() {
        Folder folder;
        write_file(folder.path / "participant-001.csv", columns + "small,1,1,1,no,2,1,9,,,no,1\nsmall,1,2");
        const auto study = read_study(folder.path);
        QVERIFY2(study.ok(), study.error().c_str());
        QCOMPARE(study->remarks.size(), std::size_t{1});
        QVERIFY(study->remarks[0].find("participant-001.csv") != std::string::npos);
        QVERIFY(study->remarks[0].ends_with("it is left out."));
    }
    void two_tables_of_one_person_and_two_people_in_one_table_are_refused_by_name() {
        Folder folder;
        const std::string first = columns + "small,1,1,1,no,2,1,9,,,no,1\n";
        write_file(folder.path / "participant-009.csv", first);
        QVERIFY(folder.problem().ends_with("participant-001.csv\" already."));
        write_file(folder.path / "participant-009.csv",
                   columns + "small,9,1,1,no,2,1,9,,,no,1\nsmall,1,2,1,no,2,1,9,,,no,1\n");
        QVERIFY(folder.problem().ends_with("the trials of more than one participant are in it."));
    }
    void what_cannot_be_read_is_refused_by_name() {
        Folder folder;
        write_file(folder.path / "participant-001.csv", columns + "small,1\n");
        QVERIFY(folder.problem().ends_with("participant-001.csv\": Line 2 of the table of trials has another "
                                           "number of cells than there are columns."));
        write_file(folder.path / "protocol.study", "task: dance\n");
        QVERIFY(
            folder.problem().ends_with("protocol.study\": Line 1 of the experiment needs follow or name."));
        QVERIFY(read_study(folder.path / "nowhere").error().find("protocol.study") != std::string::npos);
    }
    void other_files_are_nobodys_and_a_study_may_be_empty() {
        Folder folder;
        write_file(folder.path / "notes.csv", "anything");
        QCOMPARE(folder.problem(), std::string());
        QTemporaryDir empty;
        write_file(fs::path(empty.path().toStdString()) / "protocol.study", protocol);
        const auto study = read_study(empty.path().toStdString());
        QVERIFY(study.ok() && study->records.empty());
    }
};

QTEST_APPLESS_MAIN(StudyFolderTest)
#include "study_folder_test.moc"
