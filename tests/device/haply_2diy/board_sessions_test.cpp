// SPDX-License-Identifier: Apache-2.0
// What of a 2diy's board holds from one opening, and one homing, to the next; and what its guard is told.
#include "board_dialogue.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace board_sessions_test {

using namespace tp;
using namespace tp::testing;

namespace {

const Vec2 pull(0.5, 0.3);

/// Further than arms turn in 30 ms.
constexpr double far_away = -75.0; // degrees

void say_nothing_more(BoardDialogue& bench) {
    bench.script.answers = false;
    bench.script.to_say.clear();
    bench.script.sent.clear();
}
bool opened_again(BoardDialogue& bench) {
    bench.script.answers = true;
    const bool opened = bench.device.open().ok();
    say_nothing_more(bench);
    return opened;
}
bool homed_again(BoardDialogue& bench) {
    bench.script.answers = true;
    const bool homed = bench.device.home().ok();
    say_nothing_more(bench);
    return homed;
}

} // namespace

class HaplySessionsTest : public QObject {
    Q_OBJECT
private slots:
    void before_it_is_opened_it_does_nothing_and_complains_of_nothing() {
        BoardDialogue bench;
        QVERIFY(bench.device.motors_off() && !bench.device.lost());
        QCOMPARE(bench.device.complaint(), std::string());
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
        QVERIFY(!bench.tick(pull));
        QVERIFY(bench.script.sent.empty());
    }

    void the_line_is_free_for_others_when_it_was_stopped() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        QCOMPARE(bench.script.users, 1);
        bench.device.stop();
        QCOMPARE(bench.script.users, 0);
        QVERIFY(bench.open());
        QVERIFY(opened_again(bench));
        QCOMPARE(bench.script.users, 1);
        QCOMPARE(bench.guard.dismissals, 2); // whoever watched before took leave
        QCOMPARE(bench.guard.ends, 2);
    }

    /// What it pulls then nobody knows.
    void a_guard_goes_on_where_the_board_is_out_of_step_or_the_guard_stepped_in() {
        for (const bool stepped_in : {false, true}) {
            BoardDialogue bench;
            QVERIFY(bench.open());
            if (stepped_in) {
                bench.guard.word = ForceGuard::Word::stepped_in;
                bench.tick(pull);
                QVERIFY(bench.script.last_command()->torque == (std::array<float, 2>{}));
            } else {
                QVERIFY(bench.falls_out_of_step());
            }
            bench.device.stop();
            QCOMPARE(bench.guard.dismissals, 0);
            QCOMPARE(bench.guard.ends, 1);
        }
    }

    void the_guard_knows_what_may_be_pulled() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        bench.tick(pull);
        QVERIFY(bench.guard.pulls);
        bench.tick({0, 0});
        QVERIFY(!bench.guard.pulls);
        for (int i = 0; i < 30; ++i)
            bench.tick({0, 0});
        QVERIFY(bench.device.complaint().find("lost count") != std::string::npos);
        QVERIFY(bench.guard.pulls); // what a board out of step makes of what it hears
    }

    void the_first_force_is_for_arms_as_they_stand() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        bench.tick(pull);
        QVERIFY(bench.script.last_command()->torque == bench.asked_for(pull, bench.turned(0.0)));

        BoardDialogue new_board; // which answers nothing before it is set up
        new_board.script.unanswered = 1;
        QVERIFY(new_board.open());
        new_board.tick(pull);
        QVERIFY(new_board.script.last_command()->torque == new_board.asked_for(pull, new_board.turned(0.0)));

        const QTemporaryDir folder;
        BoardDialogue homed_before;
        homed_before.note = HomedNote(folder.filePath("note").toStdString(), HaplyGeneration::third);
        homed_before.note.put();
        homed_before.script.here = homed_before.turned(-20.0);
        QVERIFY(opened_again(homed_before));
        homed_before.tick(pull);
        QVERIFY(homed_before.script.last_command()->torque ==
                homed_before.asked_for(pull, homed_before.turned(-20.0)));
    }

    void one_that_lost_count_is_to_be_homed_when_it_is_opened_again() {
        const QTemporaryDir folder;
        BoardDialogue bench;
        bench.note = HomedNote(folder.filePath("note").toStdString(), HaplyGeneration::third);
        QVERIFY(bench.open());
        QVERIFY(bench.note.holds());
        QVERIFY(bench.falls_out_of_step());
        QVERIFY(!bench.note.holds());
    }

    void opened_or_homed_again_any_place_is_believed() {
        for (const auto& again : {opened_again, homed_again}) {
            BoardDialogue bench;
            QVERIFY(bench.open());
            bench.script.say(bench.turned(0.0));
            QVERIFY(bench.tick({0, 0}));
            bench.script.say(bench.turned(far_away));
            QVERIFY(!bench.tick({0, 0}));
            QVERIFY(again(bench));
            bench.script.say(bench.turned(far_away));
            QVERIFY(bench.tick({0, 0}));
        }
    }

    void homed_again_it_pulls_before_it_has_answered() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        QVERIFY(bench.falls_out_of_step());
        bench.now += 1.0;
        const std::uint64_t before = bench.device.bad_answers();
        QVERIFY(homed_again(bench));
        bench.tick(pull);
        QCOMPARE(bench.device.bad_answers(), before);
        for (int i = 0; i < 7; ++i) { // what was under way is awaited 5 ms
            bench.tick(pull);
            QCOMPARE(bench.device.complaint(), std::string());
        }
        QVERIFY(bench.script.last_command()->torque == bench.asked_for(pull, bench.turned(0.0)));
    }

    void opened_again_what_it_was_told_before_is_awaited_no_more() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        bench.tick(pull);
        bench.tick(pull);
        bench.now += 1.0;
        QVERIFY(opened_again(bench));
        QVERIFY(bench.device.write(SafeForce{}));
        bench.device.deliver();
        bench.tick({0, 0});
        bench.tick({0, 0});
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
        QVERIFY(bench.device.complaint().find("lost count") == std::string::npos);
    }

    void opened_again_bytes_that_are_no_answer_count_anew() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        for (int time = 0; time < 2; ++time) {
            bench.script.to_say.assign(12, 0xEE);
            bench.tick({0, 0});
            QCOMPARE(bench.device.bad_answers(), std::uint64_t(1));
            QVERIFY(opened_again(bench));
        }
    }
};

} // namespace board_sessions_test

TP_TEST(board_sessions_test, HaplySessionsTest, nothing)
#include "board_sessions_test.moc"
