// SPDX-License-Identifier: Apache-2.0
// What stands in for a 2diy's board and its handle: how it moves, and when its motors are told.
#include "set_up_board.hpp"
#include "test_program.hpp"

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

namespace model_board_test {

using namespace tp;
using tp::testing::Board;

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

    void where_the_motors_stand_no_handle_goes() {
        HaplyPlant plant;
        plant.hand_stiffness = 0.4;
        plant.hand_damping = 4.0;
        Board board(HaplyGeneration::third, plant);
        board.model.place_handle({70.0, 20.0}); // beside them an arm reaches as far down
        board.model.move_hand({70.0, 0.0});
        for (int ms = 0; ms < 3000; ++ms) {
            board.model.step();
            QVERIFY(board.model.handle().y > 5.0);
        }
        QVERIFY2(board.model.handle().y < 5.1, qPrintable(QString::number(board.model.handle().y)));
    }

    void a_handle_that_is_put_somewhere_rests_there() {
        HaplyPlant plant;
        plant.hand_stiffness = 0.4;
        Board board(HaplyGeneration::third, plant);
        board.model.move_hand(board.arms.middle() + Vec2(20.0, 0.0));
        for (int ms = 0; ms < 20; ++ms)
            board.model.step();
        board.model.place_handle(board.arms.middle());
        for (int ms = 0; ms < 20; ++ms)
            board.model.step();
        QVERIFY(board.model.handle() == board.arms.middle());
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

    void a_new_board_answers_with_its_number_alone_and_its_handle_rests() {
        Board board;
        const Vec2 before = board.model.handle();
        board.hear(std::vector<std::uint8_t>{2, haply::usual_id});
        QCOMPARE(board.model.sent().size(), std::size_t(1));
        for (int ms = 0; ms < 10; ++ms)
            board.model.step();
        QVERIFY(board.model.handle() == before);
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

    /// Pins that the 2diy does not use: two that sense and three that are set.
    void pins_are_told_and_taken_with_each_command() {
        Board board;
        const auto plain = haply::encode(board.arms.set_up(board.arms.reference_deg()));
        std::vector<std::uint8_t> bytes(plain.begin(), plain.end());
        const auto pins = bytes.begin() + 8; // behind two motors and two encoders
        QVERIFY(pins[0] == 0 && pins[1] == 0);
        const std::array<std::uint8_t, 7> some{2, 14, 15, 3, 4, 5, 6};
        bytes.insert(bytes.erase(pins, pins + 2), some.begin(), some.end());
        board.hear(bytes);
        QVERIFY(board.model.set_up());
        const auto command = haply::encode(board.arms.command_of({0.05, -0.02}));
        std::vector<std::uint8_t> with_pins(command.begin(), command.end());
        with_pins.insert(with_pins.begin() + 2, {1, 0, 1});
        board.hear(with_pins);
        QVERIFY(std::abs(board.model.torques()[0] - 0.05) < 5e-4 &&
                std::abs(board.model.torques()[1] + 0.02) < 5e-4);
        QCOMPARE(board.model.sent().size(), std::size_t(1 + 2 * 4 + 2 * 4));
        QVERIFY(std::all_of(board.model.sent().begin() + 1, board.model.sent().begin() + 9,
                            [](std::uint8_t byte) { return byte == 0; }));
        board.model.sent().erase(board.model.sent().begin() + 1, board.model.sent().begin() + 9);
        const auto reply = board.said();
        QVERIFY(reply);
        for (std::size_t i = 0; i < 2; ++i)
            QVERIFY(std::abs(board.arms.angles_of(*reply)[i] - board.arms.reference_deg()[i]) < 0.1);
    }

    void without_its_power_it_forgets_what_it_heard_and_had_to_say() {
        Board board;
        board.set_up();
        board.hear(haply::encode(haply::Command{}));
        board.hear(std::vector<std::uint8_t>{2, haply::usual_id, 0});
        board.model.power_off();
        QVERIFY(board.model.sent().empty());
        board.set_up();
        QVERIFY(board.model.set_up());
        QVERIFY(board.ask());
    }

    void a_line_that_nobody_reads_keeps_4096_bytes() {
        Board board;
        board.set_up();
        for (int i = 0; i < 600; ++i)
            board.hear(haply::encode(haply::Command{}));
        QCOMPARE(board.model.sent().size(), std::size_t(4096));
    }
};

} // namespace model_board_test

TP_TEST(model_board_test, ModelBoardTest, nothing)
#include "model_board_test.moc"
