// SPDX-License-Identifier: Apache-2.0
#include "corpus.hpp"
#include "device/force_pad/protocol/frame.hpp"
#include "device/force_pad/protocol/usb.hpp"
#include "frame_check.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <random>
#include <string>

namespace protocol_test {

using namespace tp::pad;

namespace {

QByteArray hex(const Frame& frame) {
    return QByteArray(reinterpret_cast<const char*>(frame.bytes), frame_size).toHex(' ');
}

/// The frame of PROTOCOL.md with its CRC, made there by another program.
QByteArray golden(const char* start) {
    std::ifstream page(tp::test::in_source("device/force_pad/PROTOCOL.md"));
    const auto without_indent = [](const std::string& line) {
        return line.substr(std::min(line.find_first_not_of(' '), line.size()));
    };
    for (std::string line, next; std::getline(page, line);)
        if (without_indent(line).starts_with(start) && std::getline(page, next))
            return QByteArray::fromStdString(without_indent(line) + ' ' + without_indent(next));
    return {};
}

template <typename Value>
void is_identity(std::mt19937& random, Value (*any)(std::mt19937&)) {
    for (int i = 0; i < 2000; ++i) {
        const Frame frame = encode(any(random));
        Value back;
        QVERIFY(decode(frame, back));
        QCOMPARE(hex(encode(back)), hex(frame));
    }
}

/// Values over all their bits, so that a field that is cut or swapped cannot come back.
template <typename Number>
Number any_of(std::mt19937& random) {
    return static_cast<Number>(random());
}

StateFrame any_state(std::mt19937& random) {
    StateFrame s;
    s.sequence = any_of<uint16_t>(random);
    s.time_us = any_of<uint32_t>(random);
    s.x_um = any_of<int32_t>(random);
    s.y_um = any_of<int32_t>(random);
    s.force_x_mn = any_of<int16_t>(random);
    s.force_y_mn = any_of<int16_t>(random);
    s.residual_um = any_of<uint16_t>(random);
    s.status = any_of<uint16_t>(random) & status::all;
    s.heard = any_of<uint16_t>(random);
    s.celsius = any_of<int8_t>(random);
    s.buttons = any_of<uint8_t>(random);
    return s;
}

bool same(const StateFrame& a, const StateFrame& b) {
    return a.sequence == b.sequence && a.time_us == b.time_us && a.x_um == b.x_um && a.y_um == b.y_um &&
           a.force_x_mn == b.force_x_mn && a.force_y_mn == b.force_y_mn && a.residual_um == b.residual_um &&
           a.status == b.status && a.heard == b.heard && a.celsius == b.celsius && a.buttons == b.buttons;
}

bool same(const CapabilitiesFrame& a, const CapabilitiesFrame& b) {
    return a.sequence == b.sequence && a.kind == b.kind && a.firmware_major == b.firmware_major &&
           a.firmware_minor == b.firmware_minor && a.corners == b.corners &&
           a.max_force_mn == b.max_force_mn && a.continuous_force_mn == b.continuous_force_mn &&
           a.resolution_um == b.resolution_um && a.rate_hz == b.rate_hz && a.delay_us == b.delay_us &&
           a.watchdog_ms == b.watchdog_ms;
}

/// The frame with another byte, and a CRC that says so.
Frame with_byte(Frame frame, std::size_t at, uint8_t value) {
    frame.bytes[at] = value;
    const uint16_t crc = crc16(frame.bytes, frame_size - 2);
    frame.bytes[frame_size - 2] = static_cast<uint8_t>(crc & 0xFF);
    frame.bytes[frame_size - 1] = static_cast<uint8_t>(crc >> 8);
    return frame;
}

template <typename Value>
void refuses_flipped_bits(const Value& value) {
    for (unsigned bit = 0; bit < 8 * frame_size; ++bit) {
        Frame frame = encode(value);
        frame.bytes[bit / 8] = static_cast<uint8_t>(frame.bytes[bit / 8] ^ (1u << (bit % 8)));
        Value back;
        QVERIFY(!decode(frame, back));
    }
}

} // namespace

class ForcePadProtocolTest : public QObject {
    Q_OBJECT
private slots:
    void the_crc_is_the_published_one() {
        QCOMPARE(crc16(reinterpret_cast<const uint8_t*>("123456789"), 9), uint16_t(0x29B1));
    }

