// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/spoken_voice.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTest>

namespace spoken_voice_test {

using namespace tp;

class SpokenVoiceTest : public QObject {
    Q_OBJECT
private slots:
    void nothing_is_looked_for_before_the_first_word() {
        SpokenVoice voice;
        voice.stop();
        voice.set_rate(0.5);
        QCOMPARE(voice.state(), Voice::State::asleep);
    }

    /// Whatever this machine has: the voice says honestly whether there is one, and goes away cleanly.
    void it_tells_whether_there_is_an_engine() {
        SpokenVoice voice;
        QSignalSpy changed(&voice, &Voice::state_changed);
        voice.say("One face.", Priority::message);
        QCOMPARE(voice.state(), Voice::State::starting);
        QTRY_VERIFY_WITH_TIMEOUT(voice.state() != Voice::State::starting, 60000);
        QVERIFY(voice.state() == Voice::State::ready || voice.state() == Voice::State::missing);
        QVERIFY(changed.size() >= 2);
        voice.say("left eye", Priority::touch);
        voice.stop();
    }

    void it_can_go_away_while_it_still_looks() {
        SpokenVoice voice;
        voice.say("One face.", Priority::message);
    }
};

} // namespace spoken_voice_test

TP_TEST(spoken_voice_test, SpokenVoiceTest, event_loop)
#include "spoken_voice_test.moc"
