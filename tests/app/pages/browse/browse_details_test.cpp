// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/seen_photos.hpp"
#include "browse_parts.hpp"
#include "test_program.hpp"

#include <QImage>
#include <QSize>
#include <QString>
#include <QStringList>
#include <QTest>

#include <cstddef>
#include <optional>

namespace browse_details_test {

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

    /// A look that ends while somebody is at a detail moves nobody and says nothing; to whoever waits it is said, once.
    void what_is_seen_comes_to_whoever_waits_and_moves_nobody() {
        PartsAtGarden bench;
        SeenPhoto seen;
        seen.width = seen.height = 100;
        seen.faces.resize(1);
        seen.faces[0].part = {Vec2(0.4), Vec2(0.6)};
        seen.faces[0].mien = Mien::smiling;
        bench.details().next();
        QCOMPARE(bench.said(), QString("Anna"));
        bench.voice.clear();
        SeenPhotos known(bench.album().open().index(), 1);
        const auto photo = AlbumQueries(bench.album().open().index()).summary(bench.trail().here()->id);
        QCOMPARE(known.put(photo.value()->sha256, {seen, {}}), std::string());
        bench.trail().looked_at("/album/another.jpg");
        QCOMPARE(bench.details().summary(), garden_words);
        bench.trail().looked_at(bench.trail().shown());
        QVERIFY(bench.voice.said().isEmpty());
        QCOMPARE(bench.details().detail(), QString("Anna"));
        QVERIFY2(bench.details().summary().contains("one of them smiling"),
                 qPrintable(bench.details().summary()));
        SqlConnection& connection = bench.album().open().index().connection();
        connection.run_once("DELETE FROM seen");
        QCOMPARE(known.begin(photo.value()->sha256),
                 std::string());    // while it is looked at, it is kept without a size
        bench.details().previous(); // to what is seen, in full
        bench.details().previous();
        bench.trail().looked_at(bench.trail().shown()); // it is not known any more
        bench.voice.clear();
        QCOMPARE(known.put(photo.value()->sha256, {seen, {}}), std::string());
        bench.trail().looked_at(bench.trail().shown());
        QCOMPARE(bench.voice.said(), QStringList("Anna, Tom, and one more person, one of them smiling."));
        bench.trail().looked_at(bench.trail().shown());
        QCOMPARE(bench.voice.said().size(), 1);
        bench.details().next();
        QVERIFY2(bench.said().contains(" smiling") && bench.said().endsWith("."), qPrintable(bench.said()));
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

} // namespace browse_details_test

TP_TEST(browse_details_test, BrowseDetailsTest, window)
#include "browse_details_test.moc"
