// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/pages/browse/tag_playback.hpp"
#include "audio/sound/playback_order.hpp"
#include "browse_bench.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tag_playback_test {

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;

namespace {

/// A memo by Tom of 0.5 s at 300 Hz, a story by Ben of 1 s at 440 Hz.
struct Bench : BrowseSounds {
    fs::path garden = drawn.five().garden;
    std::unique_ptr<TagPlayback> playback =
        std::make_unique<TagPlayback>(player, narrator, drawn.preferences);
    QSignalSpy changed{playback.get(), &TagPlayback::changed}, ended{playback.get(), &TagPlayback::ended},
        progress{playback.get(), &TagPlayback::progress};

    Bench() {
        playback->set_tags(garden, tags());
        changed.clear();
    }
    std::vector<Tag> tags() const {
        std::vector<Tag> tags = read_record(garden)->tags;
        std::sort(tags.begin(), tags.end(),
                  [](const Tag& a, const Tag& b) { return a.label.kind < b.label.kind; });
        return tags;
    }
    fs::path file(std::size_t index) const { return tags_folder(garden) / tags()[index].file; }
    bool hears(double hertz) { return std::abs(tone(0.2) - hertz) < 15.0; }
    /// To where it is told what comes after the memo.
    void play_to_the_gap() {
        voice.set_busy(true);
        playback->toggle({});
        loudspeaker.play(0.6);
        QCOMPARE(said(), QString("Next: story by Ben."));
    }
};

} // namespace

