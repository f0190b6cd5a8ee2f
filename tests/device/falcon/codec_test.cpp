// SPDX-License-Identifier: Apache-2.0
#include "corpus.hpp"
#include "device/falcon/falcon_frame.hpp"
#include "device/falcon/ftdi.hpp"
#include "falcon_check.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace codec_test {

using namespace tp::falcon;

namespace {

QByteArray hex(const Packet& packet) {
    return QByteArray(reinterpret_cast<const char*>(packet.data()), packet_size).toHex(' ');
}

Reply any_reply(std::mt19937& random) {
    Reply reply;
    for (std::int16_t& one : reply.encoders)
        one = static_cast<std::int16_t>(random());
    reply.buttons = static_cast<std::uint8_t>(random() % 16);
    reply.homed = static_cast<std::uint8_t>(random() % 8);
    return reply;
}

Command any_command(std::mt19937& random) {
    Command command;
    for (std::int16_t& one : command.motors)
        one = static_cast<std::int16_t>(static_cast<int>(random() % (2 * most_motor + 1)) - most_motor);
    command.homing = random() % 2 != 0;
    command.leds = static_cast<std::uint8_t>(2 * (random() % 8));
    return command;
}

std::vector<Packet> packets_in(PacketStream& stream, const std::vector<std::uint8_t>& bytes) {
    std::vector<Packet> found;
    for (const std::uint8_t byte : bytes)
        if (const std::optional<Packet> packet = stream.push(byte))
            found.push_back(*packet);
    return found;
}

void append(std::vector<std::uint8_t>& bytes, const Packet& packet) {
    bytes.insert(bytes.end(), packet.begin(), packet.end());
}

} // namespace

class FalconCodecTest : public QObject {
    Q_OBJECT
private slots:
    void golden_packets() {
        // The worked example of the facts: E, 8, A, F, least significant first, is 0xFA8E.
        Command command;
        command.motors = {-1394, 0, most_motor};
        QCOMPARE(hex(encode(command)), QByteArray("3c 4f 49 4b 50 41 41 41 41 41 41 41 42 41 41 3e"));
        command = {};
        command.motors = {1, 0x0123, -most_motor};
        command.homing = true;
        command.leds = led::red;
        QCOMPARE(hex(encode(command)), QByteArray("3c 42 41 41 41 44 43 42 41 41 41 41 50 4a 41 3e"));
        Reply reply;
        reply.encoders = {-1394, 32767, -32768};
        reply.buttons = button::centre;
        reply.homed = 7;
        QCOMPARE(hex(encode(reply)), QByteArray("3c 4f 49 4b 50 50 50 50 48 41 41 41 49 b5 41 3e"));
    }

    void encode_then_decode_is_the_identity() {
        std::mt19937 random(1);
        for (int i = 0; i < 5000; ++i) {
            const Reply reply = any_reply(random);
            QVERIFY(decode_reply(encode(reply)) == reply);
            const Command command = any_command(random);
            QVERIFY(decode_command(encode(command)) == command);
        }
    }

    void a_motor_never_gets_more_than_it_was_asked_for_and_never_wraps() {
        QCOMPARE(motor_units(12.9), std::int16_t(12));
        QCOMPARE(motor_units(-12.9), std::int16_t(-12));
        QCOMPARE(motor_units(1e300), std::int16_t(most_motor));
        QCOMPARE(motor_units(-std::numeric_limits<double>::infinity()), std::int16_t(-most_motor));
        QCOMPARE(motor_units(std::nan("")), std::int16_t(0));
        Command wild;
        wild.motors = {32767, -32768, 0};
        const std::optional<Command> sent = decode_command(encode(wild));
        QVERIFY(sent);
        QCOMPARE(sent->motors[0], std::int16_t(most_motor));
        QCOMPARE(sent->motors[1], std::int16_t(-most_motor));
    }

    void packets_that_are_none_are_refused() {
        const Packet good = encode(Reply{});
        for (std::size_t at = 0; at < packet_size; ++at) {
            if (at == 14) // of no known meaning in a reply
                continue;
            for (const std::uint8_t byte : {std::uint8_t(0x40), std::uint8_t(0xFF), std::uint8_t(0x00)}) {
                Packet bad = good;
                bad[at] = byte;
                QVERIFY2(!decode_reply(bad), qPrintable(QString::number(at)));
                QVERIFY(!decode_command(bad));
            }
        }
        Command beyond;
        Packet packet = encode(beyond);
        packet[1] = 'B'; // 1
        packet[4] = 'B'; // + 4096
        QVERIFY(!decode_command(packet));
    }

