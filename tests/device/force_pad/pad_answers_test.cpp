// SPDX-License-Identifier: Apache-2.0
// What a pad says of itself, of its knob and of what it heard.
#include "firmware_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <utility>

namespace pad_answers_test {

using namespace tp::pad;

class ForcePadAnswersTest : public QObject {
    Q_OBJECT
private slots:
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
        const auto outlines = [](const PadConfig& config, float left, float low, float right, float high) {
            const Vec<float> corners[] = {{left, low}, {right, low}, {right, high}, {left, high}};
            return std::equal(
                std::begin(corners), std::end(corners), config.outline,
                [](const Vec<float>& a, const Vec<float>& b) { return a.x == b.x && a.y == b.y; });
        };
        QVERIFY(outlines(cables, -100, -75, 100, 75));
        QVERIFY(outlines(bars, -41, 75, 79, 135));
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

    void tells_what_its_sensors_tell() {
        FirmwareBench bench;
        bench.sensors.buttons = 5;
        bench.sensors.celsius = 42;
        bench.step();
        QCOMPARE(int(bench.state.buttons), 5);
        QCOMPARE(int(bench.state.celsius), 42);
        QCOMPARE(bench.state.time_us, bench.sensors.time_us);
    }

    void says_where_its_knob_is() {
        FirmwareBench bench;
        for (const auto& [x, y] : {std::pair{30.0, -20.0}, {99.0, 74.0}, {-99.0, 10.0}}) {
            bench.move_to(x, y);
            bench.step();
            QVERIFY(std::abs(bench.state.x_um * 1e-3 - x) < 0.01);
            QVERIFY(std::abs(bench.state.y_um * 1e-3 - y) < 0.01);
            QVERIFY(bench.state.residual_um < 10);
            QVERIFY(!bench.has(status::outside));
        }
        for (const auto& [x, y] : {std::pair{101.0, 0.0}, {-101.0, 0.0}, {0.0, 76.0}, {0.0, -76.0}}) {
            bench.move_to(x, y);
            bench.step();
            QVERIFY(bench.has(status::outside));
        }
        bench.move_to(30.0, -20.0);
        bench.step();
        bench.pad.receive(encode(CalibrateFrame{})); // on its mark, says a person
        bench.step();
        QCOMPARE(bench.state.x_um, 0);
        QCOMPARE(bench.state.y_um, 0);
        QCOMPARE(int(bench.state.residual_um), 0);
    }

    void answers_what_it_is_asked() {
        for (const PadConfig& config : {cable_pad(), pantograph_pad()}) {
            FirmwareBench bench(config);
            const bool cables = config.kind == PadKind::cables;
            Frame answer;
            QVERIFY(!bench.pad.answer(answer));
            bench.pad.receive(encode(AskFrame{1, FrameType::state, 0})); // which comes by itself
            QVERIFY(!bench.pad.answer(answer));
            bench.pad.receive(encode(AskFrame{1, FrameType::capabilities, 0}));
            QVERIFY(bench.pad.answer(answer));
            CapabilitiesFrame can;
            QVERIFY(decode(answer, can));
            QVERIFY(can.kind == config.kind && can.firmware_major == 1 && can.firmware_minor == 0);
            QVERIFY(can.max_force_mn == 1200 && can.continuous_force_mn == 1000);
            QVERIFY(can.resolution_um == (cables ? 8 : 30) && can.rate_hz == 1000 && can.delay_us == 1000);
            QVERIFY(can.corners == 4 && can.watchdog_ms == 30);
            OutlineFrame outline;
            int corner = 0;
            for (const uint8_t page : {uint8_t{0}, uint8_t{1}, uint8_t{2}, uint8_t{200}}) {
                bench.pad.receive(encode(AskFrame{2, FrameType::outline, page}));
                QVERIFY(bench.pad.answer(answer) && decode(answer, outline));
                QCOMPARE(outline.page, page);
                QCOMPARE(int(outline.corners), page == 0 ? 3 : page == 1 ? 1 : 0);
                for (int i = 0; i < outline.corners; ++i, ++corner) {
                    QCOMPARE(outline.x_um[i], static_cast<int32_t>(1000 * config.outline[corner].x));
                    QCOMPARE(outline.y_um[i], static_cast<int32_t>(1000 * config.outline[corner].y));
                }
            }
            QCOMPARE(corner, 4);
            IdentityFrame identity;
            bench.pad.receive(encode(AskFrame{5, FrameType::identity, 0}));
            QVERIFY(bench.pad.answer(answer) && decode(answer, identity));
            QCOMPARE(std::strcmp(identity.serial, cables ? "TPC-0001" : "TPP-0001"), 0);
            QVERIFY(!bench.pad.answer(answer));
            CalibrationFrame calibration;
            bench.pad.receive(encode(AskFrame{6, FrameType::calibration, 0}));
            QVERIFY(bench.pad.answer(answer) && decode(answer, calibration));
            QVERIFY(calibration.homed);
            for (const uint16_t permille : calibration.permille)
                QCOMPARE(permille, uint16_t{1000});
        }
    }

