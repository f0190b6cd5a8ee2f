// SPDX-License-Identifier: Apache-2.0
// In the virtual machine: a force stick's model as a HID device of the kernel's own, touched through the real
// hidapi.
#include "touch_bench.hpp"

#include <QTest>

#include <cstddef>
#include <cstdint>

using namespace tp;
using namespace tp::vm;

namespace {
constexpr double guarded = 0.010;        ///< s, in which a program ends and the guard has its turn
constexpr double guards_silence = 0.050; ///< s without a sign of life
} // namespace

class ForceStickVmTest : public QObject {
    Q_OBJECT

    struct Bench : TouchBench {
        Bench() : TouchBench("vm_virtual_stick", {}, "stick:FS-0001") { begin_to_touch(); }
    };

private slots:
    /// Every part of the face draws the hand, and nothing is late.
    void a_face_is_felt_and_no_tick_is_late() {
        Bench bench;
        QVERIFY(bench.pulls());
        const double begun = now();
        pass(round_the_face);
        const double ended = now();
        QVERIFY(bench.end_touching());
        QCOMPARE(bench.sessions.size(), std::size_t(1));
        const TouchSession session = bench.sessions[0];
        say("latest tick", 1e3 * session.latest_s);
        QCOMPARE(session.missed, std::uint64_t(0));
        QVERIFY(session.latest_s < 0.5 * tick);
        QCOMPARE(told_faults(bench.snapshots, begun, ended), QString());
        QCOMPARE(contours_felt(bench.snapshots, begun, ended).size(), contours_of_the_face());
    }

    void the_lab_lists_and_reads_it() {
        const TouchBench bench("vm_virtual_stick", {}, "stick:FS-0001");
        QCOMPARE(what_the_lab_misses("stick:FS-0001"), QString());
    }

    void unplugged_in_mid_touch_and_felt_again() {
        Bench bench;
        QVERIFY(bench.pulls());
        const double pulled_out = now();
        bench.tell('u');
        QVERIFY(comes_true([&] { return bench.sessions.size() == 1; }, 10.0));
        QVERIFY(bench.sessions[0].lost);
        const Fall fall = fall_after(bench.snapshots, pulled_out, now(), Fault::device_lost);
        QVERIFY(fall.noticed > 0.0);
        say("known to be lost after", 1e3 * (fall.noticed - pulled_out));
        QVERIFY(fall.last_force <= fall.noticed + ramp_down);
        bench.tell('p');
        QVERIFY(bench.pulls());
        QVERIFY(bench.end_touching());
        QVERIFY(!bench.sessions[1].lost);
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

    /// As long as it stands still it pulls nothing.
    void stopped_in_mid_touch() {
        Bench bench;
        QVERIFY(bench.pulls());
        const double stopped = now();
        bench.stop_toucher();
        pass(0.3);
        const double let_go = last_pull(bench.device_log, stopped, now()) - stopped;
        say("the stick has let go after", 1e3 * let_go);
        QVERIFY(let_go <= guards_silence + guarded);
        QVERIFY(bench.feels() == Vec2(0.0));
        bench.go_on_touching();
        QVERIFY(bench.pulls());
        QVERIFY(bench.end_touching());
    }
};

QTEST_GUILESS_MAIN(ForceStickVmTest)
#include "force_stick_test.moc"
