// SPDX-License-Identifier: Apache-2.0
#include "app/parts/controls/recording_announcer.hpp"
#include "app/parts/narration/narrator.hpp"
#include "audio/speech/recording_voice.hpp"

#include <QTest>

using namespace tp;


class NarratorTest : public QObject {
    Q_OBJECT
private slots:
    void voice_and_screen_reader_never_talk_at_once() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        narrator.tell("left eye", Priority::touch);
        QCOMPARE(voice.said(), QStringList("left eye"));
        QVERIFY(announcer.announced().isEmpty());
        narrator.set_voice_on(false);
        narrator.tell("lips", Priority::touch);
        QCOMPARE(voice.said(), QStringList("left eye"));
        QCOMPARE(announcer.announced(), QStringList({"Voice off.", "lips"}));
        QVERIFY(narrator.voice_problem().isEmpty());
    }
    void what_waits_for_a_sentence_comes_once_it_has_been_said() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        QStringList order;
        voice.set_busy(true);
        narrator.tell_then("Story by Tom.", [&] { order << "first"; });
        narrator.tell_then("Memo by Anna.", [&] { order << "second"; });
        QVERIFY(narrator.speaking());
        QVERIFY(order.isEmpty());
        voice.set_busy(false);
        QCOMPARE(order, QStringList("second"));
        voice.set_busy(true);
        narrator.tell_then("Story by Tom.", [&] { order << "dropped"; });
        narrator.stop();
        voice.set_busy(false);
        QCOMPARE(order, QStringList("second"));
    }
    void a_screen_reader_tells_nobody_when_it_has_ended_so_about_as_long_is_waited() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer, Narrator::By::screen_reader);
        bool went_on = false;
        narrator.tell_then("Memo.", [&] { went_on = true; });
        QVERIFY(!went_on);
        QTRY_VERIFY(went_on);
        narrator.set_by(Narrator::By::nobody);
        went_on = false;
        narrator.tell_then("Memo.", [&] { went_on = true; });
        QTRY_VERIFY(went_on);
    }
    void what_waits_for_an_engine_that_is_not_found_goes_on_as_well() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        voice.set_state(Voice::State::starting);
        voice.set_busy(true);
        bool went_on = false;
        narrator.tell_then("Memo.", [&] { went_on = true; });
        voice.set_state(Voice::State::missing);
        QCOMPARE(announcer.announced(), QStringList("Memo."));
        QTRY_VERIFY(went_on);
    }
    void without_an_engine_the_screen_reader_is_told_and_the_page_says_so() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        voice.set_state(Voice::State::missing);
        narrator.tell("One face.", Priority::message);
        QCOMPARE(announcer.announced(), QStringList("One face."));
        QVERIFY(narrator.voice_problem().contains("No speech engine"));
    }
    void what_was_said_to_an_engine_that_is_not_found_is_not_lost() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        voice.set_state(Voice::State::starting);
        narrator.tell("Looking for faces…", Priority::message);
        narrator.tell("One face.", Priority::message);
        voice.set_state(Voice::State::missing);
        QCOMPARE(announcer.announced(), QStringList("One face."));
    }
};

QTEST_GUILESS_MAIN(NarratorTest)
#include "narrator_test.moc"
