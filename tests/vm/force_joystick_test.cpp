// SPDX-License-Identifier: Apache-2.0
// In the virtual machine: a force stick's model as a HID device of the kernel's own, touched through the real
// hidapi.
#include "touch_stories.hpp"

#include <QTest>

using namespace tp;
using namespace tp::vm;

class ForceJoystickVmTest : public QObject {
    Q_OBJECT

    struct Bench : TouchBench {
        Bench() : TouchBench("vm_virtual_joystick", {}, "stick:FS-0001") { begin_to_touch(); }
    };

private slots:
    void a_face_is_felt_and_no_tick_is_late() {
        Bench bench;
        feels_the_whole_face(bench, "stick");
    }

    void the_lab_lists_and_reads_it() {
        const TouchBench bench("vm_virtual_joystick", {}, "stick:FS-0001");
        QCOMPARE(what_the_lab_misses("stick:FS-0001"), QString());
    }

    void unplugged_in_mid_touch_and_felt_again() {
        Bench bench;
        is_lost_and_felt_again(bench);
    }

    /// A stick has no watchdog: the program that is told to end takes the force away itself.
    void terminated_in_mid_touch() {
        Bench bench;
        QVERIFY(bench.pulls());
        const double told = now();
        bench.terminate_toucher();
        pass(0.2);
        const double let_go = last_pull(bench.device_log, told, now()) - told;
        say("the stick has let go after", 1e3 * let_go);
        QVERIFY(let_go <= on_the_way);
    }

    /// Of one that is killed the guard takes it away.
    void killed_in_mid_touch() {
        Bench bench;
        QVERIFY(bench.pulls());
        const double killed = now();
        bench.kill_toucher();
        pass(0.3);
        const double let_go = last_pull(bench.device_log, killed, now()) - killed;
        say("the stick has let go after", 1e3 * let_go);
        QVERIFY(let_go <= guarded);
        QVERIFY(bench.feels() == Vec2(0.0));
    }

    /// Nor does it pull when it goes on: a loop that stood still has let go itself.
    void stopped_in_mid_touch() {
        Bench bench;
        QVERIFY(bench.pulls());
        const double stopped = now();
        bench.stop_toucher();
        pass(0.3);
        const double let_go = last_pull(bench.device_log, stopped, now()) - stopped;
        say("the stick has let go after", 1e3 * let_go);
        QVERIFY(let_go <= guarded);
        QVERIFY(bench.feels() == Vec2(0.0));
        const double went_on = now();
        bench.go_on_touching();
        pass(0.3);
        QVERIFY(last_pull(bench.device_log, went_on, now()) - went_on <= on_the_way);
        QVERIFY(bench.end_touching());
    }
};

QTEST_GUILESS_MAIN(ForceJoystickVmTest)
#include "force_joystick_test.moc"
