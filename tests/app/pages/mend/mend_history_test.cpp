// SPDX-License-Identifier: Apache-2.0
#include "mend_bench.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTest>

#include <string>
#include <vector>

namespace mend_history_test {

using namespace tp;

class MendHistoryTest : public QObject {
    Q_OBJECT
private slots:
    void steps_are_undone_to_the_last_byte_and_done_again() {
        MendParts bench;
        bench.show();
        std::vector<std::string> texts{bench.text()};
        for (const double by : {1.0, 0.1, -3.75}) {
            bench.move(by);
            texts.push_back(bench.text());
        }
        QVERIFY(bench.history.canUndo() && !bench.history.canRedo());
        for (std::size_t i = texts.size() - 1; i > 0; --i) {
            QCOMPARE(bench.text(), texts[i]);
            bench.history.undo();
            QCOMPARE(bench.said(), QString("Undone: a point was moved."));
        }
        QCOMPARE(bench.text(), texts[0]);
        QVERIFY(!bench.history.canUndo());
        bench.history.undo();
        QCOMPARE(bench.said(), QString("There is nothing to undo."));
        for (std::size_t i = 1; i < texts.size(); ++i) {
            bench.history.redo();
            QCOMPARE(bench.said(), QString("Redone: a point was moved."));
            QCOMPARE(bench.text(), texts[i]);
        }
        bench.history.redo();
        QCOMPARE(bench.said(), QString("There is nothing to redo."));
    }
    void a_run_is_one_step_until_a_person_does_something_else() {
        MendParts bench;
        bench.show();
        const std::string before = bench.text();
        const auto nudge = [&] {
            bench.history.step(
                "it was moved",
                [](MendWork& work) {
                    move_all(*work.faces[0].features[0].line, {1, 0});
                    work.faces[0].features[0].mended = true;
                },
                "nudge");
        };
        nudge(), nudge(), nudge();
        const std::string one_run = bench.text();
        bench.selection.chooseHandle(1); // ends it
        nudge();
        bench.history.undo();
        QCOMPARE(bench.text(), one_run);
        bench.history.undo();
        QCOMPARE(bench.text(), before);
    }
    void what_is_done_after_an_undo_takes_the_place_of_what_was_undone() {
        MendParts bench;
        bench.show();
        bench.move();
        bench.history.undo();
        QVERIFY(bench.history.canRedo());
        bench.move(2.0);
        QVERIFY(!bench.history.canRedo());
    }
    void the_newest_step_can_be_forgotten() {
        MendParts bench;
        bench.show();
        bench.move();
        const std::string kept = bench.text();
        bench.move(5.0);
        bench.history.forget_newest();
        QCOMPARE(bench.text(), kept);
        QVERIFY(bench.history.canUndo() && !bench.history.canRedo());
    }
    void all_contours_can_be_replaced_by_one_step() {
        MendParts bench;
        bench.show();
        const MendWork opened = bench.photo.work();
        bench.move();
        const std::string mended = bench.text();
        QSignalSpy turning(&bench.history, &MendHistory::turning);
        bench.history.replace("all is as it was", opened);
        QCOMPARE(turning.size(), 1);
        QVERIFY(bench.text() != mended);
        bench.history.undo();
        QCOMPARE(turning.size(), 2);
        QCOMPARE(bench.text(), mended);
    }
    void another_photograph_has_no_history_and_the_oldest_steps_go() {
        MendParts bench;
        bench.show();
        for (std::size_t i = 0; i < MendHistory::most_steps + 5; ++i)
            bench.move();
        std::size_t undone = 0;
        for (; bench.history.canUndo(); ++undone)
            bench.history.undo();
        QCOMPARE(undone, MendHistory::most_steps);
        bench.show();
        QVERIFY(!bench.history.canUndo() && !bench.history.canRedo());
    }
};

} // namespace mend_history_test

TP_TEST(mend_history_test, MendHistoryTest, event_loop)
#include "mend_history_test.moc"
