// SPDX-License-Identifier: Apache-2.0
// In the virtual machine: the force pad's firmware with a hand on its knob as a device of the kernel's own,
// and a program with TouchPhoto's registry, back end, servo and safety chain that touches a portrait with it
// through the real hidapi or libusb. All times are the virtual machine's, in which a deadline can be asserted
// (in_vm).
#include "device/force_pad/firmware/pad_firmware.hpp"
#include "touch_bench.hpp"

#include <QTest>

#include <algorithm>
#include <cstdint>

using namespace tp;
using namespace tp::vm;

class ForcePadVmTest : public QObject {
    Q_OBJECT

    static void both_buses() {
        QTest::addColumn<QString>("bus");
        QTest::newRow("hidapi, uhid") << "hid";
        QTest::newRow("libusb, vhci_hcd") << "bulk";
    }
    static double watchdog() { return 1e-6 * pad::cable_pad().watchdog_us; }

private slots:
    void the_lab_lists_and_reads_it_data() { both_buses(); }
    void the_lab_lists_and_reads_it() {
        QFETCH(QString, bus);
        const TouchBench bench("vm_virtual_pad", {bus}, "pad:TPC-0001");
        QCOMPARE(what_the_lab_misses("pad:TPC-0001"), QString());
    }

    /// Round the whole face; nothing is late, and every part of it draws the hand.
    void a_face_is_felt_and_no_tick_is_late_data() { both_buses(); }
    void a_face_is_felt_and_no_tick_is_late() {
        QFETCH(QString, bus);
        TouchBench bench("vm_virtual_pad", {bus}, "pad:TPC-0001");
        bench.begin_to_touch();
        QVERIFY(bench.pulls());
        const double begun = now();
        pass(round_the_face);
        const double ended = now();
        QVERIFY(bench.end_touching());

        QCOMPARE(bench.sessions.size(), std::size_t(1));
        const TouchSession session = bench.sessions[0];
        qInfo("ticks %llu, latest %.1f us, compute p50 %.1f us, max %.1f us",
              static_cast<unsigned long long>(session.ticks), 1e6 * session.latest_s,
              1e6 * session.compute_p50_s, 1e6 * session.compute_max_s);
        QVERIFY(session.real_time);
        QCOMPARE(session.missed, std::uint64_t(0));
        QVERIFY2(session.latest_s < 0.5 * tick, qPrintable(QString::number(session.latest_s)));

        const double most = static_cast<double>(pad::cable_pad().max_force);
        double distance = 0.0;
        std::size_t counted = 0;
        for (std::size_t i = 0; i < bench.snapshots.size(); ++i) {
            const ServoSnapshot& seen = bench.snapshots[i];
            if (i > 0)
                QCOMPARE(seen.ticks, bench.snapshots[i - 1].ticks + 1); // the log is whole
            QVERIFY(length(seen.force()) <= most + 1e-9);
            if (seen.time < begun || seen.time > ended)
                continue;
            distance += std::min(seen.distance, 8.0);
            ++counted;
        }
        QCOMPARE(told_faults(bench.snapshots, begun, ended), QString());
        QCOMPARE(contours_felt(bench.snapshots, begun, ended).size(), contours_of_the_face());
        const double mean = distance / static_cast<double>(counted);
        qInfo("from the lines %.2f mm in the mean, the hand alone 3 mm", mean);
        QVERIFY2(mean < 2.2, qPrintable(QString::number(mean)));

        for (std::size_t i = 1; i < bench.device_log.size(); ++i)
            QVERIFY(length(bench.device_log[i].force) <= most + 0.02);
    }

    void unplugged_in_mid_touch_and_felt_again_data() { both_buses(); }
    void unplugged_in_mid_touch_and_felt_again() {
        QFETCH(QString, bus);
        TouchBench bench("vm_virtual_pad", {bus}, "pad:TPC-0001");
        bench.begin_to_touch();
        QVERIFY(bench.pulls());
        const double pulled_out = now();
        bench.tell('u');
        QVERIFY(comes_true([&] { return bench.sessions.size() == 1; }, 10.0));
        pass(0.1); // the pad's watchdog is slower than the program
        const double ended = now();
        QVERIFY(bench.sessions[0].lost);
        const Fall fall = fall_after(bench.snapshots, pulled_out, ended, Fault::device_lost);
        QVERIFY(fall.noticed > 0.0);
        say("known to be lost after", 1e3 * (fall.noticed - pulled_out));
        QVERIFY(fall.last_force <= fall.noticed + ramp_down);
        const double let_go = last_pull(bench.device_log, pulled_out, ended) - pulled_out;
        say("the pad has let go after", 1e3 * let_go);
        QVERIFY(let_go <= watchdog() + on_the_way);
        QVERIFY(bench.feels() == Vec2(0.0));

        bench.tell('p');
        QVERIFY(bench.pulls());
        QVERIFY(bench.end_touching());
        QCOMPARE(bench.sessions.size(), std::size_t(2));
        QVERIFY(!bench.sessions[1].lost);
    }

    /// A fault of a moment: within 20 ms no force, and it heals.
    void silent_in_mid_touch_data() { both_buses(); }
    void silent_in_mid_touch() {
        QFETCH(QString, bus);
        TouchBench bench("vm_virtual_pad", {bus}, "pad:TPC-0001");
        bench.begin_to_touch();
        QVERIFY(bench.pulls());
        const double fell_silent = now();
        bench.tell('s');
        pass(0.2);
        const double spoke = now();
        const Fall fall = fall_after(bench.snapshots, fell_silent, spoke, Fault::stale_input);
        say("the silence is noticed after", 1e3 * (fall.noticed - fell_silent));
        say("and no force is sent after", 1e3 * (fall.last_force - fall.noticed));
        QVERIFY(fall.noticed > 0.0);
        QVERIFY(fall.noticed <= fell_silent + stale_after + tick + on_the_way);
        QVERIFY(fall.last_force <= fall.noticed + ramp_down);
        const double felt = last_pull(bench.device_log, fall.noticed, spoke) - fall.noticed;
        say("nor felt after", 1e3 * felt);
        QVERIFY(felt <= ramp_down + on_the_way);
        bench.tell('t');
        QVERIFY(bench.pulls());
        QVERIFY(bench.end_touching());
    }

    void killed_in_mid_touch_data() { both_buses(); }
    void killed_in_mid_touch() {
        QFETCH(QString, bus);
        TouchBench bench("vm_virtual_pad", {bus}, "pad:TPC-0001");
        bench.begin_to_touch();
        QVERIFY(bench.pulls());
        const double killed = now();
        bench.kill_toucher();
        pass(0.3);
        const double let_go = last_pull(bench.device_log, killed, now()) - killed;
        say("the pad has let go after", 1e3 * let_go);
        QVERIFY(let_go > 0.0);
        QVERIFY(let_go <= watchdog() + on_the_way);
        QVERIFY(!bench.device_log[bench.device_log.size() - 1].motors);
        bench.begin_to_touch(); // another program finds it as it was
        QVERIFY(bench.pulls());
        QVERIFY(bench.end_touching());
    }
};

QTEST_GUILESS_MAIN(ForcePadVmTest)
#include "force_pad_test.moc"
