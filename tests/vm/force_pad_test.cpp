// SPDX-License-Identifier: Apache-2.0
// In the virtual machine: the force pad's firmware with a hand on its knob as a device of the kernel's own,
// and a program with TouchPhoto's registry, back end, servo and safety chain that touches a portrait with it
// through the real hidapi or libusb. All times are the virtual machine's, in which a deadline can be asserted
// (in_vm).
#include "device/force_pad/firmware/pad_firmware.hpp"
#include "touch_stories.hpp"

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

    /// Nothing is late, and every part of the face draws the hand.
    void a_face_is_felt_and_no_tick_is_late_data() { both_buses(); }
    void a_face_is_felt_and_no_tick_is_late() {
        QFETCH(QString, bus);
        TouchBench bench("vm_virtual_pad", {bus}, "pad:TPC-0001");
        bench.begin_to_touch();
        feels_the_whole_face(bench, bus);
        if (QTest::currentTestFailed())
            return;
        const TouchSession session = bench.sessions[0];
        qInfo("ticks %llu, latest %.1f us, compute p50 %.1f us, max %.1f us",
              static_cast<unsigned long long>(session.ticks), 1e6 * session.latest_s,
              1e6 * session.compute_p50_s, 1e6 * session.compute_max_s);
        QVERIFY(session.real_time);

        const double most = static_cast<double>(pad::cable_pad().max_force);
        double distance = 0.0;
        std::size_t counted = 0;
        for (std::size_t i = 0; i < bench.snapshots.size(); ++i) {
            const ServoSnapshot& seen = bench.snapshots[i];
            if (i > 0)
                QCOMPARE(seen.ticks, bench.snapshots[i - 1].ticks + 1); // the log is whole
            QVERIFY(length(seen.force()) <= most + 1e-9);
            if (seen.gain < 1.0)
                continue;
            distance += std::min(seen.distance, 8.0);
            ++counted;
        }
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
        is_lost_and_felt_again(bench, watchdog() + on_the_way);
    }

    void silent_in_mid_touch_data() { both_buses(); }
    void silent_in_mid_touch() {
        QFETCH(QString, bus);
        TouchBench bench("vm_virtual_pad", {bus}, "pad:TPC-0001");
        bench.begin_to_touch();
        bears_a_silence(bench);
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