class TagPlaybackTest : public QObject {
    Q_OBJECT
private slots:
    void all_play_in_order_and_what_comes_next_is_told_between() {
        Bench bench;
        QVERIFY(!bench.playback->current() && !bench.playback->playing());
        QVERIFY(bench.playback->toggle({}));
        QVERIFY(bench.playback->playing());
        QVERIFY(!bench.changed.isEmpty());
        QCOMPARE(bench.playback->duration_s(), 0.5);
        bench.changed.clear();
        bench.loudspeaker.play(0.4);
        QVERIFY(bench.hears(300.0));
        QVERIFY(bench.voice.recording_plays());
        QVERIFY(!bench.changed.isEmpty()); // it is heard
        QVERIFY(bench.progress.size() > 30);
        QVERIFY(std::abs(bench.playback->position_s() - 0.4) < 0.05);
        bench.voice.set_busy(true);
        bench.changed.clear();
        bench.loudspeaker.play(0.2);
        QCOMPARE(bench.said(), QString("Next: story by Ben."));
        QVERIFY(!bench.voice.recording_plays());
        QVERIFY(!bench.changed.isEmpty());
        QVERIFY(bench.playback->playing() && !bench.playback->paused());
        QCOMPARE(bench.playback->current(), std::optional<std::size_t>(1));
        bench.loudspeaker.play(2.0);
        QCOMPARE(bench.tone(1.5), 0.0); // nothing while it is told
        bench.voice.set_busy(false);
        bench.loudspeaker.play(0.4);
        QVERIFY(bench.hears(440.0));
        QVERIFY(bench.ended.isEmpty());
        bench.loudspeaker.play(1.0);
        QVERIFY(!bench.playback->playing() && !bench.playback->current());
        QCOMPARE(bench.ended.size(), 1);
        QVERIFY(!bench.voice.recording_plays());
    }
    void how_long_one_is_is_known_before_the_disk_has_answered() {
        Bench bench;
        bench.filler.asleep = true;
        bench.playback->toggle(1);
        QCOMPARE(bench.playback->duration_s(), 1.0);
    }
    void one_alone_is_named_and_another_takes_over() {
        Bench bench;
        bench.playback->toggle(1);
        bench.loudspeaker.play(0.4);
        QVERIFY(bench.hears(440.0));
        QCOMPARE(bench.playback->current(), std::optional<std::size_t>(1));
        bench.playback->toggle(0);
        bench.loudspeaker.play(0.4);
        QVERIFY(bench.hears(300.0));
        QCOMPARE(bench.playback->current(), std::optional<std::size_t>(0));
        bench.voice.clear();
        bench.loudspeaker.play(2.0);
        QVERIFY(bench.voice.said().isEmpty()); // nothing comes after it
        QVERIFY(!bench.playback->playing());
        QCOMPARE(bench.ended.size(), 1);
        bench.playback->toggle({}); // and then all, from the first one
        bench.loudspeaker.play(0.3);
        QVERIFY(bench.hears(300.0));
        bench.playback->toggle(0); // it is the one that sounds
        QVERIFY(bench.playback->paused());
    }
    void it_is_paused_and_goes_on_from_there() {
        Bench bench;
        bench.playback->toggle(1);
        bench.loudspeaker.play(0.4);
        bench.playback->toggle(1);
        QVERIFY(bench.playback->paused() && !bench.playback->playing());
        QVERIFY(!bench.voice.recording_plays());
        QCOMPARE(bench.playback->current(), std::optional<std::size_t>(1));
        const std::size_t runs = bench.loudspeaker.runs.size();
        bench.loudspeaker.play(1.0);
        QCOMPARE(bench.loudspeaker.runs.size(), runs);
        bench.playback->toggle(1);
        bench.loudspeaker.play(0.1);
        QVERIFY(bench.playback->playing() && bench.playback->position_s() > 0.4);
        bench.playback->toggle({}); // whatever it is, it pauses
        QVERIFY(bench.playback->paused());
        bench.playback->toggle({}); // and then all are meant
        bench.loudspeaker.play(0.3);
        QVERIFY(bench.hears(300.0));
    }
    void who_comes_back_hears_it_from_where_it_was_left() {
        Bench bench;
        bench.playback->toggle(1);
        bench.loudspeaker.play(0.4);
        QVERIFY(bench.playback->stop());
        QVERIFY(!bench.playback->paused() && !bench.playback->current());
        QVERIFY(!bench.playback->stop());
        bench.playback->set_tags(bench.drawn.root() / "sea.jpg", {});
        bench.playback->set_tags(bench.garden, bench.tags());
        bench.playback->toggle(1);
        QVERIFY(bench.playback->position_s() > 0.3);
        bench.loudspeaker.play(1.0); // to its end
        bench.playback->toggle(1);
        QCOMPARE(bench.playback->position_s(), 0.0);
    }
    void while_it_is_told_what_comes_it_can_be_paused_or_stopped() {
        for (const bool pauses : {true, false}) {
            Bench bench;
            bench.play_to_the_gap();
            bench.changed.clear();
            const int stops = bench.voice.stops();
            if (pauses)
                bench.playback->pause();
            else
                QVERIFY(bench.playback->stop());
            QVERIFY(!bench.changed.isEmpty() && bench.voice.stops() > stops);
            QCOMPARE(bench.playback->paused(), pauses);
            QVERIFY(!bench.playback->playing());
            bench.voice.set_busy(false);
            bench.loudspeaker.play(0.5);
            QVERIFY(!bench.playback->playing()); // it was not to go on
            bench.playback->toggle({});
            bench.loudspeaker.play(0.4);
            QVERIFY(bench.hears(pauses ? 440.0 : 300.0));
        }
    }
    void where_there_is_nothing_to_play_it_says_so() {
        Bench bench;
        QVERIFY(!bench.playback->toggle(2));
        bench.playback->set_tags(bench.drawn.root() / "sea.jpg", {});
        QCOMPARE(bench.changed.size(), 1);
        QVERIFY(!bench.playback->toggle({}));
        QVERIFY(!bench.playback->toggle(0));
        QVERIFY(!bench.playback->playing() && bench.ended.isEmpty());
    }
    void other_recordings_than_before_are_silent_and_the_same_ones_play_on() {
        Bench bench;
        bench.playback->toggle({});
        bench.loudspeaker.play(0.2);
        bench.changed.clear();
        bench.playback->set_tags(bench.garden, bench.tags());
        QVERIFY(bench.playback->playing() && bench.changed.isEmpty());
        std::vector<Tag> one = bench.tags();
        one.pop_back(); // another program deleted the other
        bench.playback->set_tags(bench.garden, one);
        QVERIFY(!bench.playback->playing() && !bench.changed.isEmpty());
        QCOMPARE(bench.playback->tags().size(), std::size_t{1});
        QVERIFY(!bench.loudspeaker.playing());
        bench.playback->toggle(0);
        bench.playback->set_tags(bench.drawn.root() / "walk.png", one);
        QVERIFY(!bench.playback->playing());
        bench.playback->set_tags(bench.garden, bench.tags());
        bench.play_to_the_gap();
        const int stops = bench.voice.stops();
        bench.playback->set_tags(bench.garden, one);
        QVERIFY(!bench.playback->playing() && bench.voice.stops() > stops);
    }
    void one_that_another_program_deleted_costs_a_sentence_and_the_next_one_plays() {
        Bench bench;
        const std::string memo = bench.tags()[0].file;
        fs::remove(bench.file(0));
        bench.playback->toggle({});
        QVERIFY2(bench.said().contains(QString::fromStdString(memo)), qPrintable(bench.said()));
        bench.loudspeaker.play(1.1);
        QVERIFY(bench.hears(440.0));
        bench.playback->toggle(0);
        QVERIFY(!bench.playback->playing());
        QCOMPARE(bench.ended.size(), 1);
    }
    void without_a_loudspeaker_it_waits_for_one() {
        Bench bench;
        bench.playback->toggle(1);
        bench.loudspeaker.play(0.4);
        bench.loudspeaker.vanish();
        QVERIFY2(bench.said().startsWith("The loudspeaker is gone."), qPrintable(bench.said()));
        QVERIFY(bench.playback->playing());
        bench.loudspeaker.come();
        bench.loudspeaker.play(0.3);
        QVERIFY(bench.hears(440.0));
    }
    void nobody_talks_over_it_and_it_is_as_loud_as_the_others() {
        Bench bench;
        std::vector<Tag> tags = bench.tags();
        tags[1].gain_db = -6.0206; // half as loud as it was recorded
        bench.playback->set_tags(bench.garden, tags);
        const int stops = bench.voice.stops();
        bench.playback->toggle(1);
        QVERIFY(bench.voice.stops() > stops);
        bench.loudspeaker.play(0.4);
        const std::vector<float>& heard = bench.loudspeaker.heard;
        const float loudest = *std::max_element(heard.begin(), heard.end());
        QVERIFY2(std::abs(loudest - 0.125F) < 0.01F, qPrintable(QString::number(loudest)));
    }
    void the_speed_follows_what_a_person_chose() {
        Bench bench;
        QCOMPARE(bench.player.speed(), 1.0);
        bench.drawn.preferences.change([](Choices& choices) { choices.playback_speed = 1.5; });
        QCOMPARE(bench.player.speed(), 1.5);
        bench.player.set_speed(1.0);
        bench.playback = nullptr;
        bench.playback = std::make_unique<TagPlayback>(bench.player, bench.narrator, bench.drawn.preferences);
        QCOMPARE(bench.player.speed(), 1.5);
    }
    void its_end_is_silence() {
        Bench bench;
        bench.playback->toggle(1);
        bench.loudspeaker.play(0.4);
        QVERIFY(bench.voice.recording_plays());
        bench.playback = nullptr;
        QVERIFY(!bench.loudspeaker.playing());
        QVERIFY(!bench.voice.recording_plays()); // who speaks then is heard
    }
};

} // namespace tag_playback_test

TP_TEST(tag_playback_test, TagPlaybackTest, window)
#include "tag_playback_test.moc"
