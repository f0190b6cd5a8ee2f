// SPDX-License-Identifier: Apache-2.0
#include "board_check.hpp"
#include "corpus.hpp"
#include "device/haply_2diy/model_board.hpp"
#include "device/haply_2diy/pantograph.hpp"
#include "device/haply_2diy/protocol/board_frames.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace board_frames_test {

using namespace tp;
using namespace tp::haply;

namespace {

QByteArray hex(std::span<const std::uint8_t> bytes) {
    return QByteArray(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()))
        .toHex(' ');
}

float any_angle(std::mt19937& random) {
    return std::uniform_real_distribution<float>(-540.0f, 540.0f)(random);
}

/// A board that was set up and pulls as the command says.
ModelBoard pulling(const Command& command) {
    const Pantograph arms(HaplyGeneration::third);
    ModelBoard board(HaplyGeneration::third);
    for (const std::uint8_t byte : encode(arms.set_up(arms.reference_deg())))
        board.receive(byte);
    for (const std::uint8_t byte : encode(command))
        board.receive(byte);
    return board;
}

double strongest(const ModelBoard& board) {
    return std::max(std::abs(board.torques()[0]), std::abs(board.torques()[1]));
}

} // namespace

class HaplyFramesTest : public QObject {
    Q_OBJECT
private slots:
    /// The facts' layout, with floats written by another program (Python's struct).
    void frames_are_byte_for_byte_the_boards() {
        QCOMPARE(hex(encode_reset(5)), QByteArray("00 05"));
        const Pantograph third(HaplyGeneration::third);
        QCOMPARE(hex(encode(third.set_up(third.reference_deg())).view()),
                 QByteArray("01 05 03 01 01 03 01 01 00 00 3d 8a a5 42 a0 1a a3 45 c3 75 c2 42 a5 9d a5 45"));
        const Pantograph first(HaplyGeneration::first);
        QCOMPARE(hex(encode(first.set_up(first.reference_deg())).view()),
                 QByteArray("01 05 03 00 01 03 01 01 00 00 00 00 74 c2 00 00 28 46 00 00 71 43 00 00 28 46"));
        QCOMPARE(hex(encode(Command{5, {0.0625f, -0.09375f}})), QByteArray("02 05 00 00 80 3d 00 00 c0 bd"));
        QCOMPARE(hex(encode(Reply{5, {1.5f, -45.25f}})), QByteArray("05 00 00 c0 3f 00 00 35 c2"));
    }

    void the_first_arm_hangs_at_port_two() {
        const Pantograph arms(HaplyGeneration::third);
        const Command command = arms.command_of({0.0625, -0.09375});
        QCOMPARE(command.torque[1], 0.0625f);
        QCOMPARE(command.torque[0], -0.09375f);
        const std::array<double, 2> angles = arms.angles_of(Reply{5, {10.0f, 20.0f}});
        QCOMPARE(angles[0], 20.0);
        QCOMPARE(angles[1], 10.0);
        QCOMPARE(arms.reply_of(angles).angle_deg[0], 10.0f);
        QCOMPARE(arms.torques_of(command)[0], 0.0625);
    }

    void decode_takes_back_what_encode_wrote() {
        std::mt19937 random(7);
        for (int i = 0; i < 2000; ++i) {
            const Reply reply{static_cast<std::uint8_t>(random()), {any_angle(random), any_angle(random)}};
            const auto back = decode_reply(encode(reply));
            QVERIFY(back && back->device_id == reply.device_id && back->angle_deg == reply.angle_deg);
            const Command command{static_cast<std::uint8_t>(random()),
                                  {any_angle(random), any_angle(random)}};
            const auto obeyed = decode_command(encode(command));
            QVERIFY(obeyed && obeyed->device_id == command.device_id && obeyed->torque == command.torque);
            SetUp set_up;
            set_up.device_id = static_cast<std::uint8_t>(random());
            for (std::size_t port = 0; port < port_count; ++port) {
                if (random() % 2 == 0)
                    set_up.motors[port] = static_cast<Turn>(random() % 2);
                if (random() % 2 == 0)
                    set_up.encoders[port] = EncoderSetUp{static_cast<Turn>(random() % 2), any_angle(random),
                                                         1.0f + std::abs(any_angle(random))};
            }
            const SetUpBytes bytes = encode(set_up);
            QCOMPARE(set_up_length(bytes.view()), std::optional(bytes.size));
            const auto again = decode_set_up(bytes.view());
            QVERIFY(again && again->device_id == set_up.device_id && again->motors == set_up.motors);
            QCOMPARE(hex(encode(*again).view()), hex(bytes.view()));
            // Its length is known with the second number of pins, behind both masks and the ways to turn.
            const auto there = [](const auto& ports) {
                return static_cast<std::size_t>(
                    std::ranges::count_if(ports, [](const auto& one) { return one.has_value(); }));
            };
            const std::size_t known = 2 + 1 + there(set_up.motors) + 1 + there(set_up.encoders) + 2;
            for (std::size_t cut = 0; cut < bytes.size; ++cut) {
                QVERIFY(!decode_set_up(bytes.view().first(cut)));
                QCOMPARE(set_up_length(bytes.view().first(cut)).has_value(), cut >= known);
            }
        }
    }

