// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/firmware/pad_firmware.hpp"

#include <QTest>

#include <cmath>
#include <cstring>

using namespace tp::pad;

namespace {

/// A pad with sensors that a test sets by hand.
struct Bench {
    PadConfig config;
    PadFirmware pad{config};
    Sensors sensors;
    Drive drive;
    StateFrame state;
    uint16_t sequence = 100;

    explicit Bench(const PadConfig& made = cable_pad()) : config(made) {
        step();
        pad.receive(encode(CalibrateFrame{}));
        Frame answer;
        pad.answer(answer);
    }
    void step(int milliseconds = 1) {
        for (int i = 0; i < milliseconds; ++i) {
            sensors.time_us += 1000;
            drive = pad.step(sensors);
        }
        decode(pad.state(), state);
    }
    void ask_force(int x_mn, int y_mn) {
        pad.receive(
            encode(ForceFrame{++sequence, static_cast<int16_t>(x_mn), static_cast<int16_t>(y_mn), true}));
    }
    /// Armed, and the force on it long enough to be whole.
    void pull(int x_mn, int y_mn) {
        step();
        ask_force(0, 0);
        step();
        for (int i = 0; i < 40; ++i) {
            ask_force(x_mn, y_mn);
            step();
        }
    }
    double force() const { return 1e-3 * std::hypot(state.force_x_mn, state.force_y_mn); }
    bool has(uint16_t bit) const { return (state.status & bit) != 0; }
    /// The encoders as if the knob of a cable pad were at a place.
    void move_to(double x, double y) {
        for (int i = 0; i < cable_count; ++i) {
            const Vec<float> exit = config.cables.exits[i];
            const double length = std::hypot(double(exit.x) - x, double(exit.y) - y);
            const double at_mark = std::hypot(double(exit.x), double(exit.y));
            sensors.counts[i] = static_cast<int32_t>(std::lround(
                (length - at_mark) / (2.0 * 3.14159265358979 * double(config.drum_radius)) * 4096.0));
        }
    }
};

} // namespace

class ForcePadFirmwareTest : public QObject {
    Q_OBJECT
private slots:
    void makes_the_force_that_is_asked_for() {
        for (const PadConfig& config : {cable_pad(), pantograph_pad()}) {
            Bench bench(config);
            bench.pull(700, -300);
            QVERIFY(bench.has(status::armed));
            QVERIFY(std::abs(bench.state.force_x_mn - 700) <= 1);
            QVERIFY(std::abs(bench.state.force_y_mn + 300) <= 1);
            QVERIFY(bench.drive.powered);
            QCOMPARE(bench.state.heard, bench.sequence);
            QVERIFY(!bench.has(status::limited));
        }
    }

    /// The model and the firmware are made of the same figures, so that no test of both notices another one.
    void the_two_pads_are_made_of_what_their_page_says() {
        const PadConfig cables = cable_pad();
        QVERIFY(cables.kind == PadKind::cables);
        for (int i = 0; i < cable_count; ++i) {
            QCOMPARE(std::abs(cables.cables.exits[i].x), 150.0f);
            QCOMPARE(std::abs(cables.cables.exits[i].y), 110.0f);
        }
        QCOMPARE(cables.cables.least_tension, 0.3f);
        QCOMPARE(cables.cables.greatest_tension, 4.0f);
        QCOMPARE(cables.cables.rest_tension, 0.6f);
        QCOMPARE(cables.drum_radius, 5.0f);
        QCOMPARE(cables.counts_per_turn, 4096.0f);
        QCOMPARE(cables.greatest_torque, 20.0f);
        QCOMPARE(int(cables.resolution_um), 8);
        QCOMPARE(cables.serial, "TPC-0001");
        const PadConfig bars = pantograph_pad();
        QVERIFY(bars.kind == PadKind::pantograph);
        QVERIFY(bars.bars.proximal == 70 && bars.bars.distal == 90 && bars.bars.base == 38);
        QVERIFY(std::abs(bars.mark_angles[0] - 2.2689280f) < 1e-6f);
        QVERIFY(std::abs(bars.mark_angles[1] - 0.8726646f) < 1e-6f);
        QCOMPARE(bars.counts_per_turn, 16384.0f);
        QCOMPARE(bars.greatest_torque, 123.0f);
        QCOMPARE(bars.least_spread, 0.3f);
        QCOMPARE(int(bars.resolution_um), 30);
        QCOMPARE(bars.serial, "TPP-0001");
        for (const PadConfig& config : {cables, bars}) {
            QCOMPARE(int(config.corners), 4);
            QCOMPARE(config.max_force, 1.2f);
            QCOMPARE(config.continuous_force, 1.0f);
            QCOMPARE(config.max_force_rate, 100.0f);
            QCOMPARE(config.watchdog_us, uint32_t{30000});
            QVERIFY(config.hot == 70 && config.cool == 60);
            QCOMPARE(int(config.greatest_current_ma), 800);
            QCOMPARE(config.greatest_residual, 0.5f);
            QVERIFY(config.rate_hz == 1000 && config.delay_us == 1000);
        }
    }

