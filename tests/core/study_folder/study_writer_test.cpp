// SPDX-License-Identifier: Apache-2.0
// A study that is run, ended, gone on with: what lies in its folder, and what is refused.
#include "album_folder.hpp"
#include "core/experiment/experiment_file.hpp"
#include "core/study_folder/path_file.hpp"
#include "core/study_folder/running_trial.hpp"
#include "core/study_folder/study_check.hpp"
#include "core/study_folder/study_writer.hpp"

#include <QTest>

#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

const Experiment& small() {
    static const Experiment experiment =
        read_experiment(
            "experiment: small\ntask: follow\nfactor range: 2, 4 mm\nrepetitions: 2\ntraining: 1\n")
            .value();
    return experiment;
}

const StudyTerms terms{42, false};
const StudyMachine mouse{"2026-11-26", "touchphoto 0.1.0", "mouse", "3.7 pixels a millimetre"};
const StudyMachine pad{"2026-11-27", "touchphoto 0.1.0", "force pad", "a \"loan\", 0.98"};

std::vector<FingerSample> some_path(int trial) {
    std::vector<FingerSample> path;
    for (int i = 0; i < 200; ++i)
        path.push_back({i * 0.01, trial + i * 0.1, -1.0, 0.25, -0.5});
    return path;
}

std::string does(StudyWriter& writer, int participant, bool repeated = false) {
    const auto next = writer.next(participant);
    if (!next)
        return "there is nothing to do";
    TrialRecord record = begun_record(*next, participant);
    record.error_mm = 1.5;
    record.time_s = 1.99;
    record.repeated = repeated;
    return writer.keep(record, some_path(record.trial));
}

std::unique_ptr<StudyWriter> opened(const fs::path& folder, const StudyMachine& machine = mouse) {
    auto writer = StudyWriter::open(folder, small(), terms, machine);
    if (!writer)
        qFatal("%s", writer.error().c_str());
    return std::move(writer).value();
}

} // namespace

class StudyWriterTest : public QObject {
    Q_OBJECT
    AlbumFolder place_;
    int count_ = 0;
    fs::path folder_;

private slots:
    void init() { folder_ = place_ / ("study-" + std::to_string(++count_)); }

