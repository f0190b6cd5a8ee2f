// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/recording_file.hpp"
#include "audio/recordings/repair_folder.hpp"
#include "core/files/new_file.hpp"
#include "sounds.hpp"
#include "test_program.hpp"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <map>
#include <set>
#include <sys/ptrace.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace repair_folder_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

using Outcome = RepairedPart::Outcome;

RecordingNotes numbered(unsigned number) {
    RecordingNotes notes;
    notes.label.person = std::to_string(number);
    notes.label.recorded = "2026-05-01T10:15:00+02:00";
    return notes;
}

enum class Ended { killed, by_itself, untraced };

/// Does `work` in a process of its own that is killed before its system call number `call`: what lies on the
/// disk is then what every kill between that call and the one before would leave.
template <typename Work>
Ended killed_before(unsigned call, Work work) {
    constexpr int untraced = 77;
    const pid_t worker = ::fork();
    if (worker == 0) {
        if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0)
            ::_exit(untraced);
        ::raise(SIGSTOP);
        work();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(worker, &status, 0);
    unsigned stops = 0; // two for each call: before it and after it
    while (WIFSTOPPED(status)) {
        if (++stops == 2 * call)
            ::kill(worker, SIGKILL);
        else
            ::ptrace(PTRACE_SYSCALL, worker, nullptr, nullptr);
        ::waitpid(worker, &status, 0);
    }
    if (WIFSIGNALED(status))
        return Ended::killed;
    return WEXITSTATUS(status) == untraced ? Ended::untraced : Ended::by_itself;
}

/// The numbers of the recordings in a folder, each there once and with so many samples; else none.
std::set<unsigned> kept_numbers(const fs::path& folder, std::size_t samples) {
    std::set<unsigned> numbers;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (is_temporary(entry.path()))
            continue;
        const auto about = about_recording(entry.path());
        if (!about)
            return {};
        const auto number = static_cast<unsigned>(std::stoul(about->notes.label.person));
        if (samples_of(entry.path()) != widened(noise(samples, number)) || !numbers.insert(number).second)
            return {};
    }
    return numbers;
}

/// What a recorder tells before it goes on: this many frames of recording `number` are on the disk.
struct Acknowledged {
    std::uint32_t number;
    std::uint32_t frames;
};