    void frames_are_byte_for_byte_those_of_the_page() {
        QCOMPARE(hex(encode(ForceFrame{0x1234, 800, -250, true})), golden("01 01 34 12"));
        QCOMPARE(hex(encode(AskFrame{2, FrameType::outline, 1})), golden("02 01 02 00"));
        QCOMPARE(hex(encode(CalibrateFrame{3, CalibrateAction::scale, 2, 1050})), golden("03 01 03 00"));
        StateFrame state;
        state.sequence = 0xFFFE;
        state.time_us = 1234567;
        state.x_um = -12345;
        state.y_um = 67890;
        state.force_x_mn = 799;
        state.force_y_mn = -250;
        state.residual_um = 21;
        state.status = status::armed | status::limited;
        state.heard = 0x1234;
        state.celsius = -5;
        state.buttons = 1;
        QCOMPARE(hex(encode(state)), golden("81 01 fe ff"));
        CapabilitiesFrame can;
        can.sequence = 9;
        can.kind = PadKind::cables;
        can.firmware_major = 1;
        can.corners = 4;
        can.max_force_mn = 1500;
        can.continuous_force_mn = 1000;
        can.resolution_um = 8;
        can.rate_hz = 1000;
        can.delay_us = 1000;
        can.watchdog_ms = 30;
        QCOMPARE(hex(encode(can)), golden("82 01 09 00"));
        OutlineFrame outline;
        outline.sequence = 10;
        outline.page = 1;
        outline.corners = 1;
        outline.x_um[0] = -100000;
        outline.y_um[0] = 75000;
        QCOMPARE(hex(encode(outline)), golden("83 01 0a 00"));
        IdentityFrame identity;
        identity.sequence = 11;
        std::strcpy(identity.serial, "TPC-0001");
        QCOMPARE(hex(encode(identity)), golden("84 01 0b 00"));
        CalibrationFrame calibration;
        calibration.sequence = 12;
        calibration.homed = true;
        calibration.permille[2] = 1050;
        QCOMPARE(hex(encode(calibration)), golden("85 01 0c 00"));
    }

    void decode_takes_back_what_encode_wrote() {
        std::mt19937 random(7);
        for (int i = 0; i < 2000; ++i) {
            const StateFrame state = any_state(random);
            StateFrame back;
            QVERIFY(decode(encode(state), back));
            QVERIFY(same(state, back));
        }
        is_identity<StateFrame>(random, any_state);
        is_identity<ForceFrame>(random, [](std::mt19937& r) {
            return ForceFrame{any_of<uint16_t>(r), any_of<int16_t>(r), any_of<int16_t>(r), r() % 2 == 0};
        });
        for (int i = 0; i < 2000; ++i) {
            const ForceFrame force{any_of<uint16_t>(random), any_of<int16_t>(random), any_of<int16_t>(random),
                                   true};
            ForceFrame back;
            QVERIFY(decode(encode(force), back));
            QVERIFY(back.sequence == force.sequence && back.x_mn == force.x_mn && back.y_mn == force.y_mn &&
                    back.motors);
            CapabilitiesFrame can;
            can.sequence = any_of<uint16_t>(random);
            can.kind = random() % 2 == 0 ? PadKind::cables : PadKind::pantograph;
            can.firmware_major = any_of<uint8_t>(random);
            can.firmware_minor = any_of<uint8_t>(random);
            can.corners = any_of<uint8_t>(random);
            can.max_force_mn = any_of<uint16_t>(random);
            can.continuous_force_mn = any_of<uint16_t>(random);
            can.resolution_um = any_of<uint16_t>(random);
            can.rate_hz = any_of<uint16_t>(random);
            can.delay_us = any_of<uint16_t>(random);
            can.watchdog_ms = any_of<uint8_t>(random);
            CapabilitiesFrame can_back;
            QVERIFY(decode(encode(can), can_back));
            QVERIFY(same(can, can_back));
        }
    }

