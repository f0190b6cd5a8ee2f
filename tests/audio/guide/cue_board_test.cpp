// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/cue_board.hpp"

#include <QTest>

#include <atomic>
#include <thread>

using namespace tp;

class CueBoardTest : public QObject {
    Q_OBJECT
private slots:
    void what_was_written_last_is_read() {
        CueBoard board;
        QVERIFY(!board.read());
        board.write({0.5, 400.0, 500.0, 0.1, -1.0, 0.2});
        QCOMPARE(board.read()->to_hz, 500.0);
        board.write({0.25, 410.0, 500.0, 0.1, -1.0, 0.2});
        QCOMPARE(board.read()->interval_s, 0.25);
        board.clear();
        QVERIFY(!board.read());
    }

    void no_cue_is_made_of_two() {
        CueBoard board;
        std::atomic<bool> enough{false};
        std::thread writer([&] {
            for (double value = 1.0; !enough; value += 1.0)
                board.write({value, value, value, value, value, value});
        });
        double newest = 0.0;
        int changes = 0; // seen while the writer was writing
        bool whole = true;
        bool in_order = true;
        while (changes < 500)
            if (const auto cue = board.read()) {
                const double value = cue->interval_s;
                whole = whole && *cue == SonarCue{value, value, value, value, value, value};
                in_order = in_order && value >= newest;
                changes += value > newest ? 1 : 0;
                newest = value;
            }
        enough = true;
        writer.join();
        QVERIFY(whole);
        QVERIFY(in_order);
    }
};

QTEST_GUILESS_MAIN(CueBoardTest)
#include "cue_board_test.moc"