    void a_force_that_is_taken_back_is_gone_at_once() {
        Bench bench;
        bench.pull(800, -300);
        QVERIFY(bench.force() > 0.8);
        bench.ask_force(0, 0);
        bench.step();
        QVERIFY(bench.has(status::armed));
        QCOMPARE(bench.force(), 0.0);
    }

    void tells_what_its_sensors_tell() {
        Bench bench;
        bench.sensors.buttons = 5;
        bench.sensors.celsius = 42;
        bench.step();
        QCOMPARE(int(bench.state.buttons), 5);
        QCOMPARE(int(bench.state.celsius), 42);
        QCOMPARE(bench.state.time_us, bench.sensors.time_us);
    }

    void says_where_its_knob_is() {
        Bench bench;
        for (const auto& [x, y] : {std::pair{30.0, -20.0}, {99.0, 74.0}, {-99.0, 10.0}}) {
            bench.move_to(x, y);
            bench.step();
            QVERIFY(std::abs(bench.state.x_um * 1e-3 - x) < 0.01);
            QVERIFY(std::abs(bench.state.y_um * 1e-3 - y) < 0.01);
            QVERIFY(bench.state.residual_um < 10);
            QVERIFY(!bench.has(status::outside));
        }
        bench.move_to(110.0, 0.0);
        bench.step();
        QVERIFY(bench.has(status::outside));
    }

    void motors_come_on_only_at_no_force() {
        Bench bench;
        bench.step();
        bench.ask_force(500, 0);
        bench.step();
        QVERIFY(!bench.has(status::armed));
        QVERIFY(!bench.drive.powered);
        bench.ask_force(0, 0);
        bench.step();
        QVERIFY(bench.has(status::armed));
        QVERIFY(bench.force() < 1e-9);
    }

    void without_being_homed_there_is_no_force() {
        PadFirmware pad(cable_pad());
        Sensors sensors;
        pad.receive(encode(CalibrateFrame{})); // before it knows its encoders: not homed by that
        StateFrame state;
        for (uint16_t i = 0; i < 5; ++i) {
            sensors.time_us += 1000;
            const Drive drive = pad.step(sensors);
            pad.receive(encode(ForceFrame{i, 0, 0, true}));
            QVERIFY(!drive.powered);
        }
        QVERIFY(decode(pad.state(), state));
        QVERIFY((state.status & status::not_homed) != 0);
        QVERIFY((state.status & status::armed) == 0);
    }

    void the_watchdog_takes_the_force_away() {
        Bench bench;
        bench.pull(800, 0);
        bench.step(29); // one more has passed since the last frame came
        QVERIFY(bench.has(status::armed));
        bench.step(1);
        QVERIFY(!bench.has(status::armed));
        QVERIFY(bench.has(status::watchdog));
        QVERIFY(!bench.drive.powered);
        QCOMPARE(bench.force(), 0.0);
        bench.ask_force(800, 0); // what was stuck on the way
        bench.step();
        QVERIFY(!bench.drive.powered);
        bench.pull(800, 0);
        QVERIFY(bench.force() > 0.79);
        QVERIFY(!bench.has(status::watchdog));
    }

