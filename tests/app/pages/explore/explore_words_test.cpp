// SPDX-License-Identifier: Apache-2.0
#include "explore_parts.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QStringList>
#include <QTest>

namespace explore_words_test {

using namespace tp;

class ExploreWordsTest : public QObject {
    Q_OBJECT
private slots:
    void what_is_told_is_shown_and_spoken() {
        ExploreParts bench(0);
        const QSignalSpy changes(&bench.words, &ExploreWords::sentenceChanged);
        bench.words.tell("One.", Priority::message);
        bench.words.tell("One.", Priority::touch);
        QCOMPARE(bench.voice.said(), QStringList({"One.", "One."}));
        QCOMPARE(bench.voice.last_priority(), Priority::touch);
        QCOMPARE(bench.words.sentence(), QString("One."));
        QCOMPARE(changes.count(), 1);
        bench.words.murmur("left eye");
        QCOMPARE(bench.said(), QString("left eye"));
        QCOMPARE(bench.words.sentence(), QString("One."));
    }

    void out_of_sight_it_is_only_shown() {
        ExploreParts bench(0);
        bench.words.leave();
        bench.words.tellProblem("Something is wrong.");
        bench.words.murmur("left eye");
        QCOMPARE(bench.voice.said(), QStringList());
        QVERIFY(!bench.sounds.hears(Earcon::error));
        QCOMPARE(bench.words.sentence(), QString("Something is wrong."));
        bench.words.enter();
        bench.words.tellProblem("Something is wrong.");
        QCOMPARE(bench.voice.said(), QStringList("Something is wrong."));
        QVERIFY(bench.sounds.hears(Earcon::error));
    }

    void it_knows_when_it_will_have_been_spoken() {
        ExploreParts bench(0);
        const double then = bench.words.tell("A rather long sentence about a photograph.", Priority::message);
        QVERIFY(then > bench.time + 1.0);
        QCOMPARE(bench.words.busy_until(), then);
        QVERIFY(bench.words.tell("A", Priority::touch) < then);
        QCOMPARE(bench.words.busy_until(), then);
    }

    void who_switches_the_voice_off_keeps_it_off() {
        ExploreParts bench(0);
        const QSignalSpy changes(&bench.words, &ExploreWords::voiceChanged);
        bench.words.setVoiceOn(false);
        QVERIFY(!bench.words.voiceOn());
        QVERIFY(changes.count() > 0);
        QCOMPARE(bench.sounds.preferences.choices().voice, Choices::Voice::screen_reader);
        bench.words.setVoiceOn(true);
        QCOMPARE(bench.sounds.preferences.choices().voice, Choices::Voice::program);
    }
};

} // namespace explore_words_test

TP_TEST(explore_words_test, ExploreWordsTest, event_loop)
#include "explore_words_test.moc"