    /// Field by field, with the first and the last value of each that has bounds.
    void what_is_asked_calibrated_outlined_and_told_comes_back_as_it_was() {
        for (const FrameType what : {FrameType::state, FrameType::capabilities, FrameType::outline,
                                     FrameType::identity, FrameType::calibration}) {
            AskFrame ask;
            QVERIFY(decode(encode(AskFrame{0xA1B2, what, 200}), ask));
            QVERIFY(ask.sequence == 0xA1B2 && ask.what == what && ask.page == 200);
        }
        AskFrame ask;
        for (const FrameType what : {FrameType::force, FrameType::ask, FrameType::calibrate})
            QVERIFY(!decode(encode(AskFrame{1, what, 0}), ask)); // nobody answers that
        for (const CalibrateFrame& sent : {CalibrateFrame{7, CalibrateAction::home, 0, 500},
                                           CalibrateFrame{0xFFFF, CalibrateAction::scale, 3, 1500}}) {
            CalibrateFrame back;
            QVERIFY(decode(encode(sent), back));
            QVERIFY(back.sequence == sent.sequence && back.action == sent.action &&
                    back.motor == sent.motor && back.permille == sent.permille);
        }
        for (std::uint8_t corners = 0; corners <= corners_per_page; ++corners) {
            OutlineFrame sent{0x1234, 250, corners, {-1, 70000, -70001}, {2, -80000, 80001}};
            OutlineFrame back;
            QVERIFY(decode(encode(sent), back));
            QVERIFY(back.sequence == 0x1234 && back.page == 250 && back.corners == corners);
            for (std::uint8_t i = 0; i < corners_per_page; ++i)
                QVERIFY(back.x_um[i] == (i < corners ? sent.x_um[i] : 0) &&
                        back.y_um[i] == (i < corners ? sent.y_um[i] : 0));
        }
        for (const char* serial : {"", "!", "TPC-0001~", "sixteen_letters_"}) {
            IdentityFrame sent;
            sent.sequence = 0x4321;
            std::strcpy(sent.serial, serial);
            IdentityFrame back;
            QVERIFY(decode(encode(sent), back));
            QVERIFY(back.sequence == 0x4321);
            QCOMPARE(QByteArray(back.serial), QByteArray(serial));
        }
        for (const char letter : {' ', '\x7F', '\x1F'}) {
            IdentityFrame sent;
            sent.serial[0] = 'A';
            sent.serial[1] = letter;
            IdentityFrame back;
            QVERIFY(!decode(encode(sent), back));
        }
        for (const bool homed : {true, false}) {
            CalibrationFrame back;
            QVERIFY(decode(encode(CalibrationFrame{0x8001, homed, {1, 256, 1500, 65535}}), back));
            QVERIFY(back.sequence == 0x8001 && back.homed == homed && back.permille[0] == 1 &&
                    back.permille[1] == 256 && back.permille[2] == 1500 && back.permille[3] == 65535);
        }
    }

    /// Each bit of a status is a thing that a person is told of.
    void every_status_bit_comes_back_alone() {
        for (unsigned bit = 0; bit < 10; ++bit) {
            StateFrame sent;
            sent.status = static_cast<uint16_t>(1u << bit);
            StateFrame back;
            QVERIFY(decode(encode(sent), back));
            QCOMPARE(back.status, sent.status);
        }
        const uint16_t told[] = {status::armed,        status::not_homed, status::watchdog, status::hot,
                                 status::over_current, status::unsure,    status::singular, status::limited,
                                 status::outside,      status::bad_frame};
        for (unsigned bit = 0; bit < 10; ++bit)
            QCOMPARE(told[bit], uint16_t(1u << bit)); // as PROTOCOL.md numbers them
        QCOMPARE(status::all, uint16_t(0x03FF));
    }