/// Makes one recording after the other and tells what is safe, until it is killed.
[[noreturn]] void record_for_ever(const fs::path& folder, int tell, std::uint32_t seed) {
    std::mt19937 random(seed);
    for (std::uint32_t number = 0;; ++number) {
        auto part = start_recording(folder, numbered(number), {8'000, 1});
        const auto sound = noise(20'000, number);
        std::size_t next = 0;
        const std::size_t end = random() % sound.size();
        while (part && next < end) {
            const std::size_t count = std::min<std::size_t>(1 + random() % 3'000, end - next);
            if (!part->append(std::span(sound).subspan(next, count)).empty() || !part->sync().empty())
                ::_exit(1);
            next += count;
            const Acknowledged safe{number, static_cast<std::uint32_t>(part->frames_synced())};
            if (::write(tell, &safe, sizeof safe) != sizeof safe)
                ::_exit(2);
        }
        if (!part || !finish_recording(std::move(*part), numbered(number)))
            ::_exit(3);
    }
}

} // namespace

class RepairFolderTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path root_;

    /// A part that a crash left.
    fs::path left_behind(const RecordingNotes& notes, std::span<const std::int16_t> sound) const {
        auto part = start_recording(root_, notes);
        return part && part->append(sound).empty() ? part->place() : fs::path();
    }

private slots:
    void init() {
        root_ = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(root_);
    }
    void cleanup() { fs::remove_all(root_); } // QTemporaryDir cannot remove names that are not UTF-8

    void a_part_becomes_a_flac() {
        const auto sound = noise(12'345);
        const fs::path part = left_behind(numbered(7), sound);
        const auto repaired = repair_folder(root_);
        QVERIFY(repaired.ok());
        QCOMPARE(repaired->size(), std::size_t{1});
        QVERIFY((*repaired)[0].outcome == Outcome::stored);
        QVERIFY((*repaired)[0].part == part);
        QVERIFY2((*repaired)[0].sentence.find("2026-05-01T101500-memo.flac") != std::string::npos,
                 (*repaired)[0].sentence.c_str());
        QVERIFY(samples_of((*repaired)[0].file) == widened(sound));
        QVERIFY(about_recording((*repaired)[0].file)->notes == numbered(7));
        QCOMPARE(names_in(root_), std::string("2026-05-01T101500-memo.flac"));
        QVERIFY(repair_folder(root_)->empty());
    }

    void one_that_is_being_recorded_is_left_alone() {
        auto part = start_recording(root_, numbered(1));
        QVERIFY(part.ok());
        QCOMPARE(part->append(noise(10)), std::string());
        const auto repaired = repair_folder(root_);
        QVERIFY((*repaired)[0].outcome == Outcome::in_use);
        QCOMPARE(part->append(noise(10)), std::string());
        const auto flac = finish_recording(std::move(*part), numbered(1));
        QCOMPARE(samples_of(**flac).size(), std::size_t{20});
    }

    void killed_before_the_part_was_removed() {
        const fs::path part = left_behind(numbered(1), noise(5'000));
        const std::string bytes = bytes_of(part);
        QVERIFY((*repair_folder(root_))[0].outcome == Outcome::stored);
        const std::string flac = names_in(root_);
        write_bytes(part, bytes);
        const auto again = repair_folder(root_);
        QVERIFY((*again)[0].outcome == Outcome::stored);
        QCOMPARE(names_in(root_), flac);
    }

    void another_recording_of_that_name_stays() {
        const fs::path part = left_behind(numbered(1), noise(5'000, 1));
        const std::string bytes = bytes_of(part);
        QVERIFY((*repair_folder(root_))[0].outcome == Outcome::stored);
        QVERIFY(part == left_behind(numbered(2), noise(5'000, 2)));
        const auto again = repair_folder(root_);
        QVERIFY(samples_of((*again)[0].file) == widened(noise(5'000, 2)));
        QCOMPARE(names_in(root_), std::string("2026-05-01T101500-memo-2.flac 2026-05-01T101500-memo.flac"));
    }

    void what_holds_nothing_goes_and_what_is_foreign_stays() {
        write_bytes(root_ / "empty.wav.part", "");
        left_behind({}, {});
        write_bytes(root_ / "letter.wav.part", "Dear Anna, this is no recording at all. Yours, Opa");
        fs::create_directory(root_ / "folder.wav.part");
        fs::create_symlink("nowhere", root_ / "link.wav.part");
        QCOMPARE(::mkfifo((root_ / "pipe.wav.part").c_str(), 0600), 0);
        const auto repaired = repair_folder(root_);
        QVERIFY(repaired.ok());
        std::map<std::string, Outcome> outcomes;
        for (const RepairedPart& part : *repaired) {
            outcomes[part.part.filename().string()] = part.outcome;
            QVERIFY2(part.sentence.ends_with('.'), part.sentence.c_str());
        }
        QVERIFY(outcomes.at("empty.wav.part") == Outcome::empty);
        QVERIFY(outcomes.at("undated-memo.wav.part") == Outcome::empty);
        for (const char* name : {"letter.wav.part", "folder.wav.part", "link.wav.part", "pipe.wav.part"})
            QVERIFY2(outcomes.at(name) == Outcome::failed, name);
        QCOMPARE(names_in(root_), std::string("folder.wav.part letter.wav.part link.wav.part pipe.wav.part"));
    }

    void names_that_others_gave() {
        const fs::path part = left_behind({}, noise(100));
        const std::string bytes = bytes_of(part);
        fs::remove(part);
        const std::string end(wav_part_end);
        const std::vector<std::string> names{"two\nlines" + end,
                                             "J\xF6rg" + end,
                                             end,
                                             "-rf" + end,
                                             std::string(255 - end.size(), 'n') + end,
                                             "\xE2\x80\xAEgpj" + end};
        for (const std::string& name : names)
            write_bytes(root_ / name, bytes);
        const auto repaired = repair_folder(root_);
        QCOMPARE(repaired->size(), names.size());
        for (const RepairedPart& each : *repaired) {
            QVERIFY2(each.outcome == Outcome::stored, each.sentence.c_str());
            QVERIFY2(each.sentence.find('\n') == std::string::npos, each.sentence.c_str());
            QVERIFY(samples_of(each.file) == widened(noise(100)));
        }
        QVERIFY(names_in(root_).find("part") == std::string::npos);
    }

    void a_folder_that_cannot_be_read() {
        write_bytes(root_ / "file", "x");
        QVERIFY(repair_folder(root_ / "missing").error().ends_with('.'));
        QVERIFY(repair_folder(root_ / "file").error().ends_with('.'));
    }

    void many_repair_at_once() {
        for (unsigned number = 0; number < 5; ++number)
            left_behind(numbered(number), noise(20'000, number));
        std::vector<pid_t> repairers;
        for (int i = 0; i < 4; ++i) {
            const pid_t repairer = ::fork();
            if (repairer == 0)
                ::_exit(repair_folder(root_).ok() ? 0 : 1);
            repairers.push_back(repairer);
        }
        for (const pid_t repairer : repairers) {
            int status = 0;
            QCOMPARE(::waitpid(repairer, &status, 0), repairer);
            QCOMPARE(status, 0);
        }
        QVERIFY(repair_folder(root_)->empty());
        QVERIFY(kept_numbers(root_, 20'000) == (std::set<unsigned>{0, 1, 2, 3, 4}));
        QCOMPARE(std::distance(fs::directory_iterator(root_), fs::directory_iterator()), 5);
    }

    void a_repair_killed_before_every_system_call() {
        for (unsigned call = 1;; ++call) {
            left_behind(numbered(3), noise(5'000, 3));
            const Ended ended = killed_before(call, [&] { static_cast<void>(repair_folder(root_)); });
            if (ended == Ended::untraced)
                QSKIP("processes may not be traced here");
            const auto repaired = repair_folder(root_);
            for (const RepairedPart& part : *repaired)
                QVERIFY2(part.outcome == Outcome::stored, part.sentence.c_str());
            QVERIFY(repair_folder(root_)->empty());
            QVERIFY(kept_numbers(root_, 5'000) == std::set<unsigned>{3});
            if (ended == Ended::by_itself) {
                QVERIFY(call > 50);
                break;
            }
            for (const auto& entry : fs::directory_iterator(root_))
                fs::remove(entry);
        }
    }

    void a_recording_killed_before_every_system_call() {
        const auto sound = noise(3'000, 0);
        for (unsigned call = 1;; ++call) {
            int pipe[2];
            QCOMPARE(::pipe(pipe), 0);
            const Ended ended = killed_before(call, [&] {
                auto part = start_recording(root_, numbered(0));
                for (std::uint32_t next = 0; part && next < 3'000; next += 1'000) {
                    static_cast<void>(part->append(std::span(sound).subspan(next, 1'000)));
                    const Acknowledged safe{0, next + 1'000};
                    if (part->sync().empty() && ::write(pipe[1], &safe, sizeof safe) != sizeof safe)
                        return;
                }
                if (part)
                    static_cast<void>(finish_recording(std::move(*part), numbered(0)));
            });
            ::close(pipe[1]);
            if (ended == Ended::untraced)
                QSKIP("processes may not be traced here");
            Acknowledged safe{};
            while (::read(pipe[0], &safe, sizeof safe) > 0) {
            }
            ::close(pipe[0]);
            QVERIFY(repair_folder(root_).ok());
            std::vector<std::int32_t> kept;
            std::size_t files = 0;
            for (const auto& entry : fs::directory_iterator(root_)) {
                if (!is_temporary(entry.path())) {
                    kept = samples_of(entry.path());
                    ++files;
                }
                fs::remove(entry);
            }
            QVERIFY2(kept.size() >= safe.frames && files <= 1, std::to_string(call).c_str());
            QVERIFY(kept == widened(std::span(sound).first(kept.size())));
            if (ended == Ended::by_itself) {
                QVERIFY(call > 50);
                break;
            }
        }
    }

    void killed_at_any_moment_nothing_is_lost() {
        constexpr int kills = 50;
        std::mt19937 random(20260501);
        std::size_t parts_repaired = 0;
        for (int kill = 0; kill < kills; ++kill) {
            const fs::path folder = root_ / std::to_string(kill);
            int pipe[2];
            QCOMPARE(::pipe(pipe), 0);
            const auto seed = static_cast<std::uint32_t>(random());
            const pid_t recorder = ::fork();
            if (recorder == 0) {
                ::close(pipe[0]);
                record_for_ever(folder, pipe[1], seed);
            }
            ::close(pipe[1]);
            std::map<std::uint32_t, std::uint32_t> safe; // frames of each recording
            Acknowledged told{};
            const auto listen = [&] {
                const bool heard = ::read(pipe[0], &told, sizeof told) == sizeof told;
                if (heard)
                    safe[told.number] = told.frames;
                return heard;
            };
            for (auto more = random() % 40; more > 0 && listen(); --more) {
            }
            for (auto spins = random() % 300'000; spins > 0; --spins) // a moment that nothing marks
                QCoreApplication::instance();
            ::kill(recorder, SIGKILL);
            while (listen()) { // what it told before it died
            }
            ::close(pipe[0]);
            int status = 0;
            QCOMPARE(::waitpid(recorder, &status, 0), recorder);
            QVERIFY2(WIFSIGNALED(status), std::to_string(WEXITSTATUS(status)).c_str());
            if (!fs::exists(folder))
                continue;

            const auto repaired = repair_folder(folder);
            QVERIFY(repaired.ok());
            for (const RepairedPart& part : *repaired)
                QVERIFY2(part.outcome == Outcome::stored || part.outcome == Outcome::empty,
                         part.sentence.c_str());
            parts_repaired += repaired->size();
            QVERIFY(repair_folder(folder)->empty());
            std::map<std::uint32_t, std::size_t> found;
            for (const auto& entry : fs::directory_iterator(folder)) {
                if (is_temporary(entry.path()))
                    continue;
                QVERIFY(entry.path().extension() == ".flac");
                const auto about = about_recording(entry.path());
                QVERIFY2(about.ok(), about.error().c_str());
                const auto number = static_cast<std::uint32_t>(std::stoul(about->notes.label.person));
                const auto samples = samples_of(entry.path());
                QVERIFY(!found.contains(number));
                found[number] = samples.size();
                const auto sound = noise(20'000, number);
                QVERIFY(samples == widened(std::span(sound).first(samples.size())));
            }
            for (const auto& [number, frames] : safe)
                QVERIFY2(found[number] >= frames, std::to_string(number).c_str());
        }
        QVERIFY(parts_repaired > kills / 2); // most died with a recording going on
    }
};

} // namespace repair_folder_test

TP_TEST(repair_folder_test, RepairFolderTest, event_loop)
#include "repair_folder_test.moc"