    void a_trial_that_was_running_when_the_program_ended_is_said_once() {
        const std::vector<std::string> lost{"A trial was running when the program ended; it is done again."};
        {
            const auto writer = opened(folder_);
            writer->begins(1);
            QVERIFY(name_taken(folder_ / study_running_file));
        } // the program ends
        const auto faults = [&] { return check_study(folder_, read_study(folder_).value()).faults; };
        QCOMPARE(faults(), lost);
        {
            const auto writer = opened(folder_);
            QCOMPARE(writer->remarks(), lost);
            QCOMPARE(writer->next(1)->number, 1);
            writer->begins(1);
            QVERIFY(faults().empty()); // it runs
            QCOMPARE(does(*writer, 1), std::string());
            QVERIFY(!name_taken(folder_ / study_running_file));
            writer->begins(2);
            QCOMPARE(does(*writer, 2), std::string());
            note_running(folder_, 2, 1); // as a power cut may leave it, although the trial was kept
        }
        QVERIFY(faults().empty());
        QVERIFY(opened(folder_)->remarks().empty());
        QVERIFY(!name_taken(folder_ / study_running_file));
    }
    void a_study_that_begins_says_all_about_itself() {
        const auto writer = opened(folder_);
        QVERIFY(writer->participants().empty() && writer->remarks().empty());
        const auto study = read_study(folder_);
        QVERIFY2(study.ok(), study.error().c_str());
        QCOMPARE(experiment_text(study->experiment), experiment_text(small()));
        QCOMPARE(study->terms, std::optional(terms));
        const std::string readme = *read_whole(folder_ / "README.txt", 100'000);
        for (const char* const words : {"protocol.study",
                                        "study.txt",
                                        "sittings.csv",
                                        "participant-NNN.csv",
                                        "paths/",
                                        "experiment  ",
                                        "participant  ",
                                        "trial  ",
                                        "repetition  ",
                                        "training  ",
                                        "range         factor, in mm: 2, 4\n",
                                        "error_mm      mm",
                                        "time_s        s",
                                        "answer  ",
                                        "correct  ",
                                        "repeated  ",
                                        "seed  ",
                                        "from_trial  ",
                                        "date  ",
                                        "software  ",
                                        "device  ",
                                        "calibration  ",
                                        "x_mm          mm",
                                        "y_mm          mm",
                                        "fx_n          N",
                                        "fy_n          N"})
            QVERIFY2(readme.find(words) != std::string::npos, words);
    }
    void a_trial_that_is_kept_is_a_line_and_a_path() {
        const auto writer = opened(folder_);
        QCOMPARE(does(*writer, 7), std::string());
        QCOMPARE(does(*writer, 7, true), std::string());
        const auto study = read_study(folder_);
        QVERIFY2(study.ok(), study.error().c_str());
        QCOMPARE(study->records, writer->records_of(7));
        QCOMPARE(study->records.size(), std::size_t{2});
        QVERIFY(study->records[1].repeated);
        QCOMPARE(writer->next(7)->attempts, 1);
        for (int trial = 1; trial <= 2; ++trial) {
            const auto path = read_path(folder_ / "paths" / path_file_name(7, trial));
            QVERIFY2(path.ok(), path.error().c_str());
            QCOMPARE(path->size(), std::size_t{200});
            QCOMPARE(path->at(0).x_mm, double(trial));
        }
        QCOMPARE(writer->participants(), std::vector<int>{7});
    }
    void the_next_day_a_person_goes_on_where_they_were() {
        for (int day = 0; day < 5; ++day) {
            const auto writer = opened(folder_);
            QCOMPARE(writer->next(1)->number, day + 1);
            QCOMPARE(does(*writer, 1), std::string());
            QVERIFY(writer->remarks().empty());
        }
        const auto writer = StudyWriter::go_on(folder_, mouse);
        QVERIFY2(writer.ok(), writer.error().c_str());
        QVERIFY(!(*writer)->next(1));
        QVERIFY((*writer)->next(2).has_value());
        QCOMPARE((*writer)->terms(), terms);
        QCOMPARE(study_progress(*read_study(folder_)),
                 std::vector<std::string>{"Participant 1: 4 trials of 4."});
    }
    void each_machine_is_noted_from_its_first_trial_on() {
        {
            const auto writer = opened(folder_);
            for (int i = 0; i < 2; ++i)
                QCOMPARE(does(*writer, 2), std::string());
            QCOMPARE(does(*writer, 1), std::string());
        }
        const auto writer = opened(folder_, pad);
        QCOMPARE(does(*writer, 2), std::string());
        writer->use(mouse);
        QCOMPARE(does(*writer, 2), std::string());
        QCOMPARE(does(*writer, 2), std::string());
        QCOMPARE(read_study(folder_)->sittings,
                 (std::vector<StudySitting>{{1, 1, mouse}, {2, 1, mouse}, {2, 3, pad}, {2, 4, mouse}}));
    }
    /// The program was killed before the trial for which it had noted the machine.
    void a_machine_without_a_trial_is_forgotten() {
        opened(folder_);
        place_.write(folder_.filename() / "sittings.csv",
                     sittings_text({{1, 1, mouse}, {1, 2, pad}, {3, 1, pad}}));
        const auto writer = opened(folder_);
        QCOMPARE(does(*writer, 1), std::string());
        QCOMPARE(does(*writer, 1), std::string());
        QCOMPARE(does(*writer, 3), std::string());
        QCOMPARE(read_study(folder_)->sittings, (std::vector<StudySitting>{{1, 1, mouse}, {3, 1, mouse}}));
    }
    /// At each byte of the last line, and here and there before it.
    void a_line_that_was_being_written_is_cut_away_and_said() {
        {
            const auto writer = opened(folder_);
            QCOMPARE(does(*writer, 1), std::string());
            QCOMPARE(does(*writer, 1), std::string());
        }
        const fs::path table = folder_ / "participant-001.csv";
        const std::string whole = *read_whole(table, 10'000);
        const std::size_t columns = trial_columns(small()).size();
        const std::size_t last = whole.rfind('\n', whole.size() - 2);
        for (std::size_t cut = 1; cut < whole.size(); cut += cut < last ? 20 : 1) {
            QCOMPARE(replace_file(table, whole.substr(0, cut)), std::string());
            const auto writer = opened(folder_);
            const bool torn = whole[cut - 1] != '\n';
            QCOMPARE(writer->remarks().size(), std::size_t(torn ? 1 : 0));
            if (torn)
                QVERIFY(
                    writer->remarks()[0].ends_with("participant-001.csv\": the last trial was being written "
                                                   "when the program ended; it is done again."));
            const std::size_t kept =
                cut < columns ? 0 : whole.substr(columns, cut - columns).find('\n') != std::string::npos;
            QCOMPARE(writer->records_of(1).size(), kept);
            for (std::size_t i = kept; i < 2; ++i)
                QCOMPARE(does(*writer, 1), std::string());
            QVERIFY(*read_whole(table, 10'000) == whole);
        }
    }
    void what_a_killed_program_left_under_other_names_is_swept_away() {
        {
            const auto writer = opened(folder_);
            QCOMPARE(does(*writer, 1), std::string());
        }
        const fs::path left = folder_ / ".touchphoto-1-1.tmp",
                       path = folder_ / "paths" / ".touchphoto-1-2.tmp";
        for (const fs::path& file : {left, path})
            QCOMPARE(replace_file(file, "half"), std::string());
        opened(folder_);
        QVERIFY(!name_taken(left) && !name_taken(path));
        QVERIFY(name_taken(folder_ / "paths" / path_file_name(1, 1)));
    }
    void two_programs_at_once_are_refused() {
        auto first = opened(folder_);
        const auto second = StudyWriter::open(folder_, small(), terms, mouse);
        QCOMPARE(QString::fromStdString(second.error()),
                 QString::fromStdString("Another program is running the study in \"" + folder_.string() +
                                        "\"; end it there, or choose another folder."));
        first.reset();
        opened(folder_);
    }
    void another_experiment_seed_or_kind_of_people_is_refused() {
        opened(folder_);
        Experiment other = small();
        other.repetitions = 3;
        QVERIFY(StudyWriter::open(folder_, other, terms, mouse)
                    .error()
                    .ends_with("lies a study of another experiment, or of another version of it; choose "
                               "another folder for this "
                               "one."));
        for (const StudyTerms& different : {StudyTerms{43, false}, StudyTerms{42, true}})
            QVERIFY(StudyWriter::open(folder_, small(), different, mouse)
                        .error()
                        .ends_with("lies a study with another seed or other participants; choose another "
                                   "folder for this one."));
        opened(folder_);
    }
    void a_folder_of_other_things_is_refused_and_left_as_it_was() {
        for (const char* const name : {"holiday.jpg", "README.txt"}) {
            const fs::path folder = folder_ / name;
            QCOMPARE(make_folder(folder), std::string());
            QCOMPARE(replace_file(folder / name, "mine"), std::string());
            QVERIFY(StudyWriter::open(folder, small(), terms, mouse)
                        .error()
                        .ends_with("has other files in it; a study begins in an empty one."));
            QCOMPARE(std::distance(fs::directory_iterator(folder), {}), 1L);
            QCOMPARE(*read_whole(folder / name, 10), std::string("mine"));
        }
        QVERIFY(StudyWriter::go_on(folder_ / "nowhere", mouse).error().starts_with("There is no study in "));
    }
    /// Killed between its first file and the protocol.
    void a_beginning_that_was_cut_off_begins_anew() {
        opened(folder_);
        fs::remove(folder_ / "protocol.study");
        opened(folder_);
        QVERIFY(read_study(folder_).ok());
        fs::remove(folder_ / "protocol.study");
        fs::remove(folder_ / "README.txt");
        opened(folder_);
        QVERIFY(read_study(folder_).ok() && name_taken(folder_ / "README.txt"));
    }
    void trials_that_nobody_planned_are_refused() {
        {
            const auto writer = opened(folder_);
            QCOMPARE(does(*writer, 1), std::string());
            TrialRecord wrong = begun_record(*writer->next(1), 1);
            wrong.condition = 1 - wrong.condition;
            QCOMPARE(writer->keep(wrong, {}),
                     std::string("The trial was not kept: it is not the one that comes next."));
            TrialRecord other = begun_record(*writer->next(1), 1);
            QCOMPARE(writer->keep(other, std::vector<FingerSample>{{1.0}, {0.5}}),
                     std::string("The trial was not kept: the finger's path in it is none."));
            for (const double number : {-1.0, std::numeric_limits<double>::quiet_NaN(), 1e7}) {
                other = begun_record(*writer->next(1), 1);
                other.error_mm = number;
                QVERIFY(writer->keep(other, {}).ends_with(
                    "its error, time or answer is none that there can be."));
                other.error_mm.reset();
                other.time_s = number;
                QVERIFY(writer->keep(other, {}).ends_with(
                    "its error, time or answer is none that there can be."));
            }
            other.time_s = 1.0;
            other.answer = "a,b\n";
            QVERIFY(
                writer->keep(other, {}).ends_with("its error, time or answer is none that there can be."));
            other.participant = 0;
            QVERIFY(!writer->keep(other, {}).empty());
            QCOMPARE(writer->records_of(1).size(), std::size_t{1});
            QVERIFY(!name_taken(folder_ / "paths" / path_file_name(1, 2)));
        }
        const fs::path table = folder_ / "participant-001.csv";
        const std::string whole = *read_whole(table, 10'000);
        QCOMPARE(replace_file(table, whole + whole.substr(whole.find('\n') + 1)), std::string());
        QVERIFY(StudyWriter::go_on(folder_, mouse)
                    .error()
                    .ends_with(
                        "participant-001.csv\" cannot be gone on with: its trial 1 is not the one that the "
                        "study has planned."));
        QCOMPARE(replace_file(table, whole), std::string());
        fs::rename(table, folder_ / "participant-1.csv");
        QVERIFY(StudyWriter::go_on(folder_, mouse)
                    .error()
                    .ends_with("participant-1.csv\" has the trials of participant 1; name it "
                               "\"participant-001.csv\"."));
        fs::rename(folder_ / "participant-1.csv", table);
        fs::remove(folder_ / "study.txt");
        QVERIFY(StudyWriter::go_on(folder_, mouse)
                    .error()
                    .ends_with("cannot go on: its file \"study.txt\" is missing."));
    }
    /// A spreadsheet that is open beside the program writes the table anew.
    void a_table_that_somebody_changed_meanwhile_is_not_written_over() {
        const auto writer = opened(folder_);
        QCOMPARE(does(*writer, 1), std::string());
        const fs::path table = folder_ / "participant-001.csv";
        const std::string whole = *read_whole(table, 10'000);
        QCOMPARE(replace_file(table, whole + "a note\n"), std::string());
        for (int tries = 0; tries < 2; ++tries)
            QVERIFY(does(*writer, 1).ends_with("participant-001.csv\": it was changed meanwhile."));
        QCOMPARE(*read_whole(table, 10'000), whole + "a note\n");
        QCOMPARE(writer->records_of(1).size(), std::size_t{1});
        QCOMPARE(replace_file(table, whole), std::string());
        QCOMPARE(does(*writer, 1), std::string());
    }
    /// Said before anybody has begun.
    void a_folder_that_cannot_be_written_to_is_said() {
        QVERIFY(StudyWriter::open("/proc/study", small(), terms, mouse)
                    .error()
                    .starts_with("The study cannot write \"/proc/study\": "));
        opened(folder_);
        fs::permissions(place_.path(), fs::perms::group_exec | fs::perms::others_exec, fs::perm_options::add);
        fs::permissions(folder_, fs::perms(0555));
        const pid_t child = ::fork();
        if (child == 0) {
            constexpr uid_t nobody = 65534;
            if (::geteuid() == 0 && ::seteuid(nobody) != 0)
                ::_exit(77);
            const std::string said = StudyWriter::go_on(folder_, mouse).error();
            ::_exit(
                said.ends_with("study-" + std::to_string(count_) + "\": you are not allowed to write there.")
                    ? 7
                    : 1);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        fs::permissions(folder_, fs::perms::owner_all);
        if (WIFEXITED(status) && WEXITSTATUS(status) == 77)
            QSKIP("the superuser may write everywhere");
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 7);
    }
    void several_people_at_once_are_kept_apart() {
        const auto writer = opened(folder_);
        std::vector<std::thread> threads;
        for (int participant = 1; participant <= 4; ++participant)
            threads.emplace_back([&writer, participant] {
                while (writer->next(participant))
                    if (!does(*writer, participant).empty())
                        return;
            });
        for (std::thread& thread : threads)
            thread.join();
        const auto study = read_study(folder_);
        QVERIFY2(study.ok(), study.error().c_str());
        QCOMPARE(study->records.size(), std::size_t{4 * 5});
        QCOMPARE(study->sittings.size(), std::size_t{4});
    }
    /// The same trials are the same bytes, in whatever order people took part.
    void the_same_study_is_the_same_bytes() {
        std::map<std::string, std::string> files[2];
        for (int way = 0; way < 2; ++way) {
            const AlbumFolder place;
            {
                const auto writer = opened(place / "study");
                for (const int participant : way == 0 ? std::vector{1, 2, 3} : std::vector{3, 1, 2})
                    while (writer->next(participant))
                        QCOMPARE(does(*writer, participant), std::string());
            }
            files[way] = place.files();
        }
        QVERIFY(files[0] == files[1]);
        QCOMPARE(files[0].size(), std::size_t{4 + 3 + 15});
    }
};

QTEST_GUILESS_MAIN(StudyWriterTest)
#include "study_writer_test.moc"