    void a_stream_finds_its_packets_again() {
        std::mt19937 random(2);
        for (int i = 0; i < 500; ++i) {
            std::vector<std::uint8_t> bytes;
            for (unsigned k = 0; k < random() % 40; ++k) // noise, a cut packet
                bytes.push_back(static_cast<std::uint8_t>(random()));
            const Packet cut = encode(any_reply(random));
            bytes.insert(bytes.end(), cut.begin(),
                         cut.begin() + 1 + static_cast<std::ptrdiff_t>(random() % 15));
            const std::size_t strays = bytes.size();
            PacketStream stream;
            QVERIFY(packets_in(stream, bytes).empty());
            const Packet first = encode(any_reply(random));
            const Packet second = encode(any_reply(random));
            bytes.clear();
            append(bytes, first);
            append(bytes, second);
            const std::vector<Packet> found = packets_in(stream, bytes);
            QCOMPARE(found.size(), std::size_t(2));
            QCOMPARE(hex(found[0]), hex(first));
            QCOMPARE(hex(found[1]), hex(second));
            QCOMPARE(stream.strays(), std::uint64_t(strays));
        }
    }

    void the_status_of_the_bridge_is_dropped() {
        const std::vector<std::uint8_t> packet = {0x11, 0x60, 'a', 'b'};
        const ftdi::Received got = ftdi::received(packet);
        QVERIFY(got.clear_to_send);
        QCOMPARE(got.payload.size(), std::size_t(2));
        QCOMPARE(got.payload[0], std::uint8_t('a'));
        const std::vector<std::uint8_t> status = {0x01, 0x60};
        QVERIFY(!ftdi::received(status).clear_to_send);
        QVERIFY(ftdi::received(status).payload.empty());
        const std::vector<std::uint8_t> clear = {0x11, 0x60}; // with nothing to read it may send all the same
        QVERIFY(ftdi::received(clear).clear_to_send);
        const std::vector<std::uint8_t> broken = {0x11};
        QVERIFY(!ftdi::received(broken).clear_to_send && ftdi::received(broken).payload.empty());
    }

    /// The first and the last of each letter, and their neighbours.
    void letters_of_a_packet_have_bounds() {
        const auto with = [](const Packet& of, std::size_t at, std::uint8_t letter) {
            Packet packet = of;
            packet[at] = letter;
            return packet;
        };
        const Packet reply = encode(Reply{});
        const Packet command = encode(Command{});
        for (std::size_t at = 1; at < 13; ++at) {
            QVERIFY(decode_reply(with(reply, at, 'P')));
            QVERIFY(!decode_reply(with(reply, at, 'Q')));
            QVERIFY(!decode_reply(with(reply, at, '@')));
            QVERIFY(!decode_command(with(command, at, 'Q')));
        }
        QVERIFY(decode_reply(with(reply, 13, 'A' + 0x7F)));
        QVERIFY(!decode_reply(with(reply, 13, 'A' + 0x80)));
        QVERIFY(!decode_reply(with(reply, 13, '@')));
        QVERIFY(decode_command(with(command, 13, 'A' + 0x0F)));
        QVERIFY(!decode_command(with(command, 13, 'A' + 0x10)));
        QVERIFY(!decode_command(with(command, 13, '@')));
        QVERIFY(decode_reply(with(reply, 14, 'z'))); // of no known meaning
        QVERIFY(!decode_command(with(command, 14, 'B')));
    }

    void a_motor_is_told_4096_units_at_most() {
        // −4096 is 0xF000, −4097 0xEFFF; the least nibble comes first.
        const auto told = [](const char* nibbles) {
            Packet packet = encode(Command{});
            std::copy_n(nibbles, 4, packet.begin() + 5);
            const std::optional<Command> command = decode_command(packet);
            return command ? std::optional<int>(command->motors[1]) : std::nullopt;
        };
        QVERIFY(told("AAAB") == 4096);
        QVERIFY(!told("BAAB"));
        QVERIFY(told("AAAP") == -4096);
        QVERIFY(!told("PPPO"));
    }

    void what_is_no_light_no_button_and_no_arm_does_not_spill_over() {
        Command command;
        command.leds = 0xFF;
        QCOMPARE(decode_command(encode(command))->leds, std::uint8_t(14));
        QVERIFY(!decode_command(encode(command))->homing);
        Reply reply;
        reply.buttons = 0xF5;
        reply.homed = 0xFA;
        QCOMPARE(decode_reply(encode(reply))->buttons, std::uint8_t(5));
        QCOMPARE(decode_reply(encode(reply))->homed, std::uint8_t(2));
    }

    void hostile_bytes_of_the_fuzzer() {
        const auto seeds = tp::test::corpus(tp::test::in_source("tests/device/falcon/corpus"));
        QVERIFY(seeds.size() >= 6);
        for (const tp::test::Seed& seed : seeds)
            QCOMPARE(seed.name + ": " + tp::test::complaint_about_falcon_bytes(seed.text), seed.name + ": ");
    }
};

} // namespace codec_test

TP_TEST(codec_test, FalconCodecTest, nothing)
#include "codec_test.moc"
