// SPDX-License-Identifier: Apache-2.0
// Large files that are given up: another process waits for the disk.
#include "core/files/file_system.hpp"
#include "core/files/open_file.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <poll.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

using namespace tp;
namespace fs = std::filesystem;

class HeldElsewhereTest : public QObject {
    Q_OBJECT
    QTemporaryDir dir_;
    fs::path file_;

    void write(off_t bytes) const {
        const OpenFile file(file_, {.read = false, .write = true, .make = true});
        QVERIFY(file.ok() && ::posix_fallocate(file.number(), 0, bytes) == 0);
    }
    /// Processes beside this one that have the file open, whether or not it still has its name.
    int holders() const {
        int count = 0;
        std::error_code error;
        for (const auto& process : fs::directory_iterator("/proc"))
            if (process.path().filename() != std::to_string(::getpid()))
                for (fs::directory_iterator at(process.path() / "fd", error), end; !error && at != end;
                     at.increment(error)) {
                    std::error_code gone;
                    count += fs::read_symlink(at->path(), gone).string().starts_with(file_.string()) ? 1 : 0;
                }
        return count;
    }

private slots:
    void initTestCase() {
        const HeldElsewhere none({});
        if (!fs::exists("/proc/self/fd"))
            QSKIP("nothing here tells which process has which file open");
    }
    void init() {
        file_ = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        write(80 << 20);
    }
    void cleanup() { fs::remove(file_); }

    void another_process_has_a_large_file_until_it_is_let_go() {
        std::optional<HeldElsewhere> held;
        held.emplace(std::vector<fs::path>{file_, "/no/such/file"});
        QCOMPARE(remove_name(file_), 0);
        QCOMPARE(holders(), 1);
        QVERIFY(::waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD); // nobody has to wait for its end
        held.reset();
        QTRY_COMPARE_WITH_TIMEOUT(holders(), 0, 60'000);
    }

    void a_small_file_needs_no_other_process() {
        fs::remove(file_);
        write(1 << 20);
        const HeldElsewhere held({file_});
        QCOMPARE(holders(), 0);
    }

    /// Who reads what this program says, or waits for its lock, waits for this program only.
    void nothing_else_of_ours_is_held() {
        std::array<int, 2> said{};
        QCOMPARE(::pipe2(said.data(), O_CLOEXEC), 0);
        const fs::path lock = file_.string() + ".lock";
        OpenFile first(lock, {.write = true, .make = true});
        QVERIFY(first.lock());
        const HeldElsewhere held({file_});
        ::close(said[1]);
        first.close();
        pollfd end{said[0], POLLIN, 0};
        QCOMPARE(::poll(&end, 1, 60'000), 1);
        QVERIFY((end.revents & POLLHUP) != 0);
        ::close(said[0]);
        const OpenFile second(lock, {.write = true});
        QTRY_VERIFY_WITH_TIMEOUT(second.lock(), 60'000);
    }
};

QTEST_GUILESS_MAIN(HeldElsewhereTest)
#include "held_elsewhere_test.moc"
