// SPDX-License-Identifier: Apache-2.0
// A board behind a real pseudo-terminal, a real process that pulls on it, and the real guard beside that.
#include "../until.hpp"
#include "device/guard/guard_process.hpp"
#include "device/haply_2diy/haply_2diy.hpp"
#include "device/haply_2diy/model_board.hpp"
#include "device/haply_2diy/posix_serial.hpp"
#include "safe_force.hpp"

#include <QCoreApplication>
#include <QProcess>
#include <QTest>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <mutex>
#include <poll.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace tp;
using tp::testing::safe;
using tp::testing::until;

namespace {

std::string guard_program() { return qEnvironmentVariable("TP_FORCE_GUARD").toStdString(); }

Haply2diy::Opener over(const std::string& path, const std::string& program) {
    return [path, program]() -> Result<Haply2diy::Board> {
        auto line = PosixSerial::open(path, "Haply 2diy");
        if (!line)
            return Error{line.error()};
        const Pantograph arms(HaplyGeneration::third);
        auto guard =
            start_force_guard(program, (*line)->descriptor(),
                              {"board", guard_word(encode(arms.set_up(arms.reference_deg())).view())});
        if (!guard)
            return Error{guard.error()};
        return Haply2diy::Board{std::move(*line), std::move(*guard), {}, "X"};
    };
}

/// What the killed process does: pulls until its input ends, then stops as a program should. Says what it
/// sees.
int pull(const std::string& path, const std::string& program) {
    Haply2diy device(HaplyGeneration::third, over(path, program));
    const auto can = device.open();
    const auto homed = can ? device.home() : Result<bool>(Error{can.error()});
    if (!homed) {
        std::fprintf(stderr, "%s\n", homed.error().c_str());
        return 2;
    }
    double now = 0.0;
    std::string said;
    for (pollfd input{STDIN_FILENO, POLLIN, 0}; poll(&input, 1, 1) == 0; now += 0.001) {
        device.read(now);
        if (!device.write(safe({0.5, 0.3})))
            return 3;
        if (const std::string complaint = device.complaint(); complaint != said) {
            std::printf("%s\n", complaint.c_str());
            std::fflush(stdout);
            said = complaint;
        }
    }
    device.stop();
    return 0;
}

/// A board at the other end of a pseudo-terminal, on a thread of its own.
class PtyBoard {
public:
    PtyBoard() : master_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)) {
        grantpt(master_);
        unlockpt(master_);
        path_ = ptsname(master_);
        thread_ = std::thread([this] { serve(); });
    }
    ~PtyBoard() {
        quit_.store(true);
        thread_.join();
        ::close(master_);
    }
    PtyBoard(const PtyBoard&) = delete;
    PtyBoard& operator=(const PtyBoard&) = delete;

    std::string path() const { return path_; }
    bool pulls() {
        const std::scoped_lock lock(mutex_);
        return board_.torques() != std::array<double, 2>{};
    }
    bool is_set_up() {
        const std::scoped_lock lock(mutex_);
        return board_.set_up();
    }
    /// Nobody has the line open.
    bool hung_up() const { return hung_up_.load(); }
    std::uint64_t heard() const { return heard_.load(); }
    /// The board gets these before what comes next, as the beginning of a frame that was never ended: a
    /// command with the torque of the first motor, 0.1 N·m, which the next bytes of whatever kind complete.
    void begin_a_frame() {
        const std::scoped_lock lock(mutex_);
        for (const std::uint8_t byte : std::array<std::uint8_t, 6>{2, 5, 0xcd, 0xcc, 0xcc, 0x3d})
            board_.receive(byte);
    }

