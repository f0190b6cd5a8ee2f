// SPDX-License-Identifier: Apache-2.0
// In the virtual machine: a model touch pad with haptics as a HID device of the kernel's own, whose driver for touch pads has it too,
// felt through the real hidapi.
#include "pad_bench.hpp"

#include <QTest>

using namespace tp;
using namespace tp::vm;

class HapticPadVmTest : public QObject {
    Q_OBJECT

    struct Bench : PadBench {
        Bench() : PadBench("vm_virtual_haptic_pad", {}, "haptics:HP-0001") { begin_to_feel(); }
    };

private slots:
    void a_finger_feels_every_line() {
        Bench bench;
        QVERIFY(bench.feels(2));
        const double from = clock_now();
        PadBench::comes_true([] { return false; }, 6.0);
        const PadBench::Felt felt = bench.felt(from, clock_now() - longest_tick);
        say(felt, bench);
        QVERIFY(felt.lines > 5);
        QVERIFY(felt.missed <= 1); // a tick that begins as the last one ends
        QVERIFY(felt.elsewhere <= 1);
        QVERIFY(felt.latest_s <=
                0.016); // 8 ms between two reports, 1 ms each of both programs, and their ways
        QVERIFY(felt.longest_s <= longest_tick);
    }

    void unplugged_in_mid_touch_and_felt_again() {
        Bench bench;
        QVERIFY(bench.feels(2));
        bench.tell('u');
        QVERIFY(PadBench::comes_true([&] { return bench.lost(); }, 5.0));
        bench.tell('p');
        QVERIFY(bench.feels(2));
    }

    void killed_in_mid_touch_the_tick_ends_by_itself() {
        Bench bench;
        QVERIFY(bench.feels(2));
        const double killed = clock_now();
        bench.kill_feeler();
        PadBench::comes_true([] { return false; }, 0.2);
        QVERIFY(last_tick(bench.device_log, killed, clock_now()) - killed <= longest_tick);
    }

    void at_the_end_nothing_is_felt() {
        Bench bench;
        QVERIFY(bench.feels(2));
        QVERIFY(bench.end_feeling());
        const double ended = clock_now();
        PadBench::comes_true([] { return false; }, 0.1);
        QVERIFY(last_tick(bench.device_log, ended, clock_now()) - ended <= 0.002);
    }
};

QTEST_GUILESS_MAIN(HapticPadVmTest)
#include "haptic_pad_test.moc"
