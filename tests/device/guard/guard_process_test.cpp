// SPDX-License-Identifier: Apache-2.0
// The real guard beside this program; its device is a pipe.
#include "device/guard/guard_process.hpp"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <fcntl.h>
#include <memory>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace tp;
using Word = ForceGuard::Word;

namespace {

std::string guard_program() { return qEnvironmentVariable("TP_FORCE_GUARD").toStdString(); }

/// A device that takes whatever is written and does nothing.
class PipeDevice {
public:
    PipeDevice() {
        std::array<int, 2> ends{-1, -1};
        made_ = ::pipe2(ends.data(), O_CLOEXEC) == 0;
        heard_ = ends[0];
        told_ = ends[1];
    }
    ~PipeDevice() {
        ::close(heard_);
        if (told_ >= 0)
            ::close(told_);
    }
    PipeDevice(const PipeDevice&) = delete;
    PipeDevice& operator=(const PipeDevice&) = delete;

    Result<std::unique_ptr<ForceGuard>>
    guarded(const std::vector<std::string>& words = {"reports", "050100", "050200", "then", "0c02"},
            const std::string& program = guard_program()) {
        auto guard = start_force_guard(program, told_, words);
        ::close(std::exchange(told_, -1));
        return guard;
    }
    /// So many bytes as soon as they are there; fewer where nobody has it open any more.
    std::vector<std::uint8_t> heard(std::size_t most) {
        std::vector<std::uint8_t> all;
        std::array<std::uint8_t, 64> some{};
        ssize_t got = 1;
        while (all.size() < most && got > 0) {
            got = ::read(heard_, some.data(), std::min(some.size(), most - all.size()));
            all.insert(all.end(), some.begin(), some.begin() + std::max<ssize_t>(got, 0));
        }
        return all;
    }
    /// All that is written until nobody has it open any more.
    std::vector<std::uint8_t> heard_to_the_end() { return heard(1u << 20); }

private:
    bool made_ = false;
    int heard_ = -1;
    int told_ = -1;
};

using Bytes = std::vector<std::uint8_t>;
const Bytes no_force{5, 1, 0, 5, 2, 0};
const Bytes all_of_it{5, 1, 0, 5, 2, 0, 12, 2};

#if defined(__linux__)
/// The processes that this one has started; the test starts one at a time.
std::vector<pid_t> started_processes() {
    std::vector<pid_t> all;
    const QString tasks = "/proc/self/task/";
    for (const QString& task : QDir(tasks).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile file(tasks + task + "/children");
        if (file.open(QIODevice::ReadOnly))
            for (const QByteArray& child : file.readAll().simplified().split(' '))
                if (!child.isEmpty())
                    all.push_back(child.toInt());
    }
    return all;
}
#endif

/// The guard's word once it is another than that it watches: CTest ends a test that waits for ever.
Word next_word(ForceGuard& guard) {
    for (;;) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (const Word word = guard.beat(false); word != Word::here)
            return word;
    }
}

} // namespace

class GuardProcessTest : public QObject {
    Q_OBJECT
private slots:
    void whose_program_is_gone_while_it_pulls_takes_the_force_away() {
        PipeDevice device;
        auto guard = device.guarded();
        QVERIFY2(guard.ok(), guard.error().c_str());
        QVERIFY((*guard)->beat(true) == Word::here);
        guard->reset();
        QVERIFY(device.heard_to_the_end() == all_of_it);
    }

    void whose_program_is_gone_without_a_force_writes_nothing() {
        PipeDevice device;
        auto guard = device.guarded();
        QVERIFY((*guard)->beat(true) == Word::here);
        QVERIFY((*guard)->beat(false) == Word::here);
        guard->reset();
        QVERIFY(device.heard_to_the_end().empty());
    }

    /// As a process of the person's that somebody has taken over may.
    void it_watches_on_whatever_signal_it_gets() {
#if defined(__linux__)
        PipeDevice device;
        auto guard = device.guarded();
        QVERIFY((*guard)->beat(true) == Word::here);
        const std::vector<pid_t> processes = started_processes();
        QCOMPARE(processes.size(), std::size_t{1});
        for (int signal = 1; signal <= SIGRTMAX; ++signal) {
            const bool unavoidable = signal == SIGKILL || signal == SIGSTOP;
            const bool own_fault = signal == SIGILL || signal == SIGTRAP || signal == SIGABRT ||
                                   signal == SIGBUS || signal == SIGFPE || signal == SIGSEGV ||
                                   signal == SIGSYS;
            const bool of_libc = signal > SIGSYS && signal < SIGRTMIN;
            if (!unavoidable && !own_fault && !of_libc)
                QCOMPARE(::kill(processes.front(), signal), 0);
        }
        QVERIFY((*guard)->beat(true) != Word::gone); // on a busy machine it may have stepped in meanwhile
        guard->reset();
        const std::vector<std::uint8_t> heard = device.heard_to_the_end();
        QVERIFY(heard.size() >= all_of_it.size() &&
                std::equal(all_of_it.rbegin(), all_of_it.rend(), heard.rbegin()));
#else
        QSKIP("which process the guard is, is not known here");
#endif
    }