private:
    void serve() {
        while (!quit_.load()) {
            pollfd one{master_, POLLIN, 0};
            poll(&one, 1, 1);
            std::uint8_t bytes[256];
            const ssize_t got = ::read(master_, bytes, sizeof bytes);
            hung_up_.store(got < 0 && errno == EIO);
            if (got <= 0) {
                std::this_thread::sleep_for(std::chrono::microseconds(100));
                continue;
            }
            const std::scoped_lock lock(mutex_);
            heard_.fetch_add(static_cast<std::uint64_t>(got));
            for (ssize_t i = 0; i < got; ++i) {
                board_.receive(bytes[i]);
                send_the_answer();
            }
        }
    }
    void send_the_answer() {
        const std::vector<std::uint8_t> answer(board_.sent().begin(), board_.sent().end());
        board_.sent().clear();
        if (answer.empty())
            return;
        if (::write(master_, answer.data(), answer.size()) < 0)
            hung_up_.store(true);
        std::this_thread::sleep_for(
            std::chrono::microseconds(300)); // a board is no faster: it is read before the next
    }

    int master_;
    std::string path_;
    std::mutex mutex_;
    ModelBoard board_{HaplyGeneration::third};
    std::atomic<bool> quit_{false};
    std::atomic<bool> hung_up_{false};
    std::atomic<std::uint64_t> heard_{0};
    std::thread thread_;
};

/// This program again, pulling.
struct Puller {
    static constexpr int most_attempts = 20;
    QProcess process;
    bool pulled = false; ///< once at least: on a busy machine the guard may have stepped in since

    explicit Puller(PtyBoard& board) {
        process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        // On a busy machine the board may answer too late for a program that opens it.
        for (int attempt = 0; attempt < most_attempts && !pulled; ++attempt) {
            until([&] { return attempt == 0 || board.hung_up(); });
            process.start(
                QCoreApplication::applicationFilePath(),
                {"--pull", QString::fromStdString(board.path()), QString::fromStdString(guard_program())});
            process.waitForStarted(-1);
            until([&] {
                pulled = board.pulls();
                return pulled || process.state() == QProcess::NotRunning || process.waitForFinished(0);
            });
        }
    }
};

} // namespace

class BoardGuardTest : public QObject {
    Q_OBJECT
private slots:
    void a_program_killed_in_mid_touch_pulls_no_more() {
        PtyBoard board;
        Puller puller(board);
        QVERIFY(puller.pulled);
        puller.process.kill(); // SIGKILL
        puller.process.waitForFinished(-1);
        until([&] { return board.hung_up(); }); // the guard has ended
        QVERIFY(!board.pulls());
        QVERIFY(board.is_set_up()); // in step: it counts on
    }

    void a_program_killed_with_a_frame_half_written_pulls_no_more() {
        PtyBoard board;
        Puller puller(board);
        QVERIFY(puller.pulled);
        const auto process = static_cast<pid_t>(puller.process.processId());
        ::kill(process, SIGSTOP);
        siginfo_t stopped{};
        QCOMPARE(waitid(P_PID, static_cast<id_t>(process), &stopped, WSTOPPED | WNOWAIT), 0);
        board.begin_a_frame();
        puller.process.kill();
        puller.process.waitForFinished(-1);
        until([&] { return board.hung_up(); });
        QVERIFY(!board.pulls());
        QVERIFY(!board.is_set_up()); // its angles are to be believed no more
    }

    void a_program_killed_while_the_board_is_out_of_step_pulls_no_more() {
        for (int attempt = 0; attempt < 20; ++attempt) { // each is killed elsewhere in what it sends
            PtyBoard board;
            Puller puller(board);
            QVERIFY(puller.pulled);
            board.begin_a_frame();
            const std::uint64_t before = board.heard();
            until([&] {
                return board.heard() > before + static_cast<std::uint64_t>(attempt % 5) ||
                       puller.process.waitForFinished(0);
            });
            puller.process.kill();
            puller.process.waitForFinished(-1);
            until([&] { return board.hung_up(); });
            QVERIFY2(!board.pulls(), qPrintable(QString("attempt %1").arg(attempt)));
        }
    }

