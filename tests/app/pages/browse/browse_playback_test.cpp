// SPDX-License-Identifier: Apache-2.0
#include "browse_parts.hpp"
#include "test_program.hpp"

#include <QString>
#include <QTest>

#include <cstddef>
#include <filesystem>

namespace browse_playback_test {

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;

class BrowsePlaybackTest : public QObject {
    Q_OBJECT
private slots:
    void what_is_heard_is_told_and_its_end_sounds() {
        PartsAtGarden bench;
        bench.playback().play();
        QVERIFY(bench.playback().playing());
        bench.loudspeaker.play(0.4);
        QCOMPARE(bench.playback().heard(), QString("memo by Tom, 0:00 of 0:01"));
        bench.voice.set_busy(true);
        bench.loudspeaker.play(0.8);
        QCOMPARE(bench.said(), QString("Next: story by Ben."));
        bench.voice.set_busy(false);
        bench.loudspeaker.play(0.2);
        QVERIFY(bench.playback().heard().startsWith("story by Ben"));
        bench.loudspeaker.play(1.5);
        QVERIFY(!bench.playback().playing());
        QVERIFY(bench.playback().heard().isEmpty());
        QCOMPARE(bench.earcon(), Earcon::list_end);
    }

    void on_the_detail_of_a_recording_that_one_plays_alone() {
        PartsAtGarden bench;
        for (int i = 0; i < 4; ++i)
            bench.details().next();
        bench.playback().play();
        bench.loudspeaker.play(0.4);
        QVERIFY(bench.near(bench.tone(0.2), 440.0));
        bench.details().previous(); // another one takes over
        bench.playback().play();
        bench.loudspeaker.play(0.3);
        QVERIFY(bench.near(bench.tone(0.2), 300.0));
        bench.loudspeaker.play(2.0);
        QVERIFY(!bench.playback().playing());
    }

    void pressing_again_pauses_and_goes_on_from_there() {
        PartsAtGarden bench;
        bench.playback().play();
        bench.loudspeaker.play(0.2);
        bench.playback().play();
        QVERIFY(!bench.playback().playing());
        QVERIFY(bench.playback().heardValue() > 0.2);
        bench.playback().play();
        bench.loudspeaker.play(0.1);
        QVERIFY(bench.playback().playing());
        QVERIFY(bench.playback().heardValue() > 0.4);
    }

    void without_recordings_it_says_so() {
        PartsAtGarden bench;
        bench.go_to(bench.five.sea);
        QVERIFY(!bench.playback().hasRecordings());
        bench.playback().play();
        QCOMPARE(bench.said(), QString("This photograph has no recordings yet."));
        QCOMPARE(bench.earcon(), Earcon::error);
    }

    void a_recording_that_is_gone_costs_a_sentence_and_the_next_one_plays() {
        PartsAtGarden bench;
        fs::path tags = bench.five.garden;
        tags += ".tags";
        for (const auto& file : fs::directory_iterator(tags))
            if (file.path().string().ends_with("-memo.flac"))
                fs::resize_file(file.path(), 10);
        bench.playback().play();
        QVERIFY(!bench.said().isEmpty());
        QCOMPARE(bench.playback().notice(), bench.said());
        bench.loudspeaker.play(1.1);
        QVERIFY(bench.near(bench.tone(0.2), 440.0));
        bench.trail().next();
        QVERIFY(bench.playback().notice().isEmpty());
    }

    void the_speed_is_kept_and_heard() {
        PartsAtGarden bench;
        bench.playback().faster();
        QCOMPARE(bench.said(), QString("Speed 1.25"));
        QCOMPARE(bench.drawn.preferences.choices().playback_speed, 1.25);
        QCOMPARE(bench.player.speed(), 1.25);
        for (int i = 0; i < 9; ++i)
            bench.playback().slower();
        QCOMPARE(bench.player.speed(), 0.5);
        QCOMPARE(bench.playback().speedText(), QString("Speed 0.5"));
        bench.voice.clear();
        bench.playback().play();
        bench.loudspeaker.play(0.2);
        bench.playback().faster();
        QVERIFY(bench.playback().playing());
        QVERIFY(bench.voice.said().isEmpty()); // it is heard
    }

    void it_knows_where_in_a_recording_one_is() {
        PartsAtGarden bench;
        QVERIFY(!bench.playback().place());
        bench.playback().play();
        bench.loudspeaker.play(0.2);
        bench.playback().pause();
        QCOMPARE(bench.playback().place()->recording, QString("memo by Tom"));
        QCOMPARE(bench.playback().place()->time, QString("0 second(s)"));
        QVERIFY(bench.playback().stop());
        QVERIFY(!bench.playback().stop());
        QVERIFY(!bench.playback().place());
    }
};

} // namespace browse_playback_test

TP_TEST(browse_playback_test, BrowsePlaybackTest, window)
#include "browse_playback_test.moc"