    void what_is_not_said_of_a_pad_is_nothing() {
        QVERIFY(same(StateFrame{}, [] {
            StateFrame back;
            decode(Frame{}, back);
            return back;
        }()));
        const StateFrame state;
        QVERIFY(state.sequence == 0 && state.time_us == 0 && state.x_um == 0 && state.y_um == 0 &&
                state.force_x_mn == 0 && state.force_y_mn == 0 && state.residual_um == 0 &&
                state.status == 0 && state.heard == 0 && state.celsius == 0 && state.buttons == 0);
        const ForceFrame force;
        QVERIFY(force.sequence == 0 && force.x_mn == 0 && force.y_mn == 0 && !force.motors);
        const CapabilitiesFrame can;
        QVERIFY(can.sequence == 0 && can.firmware_major == 0 && can.firmware_minor == 0 && can.corners == 0 &&
                can.max_force_mn == 0 && can.continuous_force_mn == 0 && can.resolution_um == 0 &&
                can.rate_hz == 0 && can.delay_us == 0 && can.watchdog_ms == 0);
        const CalibrateFrame calibrate;
        QVERIFY(calibrate.sequence == 0 && calibrate.motor == 0 && calibrate.permille == 1000);
        const CalibrationFrame calibration;
        QVERIFY(calibration.sequence == 0 && !calibration.homed);
        for (const uint16_t permille : calibration.permille)
            QCOMPARE(permille, uint16_t(1000));
        QVERIFY(AskFrame{}.sequence == 0 && AskFrame{}.page == 0 && OutlineFrame{}.sequence == 0 &&
                OutlineFrame{}.page == 0 && OutlineFrame{}.corners == 0 && IdentityFrame{}.sequence == 0);
    }

    /// The CRC finds every error of up to three bits in 30 bytes; here all of one and of two.
    void no_flipped_bit_goes_unnoticed() {
        std::mt19937 random(8);
        const Frame good = encode(any_state(random));
        const auto flip = [](Frame frame, unsigned bit) {
            frame.bytes[bit / 8] = static_cast<uint8_t>(frame.bytes[bit / 8] ^ (1u << (bit % 8)));
            return frame;
        };
        StateFrame value;
        for (unsigned a = 0; a < 8 * frame_size; ++a) {
            QVERIFY(!decode(flip(good, a), value));
            for (unsigned b = a + 1; b < 8 * frame_size; ++b)
                QVERIFY(!decode(flip(flip(good, a), b), value));
        }
    }

    void of_each_type_a_frame_with_a_flipped_bit_is_refused() {
        refuses_flipped_bits(ForceFrame{1, 2, 3, true});
        refuses_flipped_bits(AskFrame{1, FrameType::outline, 2});
        refuses_flipped_bits(CalibrateFrame{1, CalibrateAction::scale, 2, 1024});
        refuses_flipped_bits(StateFrame{});
        refuses_flipped_bits(CapabilitiesFrame{});
        refuses_flipped_bits(OutlineFrame{1, 0, 2, {1, 2, 0}, {3, 4, 0}});
        refuses_flipped_bits(IdentityFrame{1, "TPC-0001"});
        refuses_flipped_bits(CalibrationFrame{});
    }