    void a_program_that_stands_still_is_let_go_of_and_hears_of_it() {
        PtyBoard board;
        Puller puller(board);
        QVERIFY(puller.pulled);
        const auto process = static_cast<pid_t>(puller.process.processId());
        QString words;
        until([&] { // on a busy machine the board may have been behind, and the guard not yet due
            ::kill(process, SIGSTOP);
            until([&] { return !board.pulls(); });
            ::kill(process, SIGCONT);
            puller.process.waitForReadyRead(1000);
            words += puller.process.readAllStandardOutput();
            return words.contains("watches over the motors");
        });
        until([&] { return !board.pulls(); });
        puller.process.closeWriteChannel();
        puller.process.waitForFinished(-1);
        QCOMPARE(puller.process.exitCode(), 0);
        until([&] { return board.hung_up(); });
        QVERIFY(!board.pulls());
    }

    void a_program_that_stops_takes_leave_and_the_board_counts_on() {
        PtyBoard board;
        Puller puller(board);
        QVERIFY(puller.pulled);
        puller.process.closeWriteChannel();
        puller.process.waitForFinished(-1);
        QCOMPARE(puller.process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(puller.process.exitCode(), 0);
        until([&] { return board.hung_up(); });
        QVERIFY(!board.pulls());
        QVERIFY(board.is_set_up());
    }

    void without_the_guard_the_device_does_not_open() {
        PtyBoard board;
        Haply2diy device(HaplyGeneration::third, over(board.path(), guard_program() + "-that-is-not-there"));
        const auto can = device.open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("touchphoto-force-guard, is not beside this one") != std::string::npos,
                 can.error().c_str());
        QVERIFY(!device.read(0.0));
        QCOMPARE(board.heard(), std::uint64_t(0)); // nothing is sent that nobody would take back
    }

    void a_guard_that_does_not_start_is_said() {
        PtyBoard board;
        Haply2diy device(HaplyGeneration::third, over(board.path(), "/bin/true"));
        const auto can = device.open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("does not start") != std::string::npos, can.error().c_str());
    }

    void what_is_no_serial_port_is_refused_with_a_sentence() {
        QVERIFY(PosixSerial::open("/dev/null", "Haply 2diy").error().find("could not be opened") !=
                std::string::npos);
        QVERIFY(PosixSerial::open("/dev/none", "Haply 2diy").error().find("unplugged") != std::string::npos);
    }

    void bytes_pass_a_serial_port_as_they_are() {
        const int master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
        grantpt(master);
        unlockpt(master);
        auto line = PosixSerial::open(ptsname(master), "Haply 2diy");
        QVERIFY(line.ok());
        std::vector<std::uint8_t> all(256);
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<std::uint8_t>(i); // among them Ctrl-C, XON, line ends and 0xFF
        QVERIFY((*line)->write(all));
        std::vector<std::uint8_t> there;
        while (there.size() < all.size()) {
            std::uint8_t some[64];
            const ssize_t got = ::read(master, some, sizeof some);
            QVERIFY(got > 0);
            there.insert(there.end(), some, some + got);
        }
        QVERIFY(there == all);
        QCOMPARE(::write(master, all.data(), all.size()), static_cast<ssize_t>(all.size()));
        std::vector<std::uint8_t> back;
        while (back.size() < all.size()) {
            std::uint8_t some[64];
            const int got = (*line)->read(some, 1000);
            QVERIFY(got > 0);
            back.insert(back.end(), some, some + got);
        }
        QVERIFY(back == all);
        std::uint8_t none[4];
        QCOMPARE((*line)->read(none, 0), 0);
        ::close(master);
        QCOMPARE((*line)->read(none, 0), -1);
        QVERIFY(!(*line)->write(all));
    }
};

int main(int argc, char** argv) {
    if (argc == 4 && std::string(argv[1]) == "--pull")
        return pull(argv[2], argv[3]);
    QCoreApplication app(argc, argv);
    BoardGuardTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "board_guard_test.moc"
