// SPDX-License-Identifier: Apache-2.0
// What is sent to a 2diy's board and when, and which of its answers are believed: each byte written by hand.
#include "board_dialogue.hpp"
#include "test_program.hpp"

#include <QTest>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dialogue_test {

using namespace tp;
using namespace tp::testing;

class HaplyDialogueTest : public QObject {
    Q_OBJECT
private slots:
    void it_says_what_it_can() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        QCOMPARE(bench.can->continuous_force, 0.47 * bench.can->max_force);
        QCOMPARE(bench.can->delay, 0.002);
        QCOMPARE(bench.can->serial_number, std::string("X"));
        QCOMPARE(bench.can->workspace.size(), std::size_t(120));
        QCOMPARE(bench.can->resolution, bench.script.arms.resolution());
        for (const Vec2 corner : bench.can->workspace)
            QVERIFY(corner.y >= 15.0);
    }

    void why_it_cannot_be_opened_is_passed_on() {
        Haply2diy device(
            HaplyGeneration::third, []() -> Result<Haply2diy::Board> { return Error{"It is gone."}; },
            LatestWriter::Thread::caller);
        QCOMPARE(device.open().error(), std::string("It is gone."));
        QVERIFY(!device.write(SafeForce{}));
    }

    void gone_without_a_stop_it_pulls_nothing() {
        BoardScript script;
        GuardDiary guard;
        {
            Haply2diy device(
                HaplyGeneration::third,
                [&]() -> Result<Haply2diy::Board> {
                    return Haply2diy::Board{std::make_unique<LentScript>(script),
                                            std::make_unique<SimulatedGuard>(guard),
                                            {},
                                            "X"};
                },
                LatestWriter::Thread::caller);
            QVERIFY(device.open().ok() && device.home().ok());
            device.read(0.001);
            device.write(safe({0.5, 0.5}));
            device.deliver();
            QVERIFY(script.last_command()->torque != (std::array<float, 2>{}));
        }
        QVERIFY(script.last_command()->torque == (std::array<float, 2>{}));
        QCOMPARE(guard.dismissals, 1);
        QCOMPARE(guard.ends, 1);
    }

    void a_line_on_which_nothing_has_come_is_asked_once_in_a_tick() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        bench.script.reads = 0;
        bench.tick({0, 0});
        QCOMPARE(bench.script.reads, 1);
        bench.script.say(bench.turned(0.0));
        bench.tick({0, 0});
        QCOMPARE(bench.script.reads, 3);
    }

    /// Whose arms do not stand on their marks, it says: they are counted from another place.
    void homing_is_done_where_the_board_counts_from_the_marks() {
        for (const double off : {0.0, 0.9, 1.1, -0.9, -1.1})
            for (const std::size_t arm : {0u, 1u}) {
                BoardDialogue bench;
                QVERIFY(bench.open());
                std::array<double, 2> angles = bench.script.arms.reference_deg();
                angles[arm] += off;
                bench.script.here = bench.script.arms.reply_of(angles);
                bench.script.answers = true;
                QCOMPARE(bench.device.home().ok(), std::abs(off) < 1.0);
                QCOMPARE(bench.script.sent.size(),
                         std::abs(off) < 1.0 ? std::size_t(1) : std::size_t(5)); // tries
            }
    }

    /// At a port where another device is, whatever that says to each question.
    void what_answers_like_no_2diy_is_not_opened() {
        haply::Reply elsewhere = BoardScript().here; // than it was just told that its arms are
        elsewhere.angle_deg[0] += 1.5f;
        haply::Reply other = BoardScript().here;
        other.device_id = 4;
        haply::Reply nowhere = BoardScript().here;
        nowhere.angle_deg[1] = 1e6f;
        for (const haply::Reply& answer : {elsewhere, other, nowhere}) {
            BoardDialogue bench;
            bench.script.here = answer;
            QVERIFY(!bench.open());
            QVERIFY2(bench.can.error().find("does not answer like") != std::string::npos,
                     bench.can.error().c_str());
            QVERIFY(!bench.device.write(SafeForce{}));
        }
    }

    /// A line gives what has come, and who used it before may have left something on it.
    void it_is_opened_where_its_answers_come_in_pieces_or_behind_other_bytes() {
        for (const std::size_t at_once : {1u, 4u, 1000u})
            for (const std::size_t junk : {0u, 5u, 256u}) {
                if (at_once * 50 < junk + haply::reply_size) // longer than it waits
                    continue;
                BoardDialogue bench;
                bench.script.at_once = at_once;
                bench.script.junk_before = junk;
                QVERIFY2(bench.open(), bench.can.error().c_str());
            }
    }

    void another_board_s_answer_is_none() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        haply::Reply other = bench.turned(0.0);
        other.device_id = 4;
        bench.script.say(other);
        QVERIFY(!bench.tick({0, 0}));
        QVERIFY(bench.device.bad_answers() > 0);
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0, 0}));
    }

    void an_answer_that_comes_in_two_pieces_is_one() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        const auto bytes = haply::encode(bench.turned(0.0));
        bench.script.to_say.assign(bytes.begin(), bytes.begin() + 4);
        QVERIFY(!bench.tick({0, 0}));
        bench.script.to_say.assign(bytes.begin() + 4, bytes.end());
        QVERIFY(bench.tick({0, 0}));
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
    }

    /// Bytes between two answers count once, however many they are.
    void garbage_is_one_bad_answer() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        bench.script.to_say.assign(7, 0xEE);
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0, 0}));
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(1));
        bench.script.to_say.assign(3, 0xEE);
        bench.script.say(bench.turned(0.1));
        QVERIFY(bench.tick({0, 0}));
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(2));
    }

    /// One that is lost: the next two go out, then none for 5 ms, and none of the waiting ones is sent late.
    void commands_wait_for_answers_5_ms() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        for (int i = 1; i <= 6; ++i) {
            bench.tick({0.5, 0.1 * i});
            QVERIFY(bench.script.sent.size() <= 2);
        }
        QCOMPARE(bench.script.sent.size(), std::size_t(2));
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
        for (int i = 1; i <= 3; ++i)
            bench.tick({0.5, 0.1 * i});
        QVERIFY(bench.script.sent.size() > 2);
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(1));
    }

    /// Letting go waits for nothing.
    void no_force_goes_out_whatever_is_under_way() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        bench.tick({0.5, 0.5});
        bench.tick({0.4, 0.5});
        bench.tick({0.3, 0.5});
        QCOMPARE(bench.script.sent.size(), std::size_t(2));
        bench.tick({0, 0});
        QCOMPARE(bench.script.sent.size(), std::size_t(3));
        QVERIFY(bench.script.last_command()->torque == (std::array<float, 2>{}));
        QVERIFY(!bench.guard.pulls);
        bench.tick({0, 0}); // once is enough
        QCOMPARE(bench.script.sent.size(), std::size_t(3));
    }

    /// After 20 ms its encoders are not believed any more; its motors pull nothing from then on.
    void a_board_that_is_silent_for_20_ms_is_brought_into_step() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        int ticks = 0;
        const auto brought_back = [&] {
            return std::any_of(bench.script.sent.begin(), bench.script.sent.end(),
                               [](const auto& bytes) { return bytes.size() > 500; });
        };
        while (!brought_back() && ticks < 100) {
            ++ticks;
            bench.tick({0.5, 0.5});
        }
        QVERIFY2(ticks >= 21 && ticks <= 24, qPrintable(QString::number(ticks)));
        QVERIFY(bench.device.motors_off());
        QVERIFY(bench.device.complaint().find("lost count") != std::string::npos);
        const std::size_t before = bench.script.sent.size();
        bench.tick({0.5, 0.5});
        QCOMPARE(bench.script.sent.size(), before); // nothing else until it answers
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0.5, 0.5}));
        bench.tick({0.5, 0.5});
        QVERIFY(bench.script.last_command() &&
                bench.script.last_command()->torque == (std::array<float, 2>{}));
    }

    /// What came, what waited and where it was belong to what was before.
    void opened_again_it_begins_as_new() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0.5, 0.5}));
        QVERIFY(bench.falls_out_of_step());
        bench.guard.word = ForceGuard::Word::stepped_in;
        const auto bytes = haply::encode(bench.turned(0.0));
        bench.script.to_say.assign(bytes.begin(), bytes.begin() + 4); // the rest of it never comes
        bench.tick({0.5, 0.5});
        bench.guard.word = ForceGuard::Word::here;
        bench.script.answers = true;
        QVERIFY(bench.device.open().ok());
        bench.script.answers = false;
        bench.script.to_say.clear();
        bench.script.sent.clear();
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
        QVERIFY2(bench.device.complaint().find("does not know where its arms are") != std::string::npos,
                 bench.device.complaint().c_str());
        bench.now += 1.0;
        QVERIFY(!bench.tick({0.5, 0.5}));
        QCOMPARE(bench.script.sent.size(), std::size_t(1)); // not homed: no torque
        QVERIFY(bench.script.last_command()->torque == (std::array<float, 2>{}));
        bench.script.say(bench.turned(-30.0));
        QVERIFY(bench.tick({0.5, 0.5}));
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
    }

    void homed_again_it_pulls_and_believes_at_once() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0.5, 0.5}));
        QVERIFY(bench.falls_out_of_step());
        bench.script.answers = true;
        const Result<bool> homed = bench.device.home();
        QVERIFY(homed.ok() && *homed);
        bench.script.answers = false;
        bench.script.sent.clear();
        QCOMPARE(bench.device.complaint(), std::string());
        QVERIFY(!bench.device.motors_off());
        bench.script.say(bench.turned(-20.0));
        QVERIFY(bench.tick({0.5, 0.5}));
        bench.tick({0.5, 0.5});
        QVERIFY(!bench.script.sent.empty());
        QVERIFY(bench.script.last_command()->torque != (std::array<float, 2>{}));
    }

    void one_that_is_gone_is_said_so() {
        for (const bool by_reading : {true, false}) {
            BoardDialogue bench;
            bench.device.halt(); // of nothing
            bench.script.reads_fail = by_reading;
            bench.script.writes_fail = !by_reading;
            QVERIFY(!bench.open());
            QVERIFY(!bench.device.lost());
            QCOMPARE(bench.device.complaint(), std::string());
            bench.script.reads_fail = bench.script.writes_fail = false;
            QVERIFY(bench.open());
            bench.script.reads_fail = by_reading;
            bench.script.writes_fail = !by_reading;
            bench.tick({0.5, 0.5});
            QVERIFY(bench.device.lost());
            QVERIFY(!bench.device.write(SafeForce{}));
            QVERIFY(!bench.device.read(bench.now));
            bench.device.stop();
            QCOMPARE(bench.guard.dismissals, 0); // nobody knows what it pulls
            QCOMPARE(bench.guard.ends, 2);
        }
    }

    void halted_it_lets_go() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        bench.tick({0.5, 0.5});
        QVERIFY(bench.script.last_command()->torque != (std::array<float, 2>{}));
        bench.device.halt();
        bench.device.deliver();
        QVERIFY(bench.script.last_command()->torque == (std::array<float, 2>{}));
        bench.device.stop();
        QCOMPARE(bench.guard.dismissals, 1);
        QCOMPARE(bench.guard.ends, 1);
    }

    void places_go_on_as_fast_as_arms_turn_and_no_faster() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0, 0}));
        bench.script.say(bench.turned(-2.0));
        const std::optional<DeviceState> moved = bench.tick({0, 0});
        QVERIFY(moved);
        QVERIFY(length(moved->position - bench.script.arms.pose_at({95.23, 82.77})->place) < 1e-3);
        QCOMPARE(moved->time, bench.now);
        bench.script.say(bench.turned(-5.0));
        QVERIFY(!bench.tick({0, 0}));
    }
};

} // namespace dialogue_test

TP_TEST(dialogue_test, HaplyDialogueTest, nothing)
#include "dialogue_test.moc"
