// SPDX-License-Identifier: Apache-2.0
// A board behind a real pseudo-terminal, a real process that pulls on it, and the real guard beside that.
#include "puller.hpp"

#include <QCoreApplication>
#include <QTest>

#include <csignal>
#include <sys/wait.h>

using tp::testing::PtyBoard;
using tp::testing::Puller;
using tp::testing::until;

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

    void bytes_pass_a_serial_port_as_they_are_until_it_is_gone() {
        const int master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
        grantpt(master);
        unlockpt(master);
        QProcess process;
        process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        tp::testing::start_puller(process, {"echo", tp::testing::port_name(ptsname(master))});
        QVERIFY(process.waitForReadyRead(-1));
        std::vector<std::uint8_t> all(256);
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<std::uint8_t>(i); // among them Ctrl-C, XON, line ends and 0xFF
        QCOMPARE(::write(master, all.data(), all.size()), static_cast<ssize_t>(all.size()));
        std::vector<std::uint8_t> back;
        while (back.size() < all.size()) {
            std::uint8_t some[64];
            const ssize_t got = ::read(master, some, sizeof some);
            QVERIFY(got > 0);
            back.insert(back.end(), some, some + got);
        }
        QVERIFY(back == all);
        ::close(master);
        process.waitForFinished(-1);
        QCOMPARE(process.exitCode(), 0);
    }

    void a_port_that_another_program_uses_or_that_is_none_is_a_sentence() {
        const bool on_windows = qEnvironmentVariableIsSet("TP_WINE_PREFIX");
        const auto said_of = [](const QString& port) {
            QProcess process;
            tp::testing::start_puller(process, {"echo", port});
            process.waitForFinished(-1);
            return process.readAllStandardError();
        };
        QVERIFY(said_of(on_windows ? "COM99" : "/dev/none").contains("unplugged"));
        QVERIFY(said_of(on_windows ? "NUL" : "/dev/null").contains("could not be opened"));
        if (on_windows || geteuid() == 0)
            return; // Wine opens a port twice, and Linux does for root
        PtyBoard board;
        QProcess first;
        tp::testing::start_puller(first, {"echo", QString::fromStdString(board.path())});
        QVERIFY(first.waitForReadyRead(-1));
        QVERIFY(said_of(QString::fromStdString(board.path())).contains("Close "));
        first.kill();
        first.waitForFinished(-1);
    }

    void a_guard_that_is_not_there_or_does_not_start_is_a_sentence_and_nothing_is_sent() {
        PtyBoard board;
        const QString guard = qEnvironmentVariable("TP_FORCE_GUARD");
        const auto said_with = [&](const QString& program) {
            QProcess process;
            tp::testing::start_puller(process, {"pull", tp::testing::port_name(board.path()), program});
            process.waitForFinished(-1);
            return process.exitCode() == 2 ? process.readAllStandardError() : QByteArray();
        };
        QVERIFY(said_with(guard + "-that-is-not-there").contains("touchphoto-force-guard, is missing"));
        QVERIFY(said_with(tp::testing::puller_command().last()).contains("does not start"));
        QCOMPARE(board.heard(), std::uint64_t(0)); // nothing is sent that nobody would take back
    }
};

QTEST_GUILESS_MAIN(BoardGuardTest)
#include "board_guard_test.moc"
