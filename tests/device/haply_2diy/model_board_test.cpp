// SPDX-License-Identifier: Apache-2.0
// What stands in for a 2diy's board and its handle: how it moves, and when its motors are told.
#include "device/haply_2diy/model_board.hpp"
#include "device/haply_2diy/protocol/board_frames.hpp"
#include "device/haply_2diy/simulated_line.hpp"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

using namespace tp;

namespace {

struct Board {
    Pantograph arms;
    ModelBoard model;
    explicit Board(HaplyGeneration generation = HaplyGeneration::third, const HaplyPlant& plant = {})
        : arms(generation), model(generation, plant) {}

    void hear(std::span<const std::uint8_t> bytes) {
        for (const std::uint8_t byte : bytes)
            model.receive(byte);
    }
    void set_up() { hear(haply::encode(arms.set_up(arms.reference_deg())).view()); }
    /// Its answer to torques, by arm.
    std::optional<haply::Reply> ask(const std::array<double, 2>& torques = {}) {
        hear(haply::encode(arms.command_of(torques)));
        return said();
    }
    std::optional<haply::Reply> said() {
        std::array<std::uint8_t, haply::reply_size> bytes{};
        if (model.sent().size() != bytes.size())
            return std::nullopt;
        std::copy(model.sent().begin(), model.sent().end(), bytes.begin());
        model.sent().clear();
        return haply::decode_reply(bytes);
    }
};

} // namespace

class ModelBoardTest : public QObject {
    Q_OBJECT
private slots:
    void it_counts_from_where_it_was_set_up() {
        for (const HaplyGeneration generation : {HaplyGeneration::first, HaplyGeneration::third}) {
            Board board(generation);
            QVERIFY(!board.model.set_up());
            board.set_up();
            QVERIFY(board.model.set_up());
            const Vec2 there = board.arms.middle() + Vec2(3.0, -12.0);
            board.model.place_handle(there);
            QVERIFY(board.model.handle() == there);
            const auto reply = board.ask();
            QVERIFY(reply);
            const std::array<double, 2> angles = board.arms.angles_of(*reply);
            const std::array<double, 2> truth = *board.arms.angles_at(there);
            for (std::size_t i = 0; i < 2; ++i)
                QVERIFY2(std::abs(angles[i] - truth[i]) < 0.1,
                         qPrintable(QString::number(angles[i] - truth[i])));
            board.model.place_handle({500.0, 500.0}); // no arm is so long
            QVERIFY(board.model.handle() == there);
            board.model.power_off();
            QVERIFY(!board.model.set_up());
        }
    }

    void its_motors_push_as_they_were_told_until_they_are_told_again() {
        for (const HaplyGeneration generation : {HaplyGeneration::first, HaplyGeneration::third}) {
            Board board(generation);
            board.set_up();
            board.model.place_handle(board.arms.middle());
            for (const Vec2 wanted : {Vec2(0.5, 0.0), Vec2(-0.3, 0.4)}) {
                board.ask(board.arms.torques(*board.arms.angles_at(board.arms.middle()), wanted));
                QVERIFY2(length(board.model.force() - wanted) < 0.01,
                         qPrintable(QString::number(length(board.model.force() - wanted))));
            }
            board.model.power_off();
            QVERIFY(board.model.force() == Vec2(0.0));
        }
    }

    void a_motor_has_a_greatest_torque() {
        Board board;
        board.set_up();
        haply::Command wild;
        wild.torque = {1e6f, -1e6f};
        board.hear(haply::encode(wild));
        for (const double torque : board.model.torques())
            QVERIFY(std::abs(std::abs(torque) - Pantograph::greatest_torque) < 1e-6);
        wild.torque = {std::numeric_limits<float>::quiet_NaN(), 0.0f};
        board.hear(haply::encode(wild));
        const std::array<double, 2> held = board.model.torques();
        QVERIFY(std::abs(std::max(std::abs(held[0]), std::abs(held[1])) - Pantograph::greatest_torque) <
                1e-6);
    }

    /// Against the same laws written down once more.
    void its_handle_moves_as_a_mass_with_friction_does() {
        HaplyPlant plant;
        plant.hand_stiffness = 0.4;
        plant.hand_damping = 4.0;
        Board board(HaplyGeneration::third, plant);
        const Vec2 middle = board.arms.middle();
        board.model.place_handle(middle);
        Vec2 at = middle;
        Vec2 velocity(0.0);
        for (const Vec2 hand : {middle + Vec2(4.0, -3.0), Vec2(19.0, 300.0), middle}) {
            board.model.move_hand(hand);
            for (int ms = 0; ms < 200; ++ms) {
                for (int part = 0; part < 4; ++part) {
                    const Vec2 total = plant.hand_stiffness * (hand - at) -
                                       1e-3 * (plant.damping + plant.hand_damping) * velocity;
                    velocity += 0.25 / plant.mass * total;
                    const double speed = length(velocity);
                    velocity *=
                        speed > 0.0 ? std::max(0.0, speed - 0.25 / plant.mass * plant.coulomb) / speed : 0.0;
                    const Vec2 next = at + 0.00025 * velocity;
                    if (next.y > 5.0 && board.arms.angles_at(next))
                        at = next;
                    else
                        velocity = Vec2(0.0);
                }
                board.model.step();
                QVERIFY(length(board.model.handle() - at) < 1e-9);
            }
        }
        board.model.move_hand({19.0, -300.0}); // the motors stand there
        for (int ms = 0; ms < 3000; ++ms) {
            board.model.step();
            QVERIFY(board.model.handle().y > 5.0);
        }
        QVERIFY2(board.model.handle().y < 25.0, qPrintable(QString::number(board.model.handle().y)));
    }

    void a_handle_that_nobody_holds_stays_where_it_is() {
        Board board;
        board.model.place_handle(board.arms.middle());
        board.model.move_hand(board.arms.middle() + Vec2(20.0, 0.0));
        for (int ms = 0; ms < 100; ++ms)
            board.model.step();
        QVERIFY(board.model.handle() == board.arms.middle());
    }
    /// 100 g, pulled by 0.5 N against 0.03 N of dry friction: 2 mm in 30 ms but for the damping.
    void a_handle_that_is_pulled_goes_as_its_weight_lets_it() {
        Board board;
        board.set_up();
        board.model.place_handle(board.arms.middle());
        board.ask(board.arms.torques(*board.arms.angles_at(board.arms.middle()), {0.5, 0.0}));
        for (int ms = 0; ms < 30; ++ms)
            board.model.step();
        const Vec2 way = board.model.handle() - board.arms.middle();
        QVERIFY2(std::abs(way.x - 2.11) < 0.02 && std::abs(way.y) < 0.1,
                 qPrintable(QString("%1 %2").arg(way.x).arg(way.y)));
    }

    void what_begins_no_frame_is_dropped_and_a_reset_forgets_the_set_up() {
        Board board;
        board.hear(std::vector<std::uint8_t>{0x03, 0x7F, 0xFF});
        board.set_up();
        QVERIFY(board.model.set_up());
        QVERIFY(board.ask());
        board.hear(std::vector<std::uint8_t>{0x00, haply::usual_id});
        QVERIFY(!board.model.set_up());
    }

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

    void a_line_that_nobody_reads_keeps_4096_bytes() {
        Board board;
        board.set_up();
        for (int i = 0; i < 600; ++i)
            board.hear(haply::encode(haply::Command{}));
        QCOMPARE(board.model.sent().size(), std::size_t(4096));
    }
};

QTEST_APPLESS_MAIN(ModelBoardTest)
#include "model_board_test.moc"