    void old_and_repeated_frames_do_not_count() {
        Bench bench;
        bench.pull(800, 0);
        const Frame old = encode(ForceFrame{static_cast<uint16_t>(bench.sequence - 3), -800, 0, true});
        const Frame same = encode(ForceFrame{bench.sequence, -800, 0, true});
        for (int i = 0; i < 31; ++i) {
            bench.pad.receive(old);
            bench.pad.receive(same);
            bench.step();
            QVERIFY(bench.state.force_x_mn >= 0);
        }
        QVERIFY(bench.has(status::watchdog)); // they do not feed it either
    }

    void off_is_obeyed_at_once_whatever_its_number() {
        Bench bench;
        bench.pull(800, 0);
        bench.pad.receive(encode(ForceFrame{static_cast<uint16_t>(bench.sequence - 3), 0, 0, false}));
        bench.step();
        QVERIFY(!bench.drive.powered);
        QCOMPARE(bench.force(), 0.0);
    }

    void its_own_limits_hold_whatever_is_asked_for() {
        for (const PadConfig& config : {cable_pad(), pantograph_pad()}) {
            Bench bench(config);
            bench.step();
            bench.ask_force(0, 0);
            bench.step();
            double x = 0.0;
            double y = 0.0;
            for (int i = 0; i < 300; ++i) {
                const int side = (i / 40) % 2 == 0 ? 32767 : -32768;
                bench.ask_force(side, -side - 1);
                bench.step();
                QVERIFY(bench.force() <= double(config.max_force) + 0.0011);
                const double change =
                    std::hypot(1e-3 * bench.state.force_x_mn - x, 1e-3 * bench.state.force_y_mn - y);
                QVERIFY(change <= 0.001 * double(config.max_force_rate) + 0.0015);
                x = 1e-3 * bench.state.force_x_mn;
                y = 1e-3 * bench.state.force_y_mn;
                for (const int32_t torque : bench.drive.torque_unm)
                    QVERIFY(std::abs(torque) <= 1000.0 * double(config.greatest_torque));
            }
            QVERIFY(bench.has(status::limited));
        }
    }

    void heat_and_current_switch_the_motors_off() {
        Bench bench;
        bench.pull(500, 0);
        bench.sensors.celsius = 70;
        bench.step();
        QVERIFY(bench.has(status::hot));
        QVERIFY(!bench.drive.powered);
        bench.sensors.celsius = 65; // not cool enough
        bench.pull(500, 0);
        QVERIFY(!bench.drive.powered);
        bench.sensors.celsius = 59;
        bench.pull(500, 0);
        QVERIFY(bench.drive.powered);

        bench.sensors.current_ma[2] = 801;
        bench.step();
        QVERIFY(!bench.drive.powered);
        bench.sensors.current_ma[2] = 0;
        bench.step();
        QVERIFY(bench.has(status::over_current)); // still said why
        bench.pull(500, 0);
        QVERIFY(bench.drive.powered);
        QVERIFY(!bench.has(status::over_current));
    }

    void a_slack_cable_or_a_slipped_encoder_switches_the_motors_off() {
        for (int cable = 0; cable < cable_count; ++cable) {
            Bench bench;
            bench.move_to(40.0, 20.0);
            bench.pull(500, 0);
            QVERIFY(bench.drive.powered);
            const int32_t right = bench.sensors.counts[cable];
            bench.sensors.counts[cable] += 391; // 3 mm
            bench.step();
            QVERIFY(bench.has(status::unsure));
            QVERIFY(bench.state.residual_um > 500);
            QVERIFY(!bench.drive.powered);
            bench.pull(500, 0);
            QVERIFY(!bench.drive.powered);
            bench.sensors.counts[cable] = right;
            bench.pull(500, 0);
            QVERIFY(bench.drive.powered);
        }
    }

