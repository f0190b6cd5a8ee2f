// SPDX-License-Identifier: Apache-2.0
// How often a 2diy's board is asked and listened to, and when it counts as out of step: each byte written by hand.
#include "board_dialogue.hpp"
#include "test_program.hpp"

#include <QTest>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace board_silence_test {

using namespace tp;
using namespace tp::testing;

namespace {

/// Opens it, and says how often it read.
int reads_of_opening(BoardDialogue& bench) {
    const bool opened = bench.device.open().ok();
    return opened ? -1 : bench.script.reads;
}

} // namespace

class HaplySilenceTest : public QObject {
    Q_OBJECT
private slots:
    /// Whether it counts, and five times as set up; each time 50 ms.
    void what_says_nothing_is_asked_six_times() {
        BoardDialogue bench;
        bench.script.answers = false;
        QCOMPARE(reads_of_opening(bench), 6 * (1 + 51)); // what is there already, then an answer
        QCOMPARE(bench.script.waited_ms, 6 * 51);
        QCOMPARE(bench.script.sent.size(), std::size_t(6));
        QCOMPARE(bench.script.users, 0);
    }

    void what_talks_without_end_is_listened_to_for_a_while_and_not_answered() {
        for (const std::size_t at_once : {1u, 256u}) {
            BoardDialogue bench;
            bench.script.writes_fail = true;
            bench.script.at_once = at_once;
            bench.script.to_say.assign(1000 * at_once, 0);
            QCOMPARE(reads_of_opening(bench), 6 * 64);
            QCOMPARE(bench.script.waited_ms, 0);
        }
    }

    void one_that_is_gone_is_not_waited_for() {
        BoardDialogue bench;
        bench.script.reads_fail = true;
        QCOMPARE(reads_of_opening(bench), 6 * 2);
    }

    /// More is for the next time: a tick is short.
    void in_a_tick_a_line_is_read_32_times_at_most_and_never_waited_for() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        bench.script.reads = bench.script.waited_ms = 0;
        bench.script.at_once = haply::reply_size;
        for (int i = 0; i < 100; ++i)
            bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0, 0}));
        QCOMPARE(bench.script.reads, 32);
        QCOMPARE(bench.script.waited_ms, 0);
    }

    void one_that_was_asked_nothing_since_its_last_answer_may_be_silent() {
        for (const bool asked_before : {false, true}) {
            BoardDialogue bench;
            QVERIFY(bench.open());
            if (asked_before) {
                bench.tick({0.5, 0.5});
                bench.script.say(bench.turned(0.0));
            }
            for (int i = 0; i < 40; ++i)
                bench.device.read(bench.now += 0.001);
            QCOMPARE(bench.device.complaint(), std::string());
            QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
        }
    }

    void one_unanswered_question_is_enough_opened_again_too() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        for (int time = 0; time < 2; ++time) {
            bench.tick({0.5, 0.5});
            bench.script.say(bench.turned(0.0));
            QVERIFY(bench.device.read(bench.now += 0.001));
            QVERIFY(bench.open());
            bench.tick({0.5, 0.5});
            for (int i = 0; i < 19; ++i)
                bench.device.read(bench.now += 0.001);
            QCOMPARE(bench.device.complaint(), std::string());
            for (int i = 0; i < 5; ++i)
                bench.device.read(bench.now += 0.001);
            QVERIFY(bench.device.complaint().find("lost count") != std::string::npos);
            QVERIFY(bench.open());
        }
    }

    void silence_is_counted_from_the_last_answer() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        for (int time = 0; time < 4; ++time) {
            for (int i = 0; i < 15; ++i)
                bench.tick({0.5, 0.5});
            bench.script.say(bench.turned(0.0));
            QVERIFY(bench.tick({0.5, 0.5}));
        }
        QCOMPARE(bench.device.complaint(), std::string());
    }

    /// Two are always under way; each answer comes 4 ms behind the one before.
    void answers_that_keep_coming_are_in_time() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        bench.tick({0.5, 0.5});
        bench.tick({0.5, 0.5});
        for (int answer = 0; answer < 10; ++answer) {
            for (int i = 0; i < 3; ++i)
                bench.tick({0.5, 0.5});
            QCOMPARE(bench.script.sent.size(), std::size_t(2 + answer)); // no third
            bench.script.say(bench.turned(0.0));
            QVERIFY(bench.tick({0.5, 0.5}));
        }
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
    }

    void half_an_answer_belongs_to_no_later_one() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        const auto bytes = haply::encode(bench.turned(0.0));
        bench.script.to_say.assign(bytes.begin(), bytes.begin() + 4);
        for (int i = 0; i < 8; ++i)
            bench.tick({0.5, 0.5});
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(1)); // none came in time
        bench.script.say(bench.turned(0.0));
        const std::optional<DeviceState> state = bench.tick({0.5, 0.5});
        QVERIFY(state && length(state->position - bench.script.arms.pose_at({97.23, 82.77})->place) < 1e-3);
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(1));
    }

    /// A second long, each time with another number of bytes; then it is taken for gone. Nothing of an earlier silence counts.
    void a_board_that_stays_silent_is_brought_back_fifty_times() {
        BoardDialogue bench;
        for (int time = 0; time < 3; ++time) {
            QVERIFY(bench.open());
            if (time == 1) { // once it came back
                QVERIFY(bench.falls_out_of_step());
                bench.script.say(bench.turned(0.0));
                QVERIFY(bench.tick({0.5, 0.5}));
                bench.script.sent.clear();
            }
            std::vector<std::size_t> sizes;
            int ticks = 0;
            const std::uint64_t bad_before = bench.device.bad_answers();
            for (; !bench.device.lost() && ticks < 3000; ++ticks) {
                bench.tick({0.5, 0.5});
                for (const auto& bytes : bench.script.sent)
                    if (bytes.size() > 500)
                        sizes.push_back(bytes.size());
                bench.script.sent.clear();
            }
            QCOMPARE(sizes.size(), std::size_t(50));
            QVERIFY2(ticks > 1000 && ticks < 1150, qPrintable(QString::number(ticks)));
            for (std::size_t i = 1; i < sizes.size(); ++i)
                QCOMPARE(sizes[i], sizes[0] + (i % 2 == 0 ? 0 : sizes[1] - sizes[0]));
            QVERIFY(sizes[1] != sizes[0]);
            QVERIFY2(bench.device.bad_answers() - bad_before >= 50, // each is missed
                     qPrintable(QString::number(bench.device.bad_answers() - bad_before)));
        }
        bench.script.reads_fail = true;
        QVERIFY(!bench.device.open().ok());
        QVERIFY(!bench.device.lost()); // it was not there
    }

    void a_board_that_came_back_is_asked_as_before() {
        BoardDialogue bench;
        QVERIFY(bench.open());
        QVERIFY(bench.falls_out_of_step());
        QVERIFY(bench.device.write(safe({0.5, 0.5}))); // it is not gone
        bench.device.read(bench.now += 0.001);
        bench.script.sent.clear();
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0.5, 0.5}));
        bench.tick({0.5, 0.5});
        bench.tick({0.5, 0.5});
        QCOMPARE(bench.script.sent.size(), std::size_t(2)); // and no third
        const std::uint64_t before = bench.device.bad_answers();
        for (int i = 0; i < 20; ++i) {
            bench.script.say(bench.turned(0.0));
            QVERIFY(bench.tick({0.5, 0.5}));
        }
        QCOMPARE(bench.device.bad_answers(), before);
    }
};

} // namespace board_silence_test

TP_TEST(board_silence_test, HaplySilenceTest, nothing)
#include "board_silence_test.moc"
