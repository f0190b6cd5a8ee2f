// SPDX-License-Identifier: Apache-2.0
#include "browse_parts.hpp"

#include <QImage>
#include <QSize>
#include <QString>
#include <QStringList>
#include <QTest>

#include <cstddef>
#include <optional>

using namespace tp;
using namespace tp::testing;

class BrowseDetailsTest : public QObject {
    Q_OBJECT
private slots:
    void the_picture_follows() {
        PartsAtGarden bench;
        QTRY_VERIFY(!bench.details().picture().isNull());
        QCOMPARE(bench.details().picture().size(), QSize(60, 40));
        const QImage garden = bench.details().picture();
        bench.trail().next();
        QTRY_VERIFY(!bench.details().picture().isNull() && bench.details().picture() != garden);
    }

    void details_on_demand_from_the_summary_on_and_back() {
        PartsAtGarden bench;
        QStringList told;
        for (int i = 0; i < 8; ++i) {
            bench.details().next();
            told << bench.said();
        }
        QCOMPARE(told.mid(0, 4), QStringList({"Anna", "Tom", "Recording 1 of 2: memo by Tom, 1 second(s).",
                                              "Recording 2 of 2: story by Ben, 1 second(s)."}));
        QCOMPARE(told[4], QString("Place: Vienna."));
        QCOMPARE(told[6], QString("File: garden.jpg."));
        QCOMPARE(told[7], told[6]);
        QCOMPARE(bench.earcon(), Earcon::list_end);
        for (int i = 0; i < 7; ++i)
            bench.details().previous();
        QCOMPARE(bench.said(), garden_words);
        bench.earcon();
        bench.details().previous();
        QCOMPARE(bench.earcon(), Earcon::list_end);
        QCOMPARE(bench.said(), garden_words);
    }

    void a_tap_tells_and_disturbs_no_recording() {
        PartsAtGarden bench;
        bench.details().tap();
        QCOMPARE(bench.said(), bench.details().summary());
        bench.playback().play();
        bench.loudspeaker.play(0.1);
        bench.voice.clear();
        bench.details().tap();
        QVERIFY(bench.playback().playing());
        QCOMPARE(bench.voice.said(), QStringList());
        bench.details().tell(); // who asks wants an answer
        QVERIFY(!bench.playback().playing());
        QCOMPARE(bench.said(), bench.details().summary());
    }

    void a_detail_of_a_recording_says_which_one_is_meant() {
        PartsAtGarden bench;
        QVERIFY(!bench.details().chosen_recording());
        for (int i = 0; i < 3; ++i)
            bench.details().next();
        QVERIFY(bench.details().chosen_recording() == std::optional<std::size_t>(0));
        bench.details().next();
        QVERIFY(bench.details().chosen_recording() == std::optional<std::size_t>(1));
        bench.trail().next();
        QVERIFY(!bench.details().chosen_recording());
        QCOMPARE(bench.details().detail(), bench.details().summary());
    }
};

QTEST_MAIN(BrowseDetailsTest)
#include "browse_details_test.moc"