    void what_the_page_does_not_allow_is_refused() {
        const Frame force = encode(ForceFrame{1, 2, 3, true});
        ForceFrame value{99, 0, 0, false};
        QVERIFY(!decode(with_byte(force, 0, 0x02), value)); // type
        QVERIFY(!decode(with_byte(force, 1, 2), value));    // version
        QVERIFY(!decode(with_byte(force, 8, 2), value));    // neither on nor off
        QVERIFY(!decode(with_byte(force, 29, 1), value));   // reserved
        QCOMPARE(value.sequence, uint16_t(99));
        QVERIFY(decode(with_byte(force, 8, 0), value));
        AskFrame ask;
        QVERIFY(!decode(with_byte(encode(AskFrame{}), 4, 0x01), ask)); // not an answer
        CalibrateFrame calibrate;
        QVERIFY(!decode(with_byte(encode(CalibrateFrame{}), 4, 3), calibrate));
        QVERIFY(!decode(with_byte(encode(CalibrateFrame{}), 5, 4), calibrate));
        QVERIFY(!decode(encode(CalibrateFrame{1, CalibrateAction::scale, 0, 499}), calibrate));
        QVERIFY(!decode(encode(CalibrateFrame{1, CalibrateAction::scale, 0, 1501}), calibrate));
        OutlineFrame outline;
        QVERIFY(!decode(with_byte(encode(OutlineFrame{}), 5, 4), outline));
        QVERIFY(!decode(with_byte(encode(OutlineFrame{}), 6, 1), outline)); // a corner beyond its count
        IdentityFrame identity;
        QVERIFY(!decode(with_byte(encode(IdentityFrame{}), 5, 'A'), identity)); // after the end
        QVERIFY(!decode(with_byte(encode(IdentityFrame{}), 4, 0xE9), identity));
        StateFrame state;
        QVERIFY(!decode(with_byte(encode(StateFrame{}), 23, 0x80), state)); // a status bit that is not there
        CapabilitiesFrame can;
        for (const uint8_t kind : {uint8_t{0}, uint8_t{3}})
            QVERIFY(!decode(with_byte(encode(CapabilitiesFrame{}), 4, kind), can));
        CalibrationFrame calibration;
        QVERIFY(!decode(with_byte(encode(CalibrationFrame{}), 4, 2), calibration));
        const Frame longest = encode(IdentityFrame{1, "sixteen_letters_"});
        QVERIFY(decode(longest, identity));
        QVERIFY(!decode(with_byte(longest, 20, 'A'), identity)); // a seventeenth
        constexpr std::size_t last = frame_size - 3; // is reserved in each, but for an outline's third corner
        QVERIFY(!decode(with_byte(encode(AskFrame{}), last, 1), ask));
        QVERIFY(!decode(with_byte(encode(CalibrateFrame{}), last, 1), calibrate));
        for (std::size_t at = 12; at <= last; ++at)
            QVERIFY(!decode(with_byte(encode(CalibrateFrame{}), at, 0x80), calibrate));
        QVERIFY(!decode(with_byte(encode(CapabilitiesFrame{}), last, 1), can));
        QVERIFY(!decode(with_byte(encode(IdentityFrame{}), last, 1), identity));
        QVERIFY(!decode(with_byte(encode(CalibrationFrame{}), last, 1), calibration));
    }

    void the_numbers_are_those_of_the_page() {
        QCOMPARE(encode(CalibrateFrame{1, CalibrateAction::home, 0, 1000}).bytes[4], uint8_t(1));
        QCOMPARE(encode(CalibrateFrame{1, CalibrateAction::scale, 0, 1000}).bytes[4], uint8_t(2));
        CapabilitiesFrame can;
        QCOMPARE(encode(can).bytes[4], uint8_t(1)); // cables
        can.kind = PadKind::pantograph;
        QCOMPARE(encode(can).bytes[4], uint8_t(2));
        QVERIFY(type_of(encode(can)) == FrameType::capabilities);
        QVERIFY(usb_vendor == 0x1209 && usb_product == 0x0001 && usage_page == 0xFF54 && usage == 1);
        QVERIFY(bulk_class == 0xFF && bulk_subclass == 0x54 && bulk_protocol == 1);
        QVERIFY(bulk_out == 0x02 && bulk_in == 0x81);
    }

    void sequence_numbers_go_round() {
        QVERIFY(newer(1, 0));
        QVERIFY(newer(0, 65535));
        QVERIFY(!newer(0, 0));
        QVERIFY(!newer(65535, 0));
        QVERIFY(newer(32767, 0));
        QVERIFY(!newer(32768, 0));
    }

    void the_report_descriptor_tells_of_32_bytes_each_way() {
        QCOMPARE(
            QByteArray(reinterpret_cast<const char*>(report_descriptor), sizeof report_descriptor).toHex(' '),
            golden("06 54 ff 09"));
    }

    void the_fuzzers_inputs_hold() {
        const auto seeds = tp::test::corpus(tp::test::in_source("tests/device/force_pad/corpus"));
        QVERIFY(seeds.size() >= 5);
        for (const tp::test::Seed& seed : seeds)
            QCOMPARE(seed.name + ": " + tp::test::complaint_about_frames(seed.text), seed.name + ": ");
    }
};

} // namespace protocol_test

TP_TEST(protocol_test, ForcePadProtocolTest, nothing)
#include "protocol_test.moc"
