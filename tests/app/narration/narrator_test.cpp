// SPDX-License-Identifier: Apache-2.0
#include "app/controls/recording_announcer.hpp"
#include "app/narration/narrator.hpp"
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
