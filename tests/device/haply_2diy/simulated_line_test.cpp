// SPDX-License-Identifier: Apache-2.0
// The line to a model board, and what goes wrong on it.
#include "device/haply_2diy/simulated_line.hpp"
#include "set_up_board.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace simulated_line_test {

using namespace tp;
using tp::testing::Board;

namespace {

/// How many bytes of the command that it hears have not come to the board.
std::size_t lacking(ModelBoard& board) {
    std::size_t bytes = 0;
    for (; board.sent().empty() && bytes < 2 * haply::command_size; ++bytes)
        board.receive(2);
    board.sent().clear();
    return bytes;
}

/// A command of which any part looks like the beginning of one.
const std::vector<std::uint8_t> twos(haply::command_size, 2);

} // namespace

class SimulatedLineTest : public QObject {
    Q_OBJECT
private slots:
    void a_line_is_as_late_as_it_is_told() {
        for (const unsigned later : {0u, 3u}) {
            Board board;
            board.set_up();
            SimulatedLine line(board.model, later);
            std::array<std::uint8_t, 64> bytes{};
            QVERIFY(line.write(haply::encode(haply::Command{})));
            unsigned ms = 0;
            while (ms < 100 && line.read(bytes, 0) == 0) {
                line.advance();
                ++ms;
            }
            QCOMPARE(ms, 1 + later);
            QVERIFY(line.write(haply::encode(haply::Command{})));
            QCOMPARE(line.read(bytes, 50), int(haply::reply_size)); // a wait passes in its own time
            QCOMPARE(line.read(bytes, 50), 0);
            line.troubles.unplugged = true;
            QCOMPARE(line.read(bytes, 50), -1);
            QVERIFY(!line.write(haply::encode(haply::Command{})));
        }
    }

    void a_line_spoils_each_answer_that_it_is_told_to() {
        Board board;
        board.set_up();
        SimulatedLine line(board.model);
        std::array<std::uint8_t, 64> bytes{};
        const auto answered = [&] {
            line.write(haply::encode(haply::Command{}));
            line.advance();
            return static_cast<std::size_t>(line.read(bytes, 0));
        };
        QCOMPARE(answered(), haply::reply_size);
        const std::array<std::uint8_t, 64> whole = bytes;
        line.troubles.half = 1.0;
        std::array<int, haply::reply_size> of_size{};
        for (int i = 0; i < 400; ++i) {
            const std::size_t size = answered();
            QVERIFY(size < haply::reply_size);
            ++of_size[size];
        }
        for (const int times : of_size)
            QVERIFY2(times > 20, qPrintable(QString::number(times)));
        line.troubles.half = 0.0;
        line.troubles.garbage = 1.0;
        int as_it_was = 0; // a byte may be replaced by the same
        for (int i = 0; i < 400; ++i) {
            QCOMPARE(answered(), haply::reply_size);
            as_it_was += bytes == whole ? 1 : 0;
        }
        QVERIFY2(as_it_was < 10, qPrintable(QString::number(as_it_was)));
    }

    void what_was_lost_of_an_answer_is_one_to_eight_bytes() {
        Board board;
        board.set_up();
        SimulatedLine line(board.model);
        std::array<std::uint8_t, 64> bytes{};
        const auto answered = [&] {
            line.write(haply::encode(haply::Command{}));
            line.advance();
            return line.read(bytes, 0);
        };
        QCOMPARE(answered(), int(haply::reply_size));
        const std::array<std::uint8_t, 64> whole = bytes;
        line.troubles.garbage = 1.0;
        constexpr int answers = 1000;
        int others = 0;
        for (int i = 0; i < answers; ++i) {
            QCOMPARE(answered(), int(haply::reply_size));
            for (std::size_t k = 0; k < haply::reply_size; ++k)
                others += bytes[k] != whole[k] ? 1 : 0;
        }
        // Of 9 places k are drawn, k = 1 … 8, the more the less often, and one may be drawn twice: 2.8 at the mean.
        QVERIFY2(std::abs(others / double(answers) - 2.8) < 0.2, qPrintable(QString::number(others)));
        line.troubles.garbage = 0.0;
        line.troubles.drop_from_board = 0.25;
        int came = 0;
        for (int i = 0; i < answers; ++i)
            came += answered();
        QVERIFY2(std::abs(came / double(answers) - 0.75 * haply::reply_size) < 0.2,
                 qPrintable(QString::number(came)));
    }

    void a_line_that_overruns_loses_one_or_two_bytes_of_what_is_written() {
        Board board;
        board.set_up();
        SimulatedLine line(board.model);
        line.troubles.drop_to_board = 1.0;
        std::array<int, 3> times{};
        for (int i = 0; i < 400; ++i) {
            QVERIFY(line.write(twos));
            line.advance();
            const std::size_t lost = lacking(board.model);
            QVERIFY(lost == 1 || lost == 2);
            ++times[lost];
        }
        QVERIFY(times[1] > 150 && times[2] > 150);
        for (const std::size_t size : {2u, 3u}) {
            QVERIFY(line.write(std::vector<std::uint8_t>(size, 2)));
            line.advance();
            const std::size_t there = haply::command_size - lacking(board.model);
            QCOMPARE(there < size, size == 3); // so short a thing is not lost
        }
    }

    void half_a_write_is_the_first_half_and_the_next_is_whole() {
        Board board;
        board.set_up();
        SimulatedLine line(board.model);
        line.troubles.half_write = true;
        QVERIFY(line.write(twos));
        line.advance();
        QCOMPARE(lacking(board.model), haply::command_size - haply::command_size / 2);
        QVERIFY(line.write(twos));
        std::array<std::uint8_t, 64> bytes{};
        QCOMPARE(line.read(bytes, 1), int(haply::reply_size));
    }

    void on_a_line_that_stalls_all_comes_later_and_on_a_mute_one_never() {
        Board board;
        board.set_up();
        SimulatedLine line(board.model);
        std::array<std::uint8_t, 64> bytes{};
        line.troubles.stall = true;
        QVERIFY(line.write(haply::encode(haply::Command{})));
        QCOMPARE(line.read(bytes, 5), 0);
        line.troubles.stall = false;
        line.advance(); // the answer is on its way
        line.troubles.stall = true;
        QCOMPARE(line.read(bytes, 5), 0);
        line.troubles.stall = false;
        QCOMPARE(line.read(bytes, 0), int(haply::reply_size));
        line.troubles.mute = true;
        QVERIFY(line.write(haply::encode(haply::Command{})));
        QCOMPARE(line.read(bytes, 5), 0);
        line.troubles.mute = false;
        QCOMPARE(line.read(bytes, 5), 0);
    }

    void as_much_is_read_as_there_is_room_for() {
        Board board;
        board.set_up();
        SimulatedLine line(board.model);
        QVERIFY(line.write(haply::encode(haply::Command{})));
        std::array<std::uint8_t, 5> bytes{};
        QCOMPARE(line.read(std::span(bytes).first(4), 1), 4); // a millisecond is a wait
        QCOMPARE(int(bytes[4]), 0);
        QCOMPARE(line.read(bytes, 0), int(haply::reply_size) - 4);
    }
};

} // namespace simulated_line_test

TP_TEST(simulated_line_test, SimulatedLineTest, nothing)
#include "simulated_line_test.moc"