    void what_cannot_be_is_refused() {
        constexpr float nan = std::numeric_limits<float>::quiet_NaN();
        constexpr float infinite = std::numeric_limits<float>::infinity();
        for (const float angle : {nan, infinite, -infinite, 541.0f, -541.0f, 1e30f}) {
            QVERIFY(!decode_reply(encode(Reply{5, {angle, 0.0f}})));
            QVERIFY(!decode_reply(encode(Reply{5, {0.0f, angle}})));
        }
        QVERIFY(decode_reply(encode(Reply{5, {540.0f, -540.0f}})));
        QVERIFY(!decode_command(encode(Command{5, {nan, 0.0f}})));
        QVERIFY(!decode_command(encode(Command{5, {0.0f, infinite}})));
        auto other_type = encode(Command{});
        other_type[0] = 3;
        QVERIFY(!decode_command(other_type));
        const Pantograph arms(HaplyGeneration::first);
        const SetUpBytes good = encode(arms.set_up(arms.reference_deg()));
        for (const auto& [at, value] : {std::pair{0, 2}, {2, 0x13}, {3, 2}, {8, 1}, {17, 0xFF}, {17, 0xC6}}) {
            SetUpBytes bad = good;
            bad.bytes[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(value);
            QVERIFY(!decode_set_up(bad.view()));
        }
        const auto encoder = [](float offset_deg, float counts) {
            SetUp set_up;
            set_up.encoders[2] = EncoderSetUp{Turn::clockwise, offset_deg, counts};
            return decode_set_up(encode(set_up).view()).has_value();
        };
        QVERIFY(encoder(0.0f, 1.0f));
        for (const float none : {nan, infinite, -infinite}) {
            QVERIFY(!encoder(none, 1.0f));
            QVERIFY(!encoder(0.0f, none));
        }
        QVERIFY(!encoder(0.0f, 0.0f)); // which never turns
        using Bytes = std::vector<std::uint8_t>;
        QVERIFY(decode_set_up(Bytes{1, 5, 0, 0, 0, 0}));
        for (const Bytes& fifth_port : {Bytes{1, 5, 0x10, 0, 0, 0}, Bytes{1, 5, 0, 0x10, 0, 0}})
            QVERIFY(!decode_set_up(fifth_port));
    }

    /// What is not said of an encoder is the simplest.
    void an_encoder_counts_from_nothing_a_turn_at_a_time() {
        SetUp set_up;
        set_up.encoders[0].emplace();
        QCOMPARE(hex(encode(set_up).view()), QByteArray("01 05 00 01 00 00 00 00 00 00 00 00 00 80 3f"));
        QCOMPARE(hex(encode(Command{})), QByteArray("02 05 00 00 00 00 00 00 00 00"));
        QCOMPARE(hex(encode(Reply{})), QByteArray("05 00 00 00 00 00 00 00 00"));
    }

    void a_board_that_is_set_up_may_have_motors_and_encoders_at_any_port() {
        SetUp set_up;
        for (std::size_t port = 0; port < port_count; ++port) {
            set_up.motors[port] = Turn::clockwise;
            set_up.encoders[port] = EncoderSetUp{Turn::counter_clockwise, 1.0f, 4096.0f};
        }
        const SetUpBytes all = encode(set_up);
        QCOMPARE(all.size, std::size_t(46));
        QCOMPARE(set_up_length(all.view().first(13)),
                 std::optional<std::size_t>()); // not known before
        QCOMPARE(set_up_length(all.view().first(14)), std::optional<std::size_t>(46));
        const std::vector<std::uint8_t> pins{1, 5, 0, 0, 3, 0, 0, 0, 2, 0, 0};
        QCOMPARE(set_up_length(pins), std::optional<std::size_t>(11));
        QVERIFY(!decode_set_up(pins)); // a 2diy has none
    }

    void the_way_back_into_step_grows_by_a_byte_in_each_second_round() {
        const Pantograph arms(HaplyGeneration::third);
        const SetUp set_up = arms.set_up(arms.reference_deg());
        const std::size_t rest = 1 + encode(set_up).size + command_size;
        for (unsigned round = 0; round < 4; ++round) {
            const ResynchronisationBytes bytes = resynchronisation(set_up, round);
            QCOMPARE(bytes.size, 556 + round % 2 + rest);
            for (std::size_t i = 0; i < 556 + round % 2; ++i)
                QCOMPARE(bytes.bytes[i], std::uint8_t(0));
            QCOMPARE(bytes.bytes[556 + round % 2], std::uint8_t(3));
        }
    }

    void arms_go_only_so_far_in_a_while() {
        const Reply here{5, {90.0f, 80.0f}};
        QVERIFY(can_follow(here, here, 0.0));
        QVERIFY(can_follow(here, Reply{5, {90.07f, 80.07f}}, 0.0)); // a step of the encoders
        QVERIFY(can_follow(here, Reply{5, {92.0f, 80.0f}}, 0.001));
        QVERIFY(can_follow(here, Reply{5, {92.45f, 80.0f}}, 0.001)); // 2.29° and a step
        QVERIFY(!can_follow(here, Reply{5, {92.55f, 80.0f}}, 0.001));
        QVERIFY(!can_follow(here, Reply{5, {93.0f, 80.0f}}, 0.001));
        QVERIFY(can_follow(here, Reply{5, {90.0f, 77.55f}}, 0.001));
        QVERIFY(!can_follow(here, Reply{5, {90.0f, 77.0f}}, 0.001));
        QVERIFY(can_follow(here, Reply{5, {110.0f, 80.0f}}, 0.010));
        QVERIFY(!can_follow(here, Reply{5, {90.5f, 80.0f}}, -1.0)); // time does not go back
    }

    void a_sent_torque_never_grows_and_loses_a_percent_at_most() {
        std::mt19937 random(9);
        std::uniform_real_distribution<double> any(-0.123, 0.123);
        for (int i = 0; i < 5000; ++i) {
            const double torque = any(random);
            const double sent = static_cast<double>(sendable(torque));
            QVERIFY(std::abs(sent) <= std::abs(torque) * (1.0 + 1e-7));
            QVERIFY(std::abs(sent) >= 0.99 * std::abs(torque));
            QVERIFY(sent == 0.0 || (sent > 0.0) == (torque > 0.0));
            QCOMPARE(std::bit_cast<std::uint32_t>(sendable(torque)) & 0xFFFFu, 0u);
        }
        for (const double odd : {std::nan(""), 1.1, -1e300, HUGE_VAL, 1e-40, 0.0})
            QCOMPARE(sendable(odd), 0.0f);
        QCOMPARE(sendable(1.0), 1.0f);
        QCOMPARE(sendable(-1.0), -1.0f);
    }

    /// Whichever one or two bytes of a command get lost, the board makes no torque of the rest: each motor
    /// pulls nothing, or what some command asked it for.
    void lost_bytes_make_no_torque() {
        std::mt19937 random(10);
        const Pantograph arms(HaplyGeneration::third);
        std::uniform_real_distribution<double> any(-0.123, 0.123);
        for (int i = 0; i < 300; ++i)
            for (std::size_t lost = 1; lost <= 2; ++lost)
                for (std::size_t from = 0; from + lost <= command_size; ++from) {
                    std::array<Command, 3> asked; // the second is hurt
                    for (Command& command : asked)
                        command = arms.command_of({any(random), any(random)});
                    ModelBoard board = pulling(asked[0]);
                    const auto hurt = encode(asked[1]);
                    for (std::size_t at = 0; at < command_size; ++at)
                        if (at < from || at >= from + lost)
                            board.receive(hurt[at]);
                    for (const std::uint8_t byte : encode(asked[2]))
                        board.receive(byte);
                    for (std::size_t arm = 0; arm < 2; ++arm) {
                        bool was_asked_for = std::abs(board.torques()[arm]) < 1e-30;
                        for (const Command& command : asked)
                            was_asked_for =
                                was_asked_for || board.torques()[arm] == arms.torques_of(command)[arm];
                        QVERIFY2(was_asked_for, qPrintable(QString("%1 lost from %2").arg(lost).arg(from)));
                    }
                }
    }

    void a_board_that_lost_the_end_of_a_command_is_brought_back_by_one_round() {
        const Pantograph arms(HaplyGeneration::third);
        const SetUp set_up = arms.set_up(arms.reference_deg());
        for (std::size_t cut = 0; cut < command_size; ++cut) {
            ModelBoard board = pulling(arms.command_of({0.1, -0.1}));
            const auto hurt = encode(arms.command_of({0.1, -0.1}));
            for (std::size_t at = 0; at < cut; ++at)
                board.receive(hurt[at]);
            unsigned round = 0;
            const auto in_step = [&] {
                const std::vector<std::uint8_t> sent(board.sent().begin(), board.sent().end());
                return sent.size() >= reply_size && strongest(board) == 0.0 &&
                       hex(std::span(sent).last(reply_size)) ==
                           hex(encode(arms.reply_of(arms.reference_deg())));
            };
            for (board.sent().clear(); round < 4 && !in_step(); ++round) {
                board.sent().clear();
                for (const std::uint8_t byte : resynchronisation(set_up, round))
                    board.receive(byte);
            }
            QVERIFY2(in_step() && round == 1,
                     qPrintable(QString("cut after %1: %2 rounds").arg(cut).arg(round)));
        }
    }

    /// Bytes out of step may tell the board of 255 pins, twice: it then waits for 556 bytes.
    void a_board_that_waits_for_the_longest_frame_there_is_is_brought_back() {
        const Pantograph arms(HaplyGeneration::third);
        const SetUp set_up = arms.set_up(arms.reference_deg());
        const std::vector<std::uint8_t> begun{1, 5, 0x0F, 0, 0, 0, 0, 0x0F, 0, 0, 0, 0, 255};
        std::vector<std::uint8_t> longest = begun;
        longest.insert(longest.end(), 255, 0);
        longest.push_back(255);
        longest.insert(longest.end(), 255 + 32, 0);
        QCOMPARE(set_up_length(longest), std::optional<std::size_t>(556));
        for (std::size_t cut = begun.size(); cut < longest.size(); cut += 3) {
            ModelBoard board = pulling(arms.command_of({0.1, -0.1}));
            for (std::size_t at = 0; at < cut; ++at)
                board.receive(longest[at]);
            bool in_step = false;
            for (unsigned round = 0; round < 2 && !in_step; ++round) {
                board.sent().clear();
                for (const std::uint8_t byte : resynchronisation(set_up, round))
                    board.receive(byte);
                const std::vector<std::uint8_t> sent(board.sent().begin(), board.sent().end());
                in_step =
                    sent.size() >= reply_size && strongest(board) == 0.0 &&
                    hex(std::span(sent).last(reply_size)) == hex(encode(arms.reply_of(arms.reference_deg())));
            }
            QVERIFY2(in_step, qPrintable(QString("cut after %1").arg(cut)));
        }
    }

    void the_fuzzers_inputs_hold() {
        const auto seeds = tp::test::corpus(tp::test::in_source("tests/device/haply_2diy/corpus"));
        QVERIFY(seeds.size() >= 5);
        for (const tp::test::Seed& seed : seeds)
            QCOMPARE(seed.name + ": " + tp::test::complaint_about_board_bytes(seed.text), seed.name + ": ");
    }

    void any_bytes_leave_a_board_that_can_be_brought_back() {
        std::mt19937 random(11);
        for (int i = 0; i < 2000; ++i) {
            std::string bytes(random() % 80, '\0');
            for (char& byte : bytes) // mostly bytes that begin frames
                byte = static_cast<char>(random() % 3 == 0 ? random() : random() % 6);
            const std::string words = tp::test::complaint_about_board_bytes(bytes);
            QVERIFY2(words.empty(),
                     qPrintable(QString::fromStdString(words) + ": " +
                                hex({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()})));
        }
    }
};

} // namespace board_frames_test

TP_TEST(board_frames_test, HaplyFramesTest, nothing)
#include "board_frames_test.moc"
