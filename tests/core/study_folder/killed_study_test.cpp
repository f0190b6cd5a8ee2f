// SPDX-License-Identifier: Apache-2.0
// A study under way is killed just before one of its calls to the disk, or half-way through a write, or that call and all later ones
// fail: what was acknowledged is there, at most the running trial is lost, and the study goes on to the same end.
// TP_MOMENTS=1000 tries as many moments.
#include "core/files/durable_file.hpp"
#include "core/files/whole_file.hpp"
#include "core/study_folder/path_file.hpp"
#include "faulty_run.hpp"
#include "memory_folder.hpp"
#include "places.hpp"
#include "worked_study.hpp"

#include <QTest>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

struct Told {
    std::vector<std::pair<int, int>> acknowledged; ///< participant, trial
    std::optional<std::pair<int, int>> begun;      ///< it had begun when the program ended
    std::optional<std::pair<int, int>> running;    ///< it was being kept when the program ended
    bool said_lost = false;                        ///< that a trial was running
    int refused = 0, remarks = 0;
    bool ended = false, said_why = true;
};

Told told_in(const QByteArray& output) {
    Told told;
    for (const QByteArray& line : output.split('\n')) {
        const QList<QByteArray> words = line.split(' ');
        const bool of_trial = words[0] == "BEGUN" || words[0] == "TRY" || words[0] == "ACK";
        const std::pair<int, int> trial =
            of_trial ? std::pair(words[1].toInt(), words[2].toInt()) : std::pair(0, 0);
        if (words[0] == "BEGUN")
            told.begun = trial;
        if (words[0] == "TRY")
            told.running = trial;
        if (words[0] == "ACK") {
            told.acknowledged.push_back(trial);
            told.running.reset();
            told.begun.reset();
        }
        told.said_lost =
            told.said_lost || line.startsWith("REMARK A trial was running when the program ended");
        if (words[0] == "SAID") {
            ++told.refused;
            told.said_why = told.said_why && line.size() > 30 && line.endsWith('.');
        }
        told.remarks += words[0] == "REMARK";
        told.ended = told.ended || words[0] == "END";
    }
    return told;
}

struct Place {
    MemoryFolder dir; // two hundred times twenty trials are brought to the disk
    fs::path study = dir.path() / "study", count = dir.path() / "calls";

    Told run(const QByteArray& fault) const {
        return told_in(faulty_run(test::in_build("tests/core/study_folder/study_worker"),
                                  {QString::fromStdString(study.string())}, study, fault, count));
    }
    /// Name → bytes of the study.
    std::map<fs::path, std::string> files() const {
        std::map<fs::path, std::string> all;
        for (const auto& file : fs::recursive_directory_iterator(study))
            if (file.is_regular_file())
                all[file.path().lexically_relative(study)] = read_whole(file.path(), 1 << 20).value();
        return all;
    }
};

bool is_kept(const Place& place, std::pair<int, int> trial) {
    const auto study = read_study(place.study);
    return study && std::ranges::any_of(study->records, [&](const TrialRecord& record) {
               return std::pair(record.participant, record.trial) == trial;
           });
}

/// What does not hold for the folder that the killed program left; empty where all does.
std::string wrong_with(const Place& place, const Told& told) {
    if (!told.said_why)
        return "a refusal was no sentence";
    if (!name_taken(place.study / study_protocol_file))
        return told.acknowledged.empty() ? "" : "the study is gone";
    const auto study = read_study(place.study);
    if (!study)
        return study.error();
    std::size_t kept = 0;
    for (const TrialRecord& record : study->records) {
        const std::pair trial(record.participant, record.trial);
        kept += std::ranges::find(told.acknowledged, trial) != told.acknowledged.end();
        if (std::ranges::find(told.acknowledged, trial) == told.acknowledged.end() && told.running != trial)
            return "a trial that was not done";
        const auto path =
            read_path(place.study / study_paths_folder / path_file_name(record.participant, record.trial));
        if (!path)
            return path.error();
        if (path_bytes(*path) != path_bytes(worked_path(record)))
            return "the path of another trial";
        const auto sitting = std::ranges::find_if(study->sittings, [&](const StudySitting& one) {
            return one.participant == record.participant && one.from_trial == (record.trial <= 3 ? 1 : 4);
        });
        if (sitting == study->sittings.end() ||
            sitting->machine != (record.trial <= 3 ? worked_mouse : worked_pad))
            return "nobody knows with which machine";
    }
    return kept == told.acknowledged.size() ? "" : "an acknowledged trial is lost";
}

} // namespace

class KilledStudyTest : public QObject {
    Q_OBJECT
    std::map<fs::path, std::string> undisturbed_;
    long calls_ = 0;

private slots:
    void a_program_that_is_left_alone_acknowledges_everything() {
        const Place place;
        const Told told = place.run("none@1");
        calls_ = calls_in(place.count);
        QVERIFY(told.ended && told.refused == 0);
        QCOMPARE(told.acknowledged.size(), std::size_t{14});
        QCOMPARE(wrong_with(place, told), std::string());
        QVERIFY(calls_ > 100);
        undisturbed_ = place.files();
        QCOMPARE(undisturbed_.size(), std::size_t{4 + 2 + 14});
    }
    void nothing_acknowledged_is_lost() {
        QVERIFY(calls_ > 0);
        const std::vector<QByteArray> faults = test::random_faults(
            200, calls_, {"kill@", "kill@", "half@", "half@", "ENOSPC@", "EIO@", "EROFS@"}, 20261126);
        std::size_t cut_off = 0;
        int remarks = 0, told_lost = 0;
        for (const QByteArray& fault : faults) {
            const Place place;
            const Told told = place.run(fault);
            cut_off += !told.ended;
            const std::string wrong = wrong_with(place, told);
            QVERIFY2(wrong.empty(), (fault.toStdString() + ": " + wrong).c_str());
            const bool killed = fault.startsWith("kill") || fault.startsWith("half");
            const bool in_a_trial = killed && told.begun;
            const bool kept = in_a_trial && is_kept(place, *told.begun);
            const Told after = place.run("none@1"); // the next day
            QVERIFY2(!in_a_trial || after.said_lost == !kept, fault.data());
            told_lost += after.said_lost;
            remarks += after.remarks;
            QVERIFY2(after.ended && after.refused == 0, fault.data());
            const std::size_t again = told.acknowledged.size() + after.acknowledged.size();
            QVERIFY2(again == 14 || again == 13, fault.data()); // 13: kept, and killed before it was said
            QVERIFY2(place.files() == undisturbed_, fault.data());
        }
        QVERIFY2(cut_off > faults.size() * 9 / 10, "the faults did not reach the program");
        QVERIFY2(told_lost > 0 || faults.size() < 100, "no trial was cut off in its middle");
        QVERIFY2(remarks > 0 || faults.size() < 100, "no line was half-written");
    }
};

QTEST_GUILESS_MAIN(KilledStudyTest)
#include "killed_study_test.moc"
