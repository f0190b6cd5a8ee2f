// SPDX-License-Identifier: Apache-2.0
// A Falcon made by umockdev, a real process that pulls with it through the real libusb, and the real guard
// beside that. That the guard may write where the program has claimed is the kernel's deed, and not shown
// here.
#include "../until.hpp"
#include "device/falcon/falcon_usb.hpp"
#include "device/guard/guard_process.hpp"
#include "mock_falcon.hpp"
#include "safe_force.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cstdint>
#include <cstdio>
#include <poll.h>
#include <string>
#include <unistd.h>

using namespace tp;
using mock::UsbFalconBed;
using tp::testing::safe;
using tp::testing::until;

namespace {

Falcon falcon_that_is_plugged_in(const std::string& guard) {
    return Falcon(
        [guard] {
            return open_falcon({"", "FTFALCON"}, guard);
        },
        [] { return testing::falcon_image(); }, "FTFALCON");
}

/// What the killed process does: pulls until its input ends, then stops as a program should. Between the
/// letters 's' and 'g' its loop stands still. Says why it cannot.
int pull(const std::string& guard) {
    Falcon device = falcon_that_is_plugged_in(guard);
    const Result<Capabilities> can = device.open();
    if (!can) {
        std::fprintf(stderr, "%s\n", can.error().c_str());
        return 2;
    }
    pollfd input{STDIN_FILENO, POLLIN, 0};
    char letter = 'g';
    for (double now = 0.0;; now += 0.001) {
        if (poll(&input, 1, letter == 's' ? -1 : 1) > 0 && ::read(STDIN_FILENO, &letter, 1) != 1)
            break;
        if (letter == 's')
            continue;
        device.read(now);
        if (!device.write(device.motors_off() ? SafeForce{} : safe({0.5, 0.3})))
            return 3;
    }
    device.stop();
    return 0;
}

} // namespace

class FalconGuardTest : public QObject {
    Q_OBJECT

    /// A homed Falcon on the bus, and this program again, pulling.
    struct Bench {
        QTemporaryDir folder;
        UsbFalconBed bed;
        QProcess process;
        bool pulled = false; ///< once at least: on a busy machine the guard may have stepped in since

        Bench() {
            bed.with_model([](ModelFalcon& model) {
                model.run_firmware(true);
                model.place_grip(testing::falcon_place({10.0, 2.0}));
            });
            bed.plug_in();
            process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        }
        ~Bench() { end(); }
        void begin() {
            process.start(QCoreApplication::applicationFilePath(),
                          {"--pull", QString::fromStdString(guard_program())});
            process.waitForStarted(-1);
            until([this] {
                pulled = pulls();
                return pulled || process.waitForFinished(0);
            });
        }
        /// The real guard, whose descriptor umockdev knows.
        std::string guard_program() const {
            QFile script(folder.filePath("guard"));
            if (script.open(QIODevice::WriteOnly))
                script.write("#!/bin/sh\nLD_LIBRARY_PATH=${TP_INHERITED_NODE%/*} "
                             "LD_PRELOAD=\"${TP_INHERITED_NODE##*/} $LD_PRELOAD\" exec "
                             "\"$TP_FORCE_GUARD\" \"$@\"\n"); // the name of a library ends at a blank
            script.setPermissions(QFile::ReadOwner | QFile::ExeOwner);
            return script.fileName().toStdString();
        }
        void tell(char letter) {
            process.write(&letter, 1);
            process.waitForBytesWritten(-1);
        }
        void kill() {
            process.kill(); // SIGKILL
            process.waitForFinished(-1);
        }
        void end() {
            process.closeWriteChannel();
            process.waitForFinished(-1);
        }
        /// What the Falcon obeys, which goes on though nobody asks it.
        bool pulls() {
            bool any = false;
            bed.with_model([&any](ModelFalcon& model) {
                model.step();
                any = model.command().motors != std::array<std::int16_t, 3>{};
            });
            return any;
        }
        /// Packets of the guard.
        long apart() { return bed.seen().apart; }
    };
    static constexpr long guards_packets = 3;

private slots:
    void initTestCase() {
        const UsbFalconBed bed;
        QVERIFY2(umockdev_in_mock_environment() != FALSE, "needs umockdev's preloaded library");
    }

    void a_program_killed_in_mid_touch_pulls_no_more() {
        Bench bench;
        bench.begin();
        QVERIFY(bench.pulled);
        const long before = bench.apart(); // on a busy machine it may have stepped in already
        bench.kill();
        until([&] { return bench.apart() >= before + guards_packets; });
        until([&] { return !bench.pulls(); });
    }

    void a_loop_that_stands_still_is_let_go_of_and_goes_on_by_itself() {
        Bench bench;
        bench.begin();
        QVERIFY(bench.pulled);
        const long before = bench.apart();
        bench.tell('s');
        until([&] { return bench.apart() >= before + guards_packets; });
        until([&] { return !bench.pulls(); });
        bench.tell('g');
        until([&] { return bench.pulls(); });
        bench.end();
        QCOMPARE(bench.process.exitCode(), 0);
        QVERIFY(!bench.pulls());
    }

    void a_program_killed_while_its_loop_stands_still_pulls_no_more() {
        Bench bench;
        bench.begin();
        long before = bench.apart();
        bench.tell('s');
        until([&] { return bench.apart() >= before + guards_packets; });
        before = bench.apart();
        bench.kill();
        until([&] { return bench.apart() >= before + guards_packets; });
        QVERIFY(!bench.pulls());
    }

    void a_program_that_stops_takes_leave_and_the_guard_writes_nothing() {
        bool wrote_nothing =
            false; // where the program had to wait for 50 ms on a busy machine, it stepped in
        for (int attempt = 0; attempt < 5 && !wrote_nothing; ++attempt) {
            Bench bench;
            bench.begin();
            QVERIFY(bench.pulled);
            const long before = bench.apart();
            bench.end(); // which waits for the guard
            QCOMPARE(bench.process.exitStatus(), QProcess::NormalExit);
            QCOMPARE(bench.process.exitCode(), 0);
            QVERIFY(!bench.pulls());
            wrote_nothing = bench.apart() == before;
        }
        QVERIFY(wrote_nothing);
    }

    void without_the_guard_the_falcon_does_not_open() {
        Bench bench;
        Falcon device = falcon_that_is_plugged_in("/guard-that-is-not-there");
        const Result<Capabilities> can = device.open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("touchphoto-force-guard, is missing") != std::string::npos,
                 can.error().c_str());
        QVERIFY(!device.write(safe({0.5, 0.0})));
        QVERIFY(!bench.pulls());
        QCOMPARE(bench.bed.seen().released, 1L);
    }
};

int main(int argc, char** argv) {
    if (argc == 3 && std::string(argv[1]) == "--pull")
        return pull(argv[2]);
    QCoreApplication app(argc, argv);
    FalconGuardTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "falcon_guard_test.moc"