    void near_the_frame_it_never_pulls_harder_than_asked() {
        Bench bench;
        for (const auto& [x, y] :
             {std::pair{149.0, 109.0}, {0.0, 109.9}, {-149.9, 0.0}, {160.0, 120.0}, {200.0, 0.0}}) {
            bench.move_to(x, y);
            bench.pull(100, 50);
            QVERIFY(bench.force() <= 0.1125);
            bench.pull(0, 0);
            QVERIFY(bench.force() <= 0.0005);
        }
    }

    void a_motors_scale_reaches_its_torque_and_not_its_limit() {
        Bench bench;
        bench.pull(600, 0);
        const int32_t before = bench.drive.torque_unm[1];
        bench.pad.receive(encode(CalibrateFrame{1, CalibrateAction::scale, 1, 1100}));
        Frame answer;
        QVERIFY(bench.pad.answer(answer));
        CalibrationFrame calibration;
        QVERIFY(decode(answer, calibration));
        QVERIFY(calibration.homed);
        QCOMPARE(calibration.permille[1], uint16_t(1100));
        bench.step();
        QVERIFY(!bench.drive.powered);
        bench.pull(600, 0);
        QVERIFY(std::abs(bench.drive.torque_unm[1] - 1.1 * before) < 2.0);
    }

    void answers_what_it_is_asked() {
        Bench bench;
        Frame answer;
        QVERIFY(!bench.pad.answer(answer));
        bench.pad.receive(encode(AskFrame{1, FrameType::capabilities, 0}));
        QVERIFY(bench.pad.answer(answer));
        CapabilitiesFrame can;
        QVERIFY(decode(answer, can));
        QCOMPARE(can.max_force_mn, uint16_t(1200));
        QCOMPARE(can.corners, uint8_t(4));
        QCOMPARE(can.watchdog_ms, uint8_t(30));
        OutlineFrame outline;
        bench.pad.receive(encode(AskFrame{2, FrameType::outline, 0}));
        QVERIFY(bench.pad.answer(answer) && decode(answer, outline));
        QCOMPARE(outline.corners, uint8_t(3));
        QCOMPARE(outline.x_um[1], 100000);
        bench.pad.receive(encode(AskFrame{3, FrameType::outline, 1}));
        QVERIFY(bench.pad.answer(answer) && decode(answer, outline));
        QCOMPARE(outline.corners, uint8_t(1));
        QCOMPARE(outline.y_um[0], 75000);
        bench.pad.receive(encode(AskFrame{4, FrameType::outline, 200}));
        QVERIFY(bench.pad.answer(answer) && decode(answer, outline));
        QCOMPARE(outline.corners, uint8_t(0));
        IdentityFrame identity;
        bench.pad.receive(encode(AskFrame{5, FrameType::identity, 0}));
        QVERIFY(bench.pad.answer(answer) && decode(answer, identity));
        QCOMPARE(std::strcmp(identity.serial, "TPC-0001"), 0);
        QVERIFY(!bench.pad.answer(answer));
    }

    void a_broken_frame_is_told_of_once() {
        Bench bench;
        Frame broken = encode(ForceFrame{1, 0, 0, true});
        broken.bytes[5] ^= 1;
        bench.pad.receive(broken);
        bench.step();
        QVERIFY(bench.has(status::bad_frame));
        bench.step();
        QVERIFY(!bench.has(status::bad_frame));
    }

    void the_clock_may_wrap_in_mid_touch() {
        Bench bench;
        bench.sensors.time_us = 0xFFFFFFFFu - 20000u;
        bench.pull(800, 0);
        QVERIFY(bench.sensors.time_us < 100000u);
        QVERIFY(bench.force() > 0.79);
        bench.step(31);
        QVERIFY(bench.has(status::watchdog));
    }
};

QTEST_APPLESS_MAIN(ForcePadFirmwareTest)
#include "firmware_test.moc"