    void one_that_was_just_switched_on_tells_of_nothing_that_was() {
        for (const PadConfig& config : {cable_pad(), pantograph_pad()}) {
            PadFirmware pad(config);
            Frame answer;
            QVERIFY(!pad.answer(answer));
            QVERIFY(!pad.step(Sensors{}).powered);
            StateFrame state;
            QVERIFY(decode(pad.state(), state));
            QCOMPARE(int(state.sequence), 1);
            QCOMPARE(int(state.heard), 0);
            QCOMPARE(int(state.status), int(status::not_homed));
            QCOMPARE(int(state.residual_um), 0);
            QVERIFY(state.force_x_mn == 0 && state.force_y_mn == 0);
        }
    }

    /// So that a computer tells a new one from an old one.
    void each_state_has_the_next_number() {
        FirmwareBench bench;
        const uint16_t first = bench.state.sequence;
        for (uint16_t i = 1; i < 5; ++i) {
            bench.step();
            QCOMPARE(bench.state.sequence, static_cast<uint16_t>(first + i));
        }
    }

    void each_answer_has_the_number_of_the_last_state() {
        FirmwareBench bench;
        bench.step(3);
        Frame answer;
        CapabilitiesFrame can;
        bench.pad.receive(encode(AskFrame{1, FrameType::capabilities, 0}));
        QVERIFY(bench.pad.answer(answer) && decode(answer, can));
        QCOMPARE(can.sequence, bench.state.sequence);
        OutlineFrame outline;
        bench.pad.receive(encode(AskFrame{1, FrameType::outline, 0}));
        QVERIFY(bench.pad.answer(answer) && decode(answer, outline));
        QCOMPARE(outline.sequence, bench.state.sequence);
        IdentityFrame identity;
        bench.pad.receive(encode(AskFrame{1, FrameType::identity, 0}));
        QVERIFY(bench.pad.answer(answer) && decode(answer, identity));
        QCOMPARE(identity.sequence, bench.state.sequence);
        CalibrationFrame calibration;
        bench.pad.receive(encode(AskFrame{1, FrameType::calibration, 0}));
        QVERIFY(bench.pad.answer(answer) && decode(answer, calibration));
        QCOMPARE(calibration.sequence, bench.state.sequence);
    }

    void a_broken_frame_is_told_of_once() {
        FirmwareBench bench;
        Frame broken = encode(ForceFrame{1, 0, 0, true});
        broken.bytes[5] ^= 1;
        bench.pad.receive(broken);
        bench.step();
        QVERIFY(bench.has(status::bad_frame));
        bench.step();
        QVERIFY(!bench.has(status::bad_frame));
    }
};

} // namespace pad_answers_test

TP_TEST(pad_answers_test, ForcePadAnswersTest, nothing)
#include "pad_answers_test.moc"
