// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/speech_queue.hpp"
#include "test_program.hpp"

#include <QStringList>
#include <QTest>

namespace speech_queue_test {

using namespace tp;

namespace {

class FakeEngine final : public SpeechEngine {
public:
    void speak(quint64 id, const QString& text) override {
        speaking = id;
        begun << text;
    }
    void cancel() override {
        cancelled = speaking;
        speaking = 0;
    }
    quint64 speaking = 0;
    quint64 cancelled = 0;
    QStringList begun;
};

struct Bench {
    FakeEngine engine;
    SpeechQueue queue{engine};
    Bench() { queue.open(true); }
    void end() { queue.finished(std::exchange(engine.speaking, 0)); }
};

} // namespace

class SpeechQueueTest : public QObject {
    Q_OBJECT
private slots:
    void touch_interrupts_touch() {
        Bench bench;
        bench.queue.say("left eye", Priority::touch);
        bench.queue.say("lips", Priority::touch);
        QCOMPARE(bench.engine.begun, QStringList({"left eye", "lips"}));
        QVERIFY(bench.engine.cancelled != 0);
    }

    void messages_are_spoken_in_turn() {
        Bench bench;
        bench.queue.say("one", Priority::message);
        bench.queue.say("two", Priority::message);
        QCOMPARE(bench.engine.begun, QStringList({"one"}));
        bench.end();
        QCOMPARE(bench.engine.begun, QStringList({"one", "two"}));
    }

    void a_message_interrupts_touch_and_touch_waits_for_it() {
        Bench bench;
        bench.queue.say("left eye", Priority::touch);
        bench.queue.say("One face.", Priority::message);
        bench.queue.say("lips", Priority::touch);
        bench.queue.say("right eye", Priority::touch);
        QCOMPARE(bench.engine.begun, QStringList({"left eye", "One face."}));
        bench.end();
        bench.end();
        QCOMPARE(bench.engine.begun, QStringList({"left eye", "One face.", "right eye"})); // the newest only
    }

    void a_fault_interrupts_and_the_message_comes_back() {
        Bench bench;
        bench.queue.say("One face.", Priority::message);
        bench.queue.say("The force is off.", Priority::fault);
        QCOMPARE(bench.engine.begun, QStringList({"One face.", "The force is off."}));
        bench.end();
        QCOMPARE(bench.engine.begun.back(), QString("One face."));
    }

    void faults_are_never_dropped() {
        Bench bench;
        bench.queue.say("first", Priority::fault);
        bench.queue.say("second", Priority::fault);
        bench.queue.say("story", Priority::message);
        bench.queue.stop();
        QCOMPARE(bench.engine.cancelled, 0u); // not even the one that is being spoken
        bench.end();
        QCOMPARE(bench.engine.begun, QStringList({"first", "second"}));
        bench.end();
        QCOMPARE(bench.engine.begun.size(), 2);
    }

    void it_is_idle_once_everything_was_spoken_or_dropped() {
        Bench bench;
        QVERIFY(bench.queue.idle());
        bench.queue.set_recording_plays(true);
        bench.queue.say("one", Priority::message);
        bench.queue.say("two", Priority::touch);
        QVERIFY(!bench.queue.idle());
        bench.queue.set_recording_plays(false);
        bench.queue.stop();
        QVERIFY(bench.queue.idle());
    }
    void stop_silences_the_rest() {
        Bench bench;
        bench.queue.say("a long message", Priority::message);
        bench.queue.say("another", Priority::message);
        bench.queue.stop();
        QVERIFY(bench.engine.cancelled != 0);
        QCOMPARE(bench.engine.begun.size(), 1);
    }

    void a_recording_is_never_talked_over_but_a_fault_gets_through() {
        Bench bench;
        bench.queue.set_recording_plays(true);
        bench.queue.say("left eye", Priority::touch);
        bench.queue.say("One face.", Priority::message);
        QVERIFY(bench.engine.begun.isEmpty());
        bench.queue.say("The device was switched off.", Priority::fault);
        QCOMPARE(bench.engine.begun, QStringList({"The device was switched off."}));
        bench.queue.say("lips", Priority::touch); // does not interrupt the fault
        QCOMPARE(bench.engine.cancelled, 0u);
        bench.end();
        QCOMPARE(bench.engine.begun.size(), 1);
        bench.queue.set_recording_plays(false);
        QCOMPARE(bench.engine.begun.back(), QString("One face."));
        bench.end();
        QCOMPARE(bench.engine.begun.back(), QString("lips"));
    }

    void what_is_said_before_the_engine_is_there_waits_for_it() {
        FakeEngine engine;
        SpeechQueue queue{engine};
        queue.say("Looking for faces.", Priority::message);
        QVERIFY(engine.begun.isEmpty());
        queue.open(true);
        QCOMPARE(engine.begun, QStringList({"Looking for faces."}));
    }

    void what_an_engine_that_goes_was_given_is_spoken_by_the_next() {
        for (const Priority priority : {Priority::touch, Priority::message, Priority::fault}) {
            Bench bench;
            bench.queue.say("One face.", priority);
            bench.queue.open(false);
            QVERIFY(!bench.queue.idle());
            bench.queue.open(true);
            QCOMPARE(bench.engine.begun, QStringList({"One face.", "One face."}));
            bench.end();
            QVERIFY(bench.queue.idle());
        }
    }

    void a_late_end_of_a_cancelled_text_does_not_end_the_next() {
        Bench bench;
        bench.queue.say("left eye", Priority::touch);
        const quint64 old = bench.engine.speaking;
        bench.queue.say("lips", Priority::touch);
        bench.queue.say("One face.", Priority::message); // interrupts "lips"
        bench.queue.say("nose", Priority::touch);
        bench.queue.finished(old);
        QCOMPARE(bench.engine.begun.back(), QString("One face."));
        bench.end();
        QCOMPARE(bench.engine.begun.back(), QString("nose"));
    }

    void an_empty_text_is_nothing() {
        Bench bench;
        bench.queue.say("", Priority::fault);
        QVERIFY(bench.engine.begun.isEmpty());
    }
};

} // namespace speech_queue_test

TP_TEST(speech_queue_test, SpeechQueueTest, event_loop)
#include "speech_queue_test.moc"
