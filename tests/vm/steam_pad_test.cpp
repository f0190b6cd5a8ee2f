// SPDX-License-Identifier: Apache-2.0
// In the virtual machine: model Steam pads as HID devices of the kernel's own, felt through the real hidapi. The kernel's driver
// hid-steam owns the Steam Controller; this kernel's knows no Steam Deck, which has a plain hidraw node.
#include "pad_bench.hpp"

#include <QTest>

using namespace tp;
using namespace tp::vm;

namespace {

constexpr double at_a_line =
    0.012; ///< s: 4 ms between two reports, 1 ms each of both programs, and their ways

struct DeckBench : PadBench {
    DeckBench() : PadBench("vm_virtual_steam_pad", {"deck"}, "steam:SD-0001") { begin_to_feel(); }
};
/// The node that hid-steam gives programs has no serial number.
struct ControllerBench : PadBench {
    ControllerBench() : PadBench("vm_virtual_steam_pad", {"controller"}, "steam:/dev/hidraw0") {
        begin_to_feel();
    }
};

void feels_every_line(PadBench& bench, double seconds) {
    QVERIFY(bench.feels(2));
    const double from = clock_now();
    PadBench::comes_true([] { return false; }, seconds);
    const PadBench::Felt felt = bench.felt(from, clock_now() - longest_tick);
    say(felt, bench);
    QVERIFY(felt.lines > 5);
    QVERIFY(felt.missed <= 1); // a tick that begins as the last one ends
    QVERIFY(felt.elsewhere <= 1);
    QVERIFY(felt.latest_s <= at_a_line);
    QVERIFY(felt.longest_s <= longest_tick);
    QVERIFY(!felt.other_side);
}

} // namespace

class SteamPadVmTest : public QObject {
    Q_OBJECT
private slots:
    void on_a_deck_a_thumb_feels_every_line() {
        DeckBench bench;
        feels_every_line(bench, 6.0);
    }

    void on_a_controller_of_the_kernels_driver_too() {
        ControllerBench bench;
        feels_every_line(bench, 4.0);
    }

    void unplugged_in_mid_touch_and_felt_again() {
        DeckBench bench;
        QVERIFY(bench.feels(2));
        bench.tell('u');
        QVERIFY(PadBench::comes_true([&] { return bench.lost(); }, 5.0));
        bench.tell('p');
        QVERIFY(bench.feels(2));
    }

    void at_the_end_the_pads_imitate_a_mouse_again() {
        DeckBench bench;
        QVERIFY(bench.feels(2));
        QVERIFY(bench.device_now().motors);
        QVERIFY(bench.end_feeling());
        QVERIFY(PadBench::comes_true([&] { return !bench.device_now().motors; }, 0.1));
        QVERIFY(bench.device_now().force == Vec2(0.0));
    }

    void killed_in_mid_touch_the_tick_ends_by_itself_and_the_mouse_comes_back() {
        DeckBench bench;
        QVERIFY(bench.feels(2));
        const double killed = clock_now();
        bench.kill_feeler();
        QVERIFY(PadBench::comes_true([&] { return !bench.device_now().motors; }, 5.0));
        QVERIFY(last_tick(bench.device_log, killed, clock_now()) - killed <= longest_tick);
    }

    /// Of a controller of 2015 the kernel's driver turns the mouse on again, as the node is closed.
    void killed_with_the_kernels_driver_the_mouse_comes_back() {
        ControllerBench bench;
        QVERIFY(bench.feels(2));
        QVERIFY(bench.device_now().motors);
        bench.kill_feeler();
        QVERIFY(PadBench::comes_true([&] { return !bench.device_now().motors; }, 1.0));
    }

    void one_that_falls_silent_is_still_there_when_it_speaks_again() {
        DeckBench bench;
        QVERIFY(bench.feels(2));
        bench.tell('s');
        PadBench::comes_true([] { return false; }, 0.5);
        QVERIFY(!bench.lost());
        bench.tell('t');
        QVERIFY(bench.feels(2));
    }
};

QTEST_GUILESS_MAIN(SteamPadVmTest)
#include "steam_pad_test.moc"
