// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/cue_board.hpp"

#include <QTest>

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
        constexpr int rounds = 200000;
        std::thread writer([&] {
            for (int i = 1; i <= rounds; ++i) {
                const double value = i;
                board.write({value, value, value, value, value, value});
            }
        });
        double newest = 0.0;
        bool whole = true;
        bool in_order = true;
        while (newest < rounds)
            if (const auto cue = board.read()) {
                const double value = cue->interval_s;
                whole = whole && *cue == SonarCue{value, value, value, value, value, value};
                in_order = in_order && value >= newest;
                newest = value;
            }
        writer.join();
        QVERIFY(whole);
        QVERIFY(in_order);
    }
};

QTEST_GUILESS_MAIN(CueBoardTest)
#include "cue_board_test.moc"
