// SPDX-License-Identifier: Apache-2.0
// When a pad pulls, how hard, and when not.
#include "firmware_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace firmware_test {

using namespace tp::pad;

class ForcePadFirmwareTest : public QObject {
    Q_OBJECT
private slots:
    void makes_the_force_that_is_asked_for() {
        for (const PadConfig& config : {cable_pad(), pantograph_pad()}) {
            FirmwareBench bench(config);
            bench.pull(700, -300);
            QVERIFY(bench.has(status::armed));
            QVERIFY(std::abs(bench.state.force_x_mn - 700) <= 1);
            QVERIFY(std::abs(bench.state.force_y_mn + 300) <= 1);
            QVERIFY(bench.drive.powered);
            QCOMPARE(bench.state.heard, bench.sequence);
            QVERIFY(!bench.has(status::limited));
        }
    }

    /// By the tensions of the cables on their drums, and by the work that a turn of a pantograph's motors does.
    void its_motors_make_the_force_that_it_tells_of() {
        FirmwareBench cables;
        cables.move_to(40.0, 20.0);
        cables.pull(700, -300);
        double x = 0.0;
        double y = 0.0;
        for (int i = 0; i < cable_count; ++i) {
            const double dx = double(cables.config.cables.exits[i].x) - 40.0;
            const double dy = double(cables.config.cables.exits[i].y) - 20.0;
            const double newtons = 1e-3 * cables.drive.torque_unm[i] / double(cables.config.drum_radius);
            x += newtons * dx / std::hypot(dx, dy);
            y += newtons * dy / std::hypot(dx, dy);
        }
        QVERIFY(std::abs(x - 0.7) < 0.001 && std::abs(y + 0.3) < 0.001);

        FirmwareBench bars(pantograph_pad());
        bars.pull(700, -300);
        for (int motor = 0; motor < arm_count; ++motor) {
            constexpr float turn = 0.01f;
            float ahead[arm_count] = {bars.config.mark_angles[0], bars.config.mark_angles[1]};
            float behind[arm_count] = {ahead[0], ahead[1]};
            ahead[motor] += turn;
            behind[motor] -= turn;
            const Vec<float> way =
                locate(bars.config.bars, ahead).place - locate(bars.config.bars, behind).place;
            const double work = double(dot(Vec<float>{0.7f, -0.3f}, way) / (2 * turn)); // N·mm
            QVERIFY(std::abs(1e-3 * bars.drive.torque_unm[motor] - work) < 0.05);
        }
    }

    void a_force_that_is_taken_back_is_gone_at_once() {
        FirmwareBench bench;
        bench.pull(800, -300);
        QVERIFY(bench.force() > 0.8);
        bench.ask_force(0, 0);
        bench.step();
        QVERIFY(bench.has(status::armed));
        QCOMPARE(bench.force(), 0.0);
    }

    /// A pad that stood still grows no faster than in 10 ms.
    void after_a_late_step_its_force_does_not_leap() {
        FirmwareBench bench;
        bench.pull(0, 0);
        bench.ask_force(1200, 0);
        bench.sensors.time_us += 24000;
        bench.step();
        QVERIFY(bench.has(status::armed));
        QVERIFY(std::abs(bench.force() - 1.0) < 0.002);
    }

    void a_pantograph_that_cannot_pull_says_so() {
        constexpr double counts_per_degree = 16384.0 / 360.0;
        FirmwareBench bench(pantograph_pad());
        const auto turn = [&bench](double first, double second) { // degrees from its marks
            bench.sensors.counts[0] = static_cast<int32_t>(std::lround(first * counts_per_degree));
            bench.sensors.counts[1] = static_cast<int32_t>(std::lround(second * counts_per_degree));
        };
        turn(20.0, -20.0);
        bench.pull(300, 200);
        QVERIFY(!bench.has(status::singular) && !bench.has(status::unsure));
        QVERIFY(std::abs(bench.force() - std::hypot(0.3, 0.2)) < 0.002);
        turn(50.0, -50.0); // its outer links lie nearly in one line
        bench.pull(300, 200);
        QVERIFY(bench.has(status::singular) && bench.has(status::limited) && !bench.has(status::unsure));
        QCOMPARE(bench.force(), 0.0);
        const double together = 130.0 - std::acos(19.0 / 70.0) * 180.0 / 3.14159265358979;
        turn(-together, together); // its elbows are in one place
        bench.pull(300, 200);
        QVERIFY(bench.has(status::unsure));
        QVERIFY(!bench.drive.powered);
    }

    void motors_come_on_only_at_no_force() {
        FirmwareBench bench;
        bench.step();
        for (const auto& [x, y] : {std::pair{500, 0}, {0, 500}, {-1, 0}, {0, -1}}) {
            bench.ask_force(x, y);
            bench.step();
            QVERIFY(!bench.has(status::armed));
            QVERIFY(!bench.drive.powered);
        }
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
        FirmwareBench bench;
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
        FirmwareBench bench;
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
        FirmwareBench bench;
        bench.pull(800, 0);
        bench.pad.receive(encode(ForceFrame{static_cast<uint16_t>(bench.sequence - 3), 0, 0, false}));
        bench.step();
        QVERIFY(!bench.drive.powered);
        QCOMPARE(bench.force(), 0.0);
    }

    void its_own_limits_hold_whatever_is_asked_for() {
        for (const PadConfig& config : {cable_pad(), pantograph_pad()}) {
            FirmwareBench bench(config);
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
        FirmwareBench bench;
        bench.sensors.celsius = 69;
        bench.sensors.current_ma[2] = 800;
        bench.pull(500, 0);
        QVERIFY(bench.drive.powered);
        bench.sensors.celsius = 70;
        bench.step();
        QVERIFY(bench.has(status::hot));
        QVERIFY(!bench.drive.powered);
        for (const int8_t not_cool_enough : {int8_t{65}, int8_t{60}}) {
            bench.sensors.celsius = not_cool_enough;
            bench.pull(500, 0);
            QVERIFY(!bench.drive.powered);
        }
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
            FirmwareBench bench;
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
            QVERIFY(!bench.has(status::unsure));
            bench.sensors.counts[cable] += 391;
            bench.step();
            bench.sensors.counts[cable] = right;
            bench.step();
            QVERIFY(bench.has(status::unsure)); // still said why
        }
    }

    void near_the_frame_it_never_pulls_harder_than_asked() {
        FirmwareBench bench;
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
        FirmwareBench bench;
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

    void the_clock_may_wrap_in_mid_touch() {
        FirmwareBench bench;
        bench.sensors.time_us = 0xFFFFFFFFu - 20000u;
        bench.pull(800, 0);
        QVERIFY(bench.sensors.time_us < 100000u);
        QVERIFY(bench.force() > 0.79);
        bench.step(31);
        QVERIFY(bench.has(status::watchdog));
    }
};

} // namespace firmware_test

TP_TEST(firmware_test, ForcePadFirmwareTest, nothing)
#include "firmware_test.moc"