    void that_was_dismissed_writes_nothing() {
        PipeDevice device;
        auto guard = device.guarded();
        QVERIFY((*guard)->beat(true) == Word::here);
        (*guard)->dismiss();
        QVERIFY(device.heard_to_the_end().empty()); // and it has ended though this program goes on
        QVERIFY((*guard)->beat(true) == Word::gone);
    }

    void whose_program_stands_still_while_it_pulls_lets_go_and_says_so_once() {
        PipeDevice device;
        auto guard = device.guarded();
        QVERIFY((*guard)->beat(true) == Word::here);
        QVERIFY(device.heard(no_force.size()) == no_force); // as long as nothing is said
        QVERIFY(next_word(**guard) == Word::stepped_in);
        QVERIFY((*guard)->beat(false) == Word::here);
        QVERIFY((*guard)->beat(true) == Word::here); // and it goes on watching
        guard->reset();
        QVERIFY(device.heard_to_the_end() == all_of_it);
    }

    /// A program that stood still between its sign of life and what it wrote may have a force on the device.
    void that_has_let_go_lets_go_again_when_the_program_is_gone() {
        PipeDevice device;
        auto guard = device.guarded();
        QVERIFY((*guard)->beat(true) == Word::here);
        QVERIFY(device.heard(no_force.size()) == no_force);
        guard->reset();
        QVERIFY(device.heard_to_the_end() == all_of_it);
    }

    void that_died_is_noticed_at_the_next_sign_of_life() {
        const QTemporaryDir folder;
        PipeDevice device;
        auto guard = device.guarded({}, script(folder, "printf r >&4"));
        QVERIFY2(guard.ok(), guard.error().c_str());
        QVERIFY(device.heard_to_the_end().empty()); // it has ended
        QVERIFY((*guard)->beat(true) == Word::gone);
    }

    /// Nobody waits for a guard that gets no time to run; nor does anything pull without one that listens.
    void that_does_not_listen_is_not_waited_for() {
        const QTemporaryDir folder;
        const QString number = folder.filePath("number");
        PipeDevice device;
        auto guard = device.guarded(
            {}, script(folder, "echo $$ >" + number.toStdString() + "; printf r >&4; kill -STOP $$"));
        QVERIFY2(guard.ok(), guard.error().c_str());
        QFile file(number);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const auto process = static_cast<pid_t>(file.readAll().trimmed().toInt());
        siginfo_t stopped{};
        QCOMPARE(waitid(P_PID, static_cast<id_t>(process), &stopped, WSTOPPED | WNOWAIT), 0);
        Word word = Word::here;
        for (int i = 0; i < 1000000 && word == Word::here; ++i)
            word = (*guard)->beat(true);
        ::kill(process, SIGCONT);
        QVERIFY(word == Word::stepped_in);
    }

    void that_is_missing_or_does_not_start_is_said() {
        PipeDevice missing;
        QVERIFY(missing.guarded({"reports", "00"}, guard_program() + "-that-is-not-there")
                    .error()
                    .find("is missing") != std::string::npos);
        for (const std::vector<std::string>& words : {std::vector<std::string>{},
                                                      {"reports"},
                                                      {"reports", "then", "0c02"},
                                                      {"reports", "0"},
                                                      {"reports", "0g"},
                                                      {"reports", ""},
                                                      {"board", "0102"},
                                                      {"packet", "02"},
                                                      {"packet", "0202", "00"},
                                                      {"another", "00"}}) {
            PipeDevice device;
            const std::string error = device.guarded(words).error();
            QVERIFY2(error.find("does not start") != std::string::npos, error.c_str());
        }
    }

    void words_are_bytes() {
        const Bytes bytes{0x00, 0x0f, 0xa5, 0xff};
        QCOMPARE(guard_word(bytes), std::string("000fa5ff"));
    }

private:
    static std::string script(const QTemporaryDir& folder, const std::string& lines) {
        QFile file(folder.filePath("guard"));
        if (!file.open(QIODevice::WriteOnly))
            return {};
        file.write(("#!/bin/sh\n" + lines + "\n").c_str());
        file.setPermissions(QFile::ReadOwner | QFile::ExeOwner);
        return file.fileName().toStdString();
    }
};

QTEST_APPLESS_MAIN(GuardProcessTest)
#include "guard_process_test.moc"
