// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/undo_history.hpp"
#include "test_program.hpp"

#include <QTest>

#include <vector>

namespace undo_history_test {

using namespace tp;

class UndoHistoryTest : public QObject {
    Q_OBJECT

    /// A step that puts a number on a pile, having put it there.
    static UndoHistory::Step push(std::vector<int>& pile, int number) {
        pile.push_back(number);
        return {"push " + std::to_string(number),
                [&pile] {
                    pile.pop_back();
                    return std::string();
                },
                [&pile, number] {
                    pile.push_back(number);
                    return std::string();
                }};
    }

private slots:
    void two_hundred_steps_go_back_and_forth() {
        UndoHistory history;
        std::vector<int> pile;
        for (int i = 0; i < 230; ++i)
            history.done(push(pile, i));
        QCOMPARE(history.steps(), UndoHistory::most_steps);
        for (std::size_t i = 0; i < UndoHistory::most_steps; ++i)
            QCOMPARE(history.undo(), std::string());
        QCOMPARE(pile.size(), std::size_t{30});
        QVERIFY(!history.undo().empty());
        QCOMPARE(pile.size(), std::size_t{30});
        QCOMPARE(history.next_redo(), std::string("push 30"));
        for (std::size_t i = 0; i < UndoHistory::most_steps; ++i)
            QCOMPARE(history.redo(), std::string());
        QVERIFY(!history.redo().empty());
        QCOMPARE(pile.size(), std::size_t{230});
        QCOMPARE(pile.back(), 229);
    }

    void a_new_step_forgets_what_was_undone() {
        UndoHistory history;
        std::vector<int> pile;
        history.done(push(pile, 1));
        history.done(push(pile, 2));
        QCOMPARE(history.undo(), std::string());
        history.done(push(pile, 3));
        QCOMPARE(history.next_redo(), std::string());
        QCOMPARE(history.next_undo(), std::string("push 3"));
        QCOMPARE(pile, (std::vector<int>{1, 3}));
    }

    void two_steps_that_were_joined_are_one() {
        UndoHistory history;
        std::vector<int> pile;
        history.done(push(pile, 1));
        history.done(push(pile, 2));
        history.done(push(pile, 3));
        history.join("both");
        QCOMPARE(history.steps(), std::size_t{2});
        QCOMPARE(history.next_undo(), std::string("both"));
        QCOMPARE(history.undo(), std::string());
        QCOMPARE(pile, std::vector<int>{1});
        QCOMPARE(history.redo(), std::string());
        QCOMPARE(pile, (std::vector<int>{1, 2, 3}));
    }

    void of_joined_steps_both_are_undone_or_none() {
        UndoHistory history;
        std::vector<int> pile;
        history.done(
            {"stuck", [] { return std::string("The disk is full."); }, [] { return std::string(); }});
        history.done(push(pile, 2));
        history.join("both");
        QCOMPARE(history.undo(), std::string("The disk is full."));
        QCOMPARE(pile, std::vector<int>{2});
        QCOMPARE(history.next_undo(), std::string("both"));
    }

    void a_step_that_cannot_be_undone_stays() {
        UndoHistory history;
        bool possible = false;
        const auto action = [&] { return possible ? std::string() : std::string("The disk is full."); };
        history.done({"it", action, action});
        QCOMPARE(history.undo(), std::string("The disk is full."));
        QCOMPARE(history.next_undo(), std::string("it"));
        possible = true;
        QCOMPARE(history.undo(), std::string());
        possible = false;
        QCOMPARE(history.redo(), std::string("The disk is full."));
        QCOMPARE(history.next_redo(), std::string("it"));
    }
};

} // namespace undo_history_test

TP_TEST(undo_history_test, UndoHistoryTest, event_loop)
#include "undo_history_test.moc"
