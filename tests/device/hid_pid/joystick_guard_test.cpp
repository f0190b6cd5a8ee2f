// SPDX-License-Identifier: Apache-2.0
// A force stick made by umockdev, a real process that pulls with it through the real hidapi, and the real
// guard beside that.
#include "../until.hpp"
#include "device/guard/guard_process.hpp"
#include "device/hid_pid/hid_pid_transport.hpp"
#include "mock_joystick.hpp"
#include "safe_force.hpp"

#include <QCoreApplication>
#include <QProcess>
#include <QTest>

#include <csignal>
#include <cstdio>
#include <memory>
#include <poll.h>
#include <string>
#include <unistd.h>
#include <vector>

using namespace tp;
using mock::JoystickBed;
using tp::testing::safe;
using tp::testing::until;

namespace {

std::string guard_program() { return qEnvironmentVariable("TP_FORCE_GUARD").toStdString(); }

PidJoystick joystick_that_is_plugged_in(const std::string& guard) {
    return PidJoystick(
        [guard]() -> Result<std::unique_ptr<PidTransport>> {
            const std::vector<FoundJoystick> found = find_joysticks();
            return found.empty() ? Result<std::unique_ptr<PidTransport>>(Error{"There is none."})
                                 : open_joystick(found.front(), guard);
        },
        {"force stick", "FS-0001"}, JoystickScale{8.0, {-1.0, -1.0}, true});
}

/// What the killed process does: pulls until its input ends, then stops as a program should. Says why it
/// cannot.
int pull() {
    PidJoystick device = joystick_that_is_plugged_in(guard_program());
    const Result<Capabilities> can = device.open();
    if (!can) {
        std::fprintf(stderr, "%s\n", can.error().c_str());
        return 2;
    }
    double now = 0.0;
    for (pollfd input{STDIN_FILENO, POLLIN, 0}; poll(&input, 1, 1) == 0; now += 0.001) {
        device.read(now);
        if (!device.write(device.motors_off() ? SafeForce{} : safe({0.5, 0.3})))
            return 3;
    }
    device.stop();
    return 0;
}

/// This program again, pulling.
struct Puller {
    QProcess process;
    bool pulled = false; ///< once at least: on a busy machine the guard may have stepped in since

    explicit Puller(JoystickBed& bed) {
        process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        process.start(QCoreApplication::applicationFilePath(), {"--pull"});
        process.waitForStarted(-1);
        until([&] {
            pulled = bed.force() != Vec2(0.0);
            return pulled || process.waitForFinished(0);
        });
    }
    void signal(int number) const { ::kill(static_cast<pid_t>(process.processId()), number); }
    void end() {
        process.closeWriteChannel();
        process.waitForFinished(-1);
    }
};

/// What opening and closing send to the whole device: stop all, reset and enable; and disable.
constexpr long commands_to_open = 3;
constexpr long commands_to_leave = 1;

} // namespace

class JoystickGuardTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const JoystickBed bed;
        QVERIFY2(umockdev_in_mock_environment() != FALSE, "needs umockdev's preloaded library");
    }

    void a_program_killed_in_mid_touch_pulls_no_more() {
        JoystickBed bed;
        QVERIFY(bed.plug_in());
        Puller puller(bed);
        QVERIFY(puller.pulled);
        puller.process.kill(); // SIGKILL
        puller.process.waitForFinished(-1);
        until([&] { return bed.hung_up(); }); // the guard has ended
        QVERIFY(bed.force() == Vec2(0.0));
        QCOMPARE(bed.effects(), std::size_t(0));
        QVERIFY(!bed.motors_on());
    }

    void a_program_that_stands_still_is_let_go_of_and_goes_on_by_itself() {
        JoystickBed bed;
        QVERIFY(bed.plug_in());
        Puller puller(bed);
        QVERIFY(puller.pulled);
        puller.signal(SIGSTOP);
        until([&] { return bed.force() == Vec2(0.0); });
        QCOMPARE(bed.effects(), std::size_t(2));
        QVERIFY(bed.motors_on());
        puller.signal(SIGCONT);
        until([&] { return bed.force() != Vec2(0.0); });
        puller.end();
        QCOMPARE(puller.process.exitCode(), 0);
        until([&] { return bed.hung_up(); });
        QVERIFY(bed.force() == Vec2(0.0));
    }

    void a_program_killed_while_it_stands_still_pulls_no_more() {
        JoystickBed bed;
        QVERIFY(bed.plug_in());
        Puller puller(bed);
        puller.signal(SIGSTOP);
        until([&] { return bed.force() == Vec2(0.0); });
        puller.process.kill();
        puller.process.waitForFinished(-1);
        until([&] { return bed.hung_up(); });
        QVERIFY(bed.force() == Vec2(0.0));
        QVERIFY(!bed.motors_on());
    }

    void a_program_that_stops_takes_leave_and_the_guard_writes_nothing() {
        JoystickBed bed;
        QVERIFY(bed.plug_in());
        Puller puller(bed);
        QVERIFY(puller.pulled);
        puller.end();
        QCOMPARE(puller.process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(puller.process.exitCode(), 0);
        until([&] { return bed.hung_up(); });
        QVERIFY(bed.force() == Vec2(0.0));
        QCOMPARE(bed.commands(), commands_to_open + commands_to_leave); // all of them the program's own
    }

    void while_one_program_pulls_another_is_told_and_afterwards_it_is_let_in() {
        JoystickBed bed;
        QVERIFY(bed.plug_in());
        Puller puller(bed);
        QVERIFY(puller.pulled);
        PidJoystick device = joystick_that_is_plugged_in(guard_program());
        const Result<Capabilities> refused = device.open();
        QVERIFY2(refused.error().find("Another program uses the force stick") != std::string::npos,
                 refused.error().c_str());
        // It was not disturbed: without its effects it would pull no more.
        until([&] { return bed.force() != Vec2(0.0); });
        puller.process.kill();
        puller.process.waitForFinished(-1);
        until([&] { return bed.commands() >= commands_to_open + commands_to_leave; });
        const Result<Capabilities> can = device.open(); // waits for the guard of the one that was killed
        QVERIFY2(can.ok(), can.error().c_str());
        until([&] { return bed.motors_on(); }); // commands are not answered, so they may be heard later
        QCOMPARE(bed.commands(), 2 * commands_to_open + commands_to_leave);
        QCOMPARE(bed.effects(), std::size_t(2));
    }

    void without_the_guard_the_joystick_does_not_open() {
        JoystickBed bed;
        QVERIFY(bed.plug_in());
        PidJoystick device = joystick_that_is_plugged_in(guard_program() + "-that-is-not-there");
        const Result<Capabilities> can = device.open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("touchphoto-force-guard, is missing") != std::string::npos,
                 can.error().c_str());
        QVERIFY(!device.write(safe({0.5, 0.0})));
        until([&] { return bed.hung_up(); });
        QCOMPARE(bed.effects(), std::size_t(0));
        QVERIFY(!bed.motors_on());
    }
};

int main(int argc, char** argv) {
    if (argc == 2 && std::string(argv[1]) == "--pull")
        return pull();
    QCoreApplication app(argc, argv);
    JoystickGuardTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "joystick_guard_test.moc"
