// SPDX-License-Identifier: Apache-2.0
// Two share a recorder: what it does for one is not told to the other.
#include "audio/sound/recorder_take.hpp"
#include "fake_microphone.hpp"
#include "sound_files.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>

namespace recorder_take_test {

using namespace tp;
using State = RecorderTake::State;

namespace {

struct Bench {
    QTemporaryDir place;
    std::atomic<testing::FakeMicrophone*> microphone{nullptr}; ///< on the recorder's thread
    Recorder recorder{[this] {
        auto made = std::make_unique<testing::FakeMicrophone>();
        microphone = made.get();
        return made;
    }};
    RecorderTake take{recorder}, other{recorder};
    QSignalSpy heard{&take, &RecorderTake::heard};
    QSignalSpy said{&take, &RecorderTake::said};
    QSignalSpy done{&take, &RecorderTake::done};
    QSignalSpy failed{&take, &RecorderTake::failed};

    ~Bench() { recorder.discard(); }
    RecordingPlan plan(const char* folder = "a.tags") const {
        RecordingPlan plan;
        plan.folder = std::filesystem::path(place.path().toStdString()) / folder;
        return plan;
    }
    void with_microphone(const std::function<void(testing::FakeMicrophone&)>& what) {
        QTRY_VERIFY_WITH_TIMEOUT(recorder.state() == RecorderState::waiting, 60000);
        testing::FakeMicrophone* const made = microphone;
        QMetaObject::invokeMethod(
            made, [made, what] { what(*made); }, Qt::BlockingQueuedConnection);
    }
    void hear() {
        with_microphone(
            [](testing::FakeMicrophone& made) { made.hear(testing::tone(440.0, 1.0, sound_rate)); });
        QTRY_VERIFY_WITH_TIMEOUT(recorder.state() == RecorderState::recording, 60000);
    }
    void lead_to(State state) {
        if (state != State::idle)
            take.begin(plan());
        if (state == State::recording || state == State::finishing)
            hear();
        if (state == State::finishing)
            take.finish();
        QVERIFY(take.state() == state);
    }
};

constexpr State all[] = {State::idle, State::waiting, State::recording, State::finishing};

} // namespace

class RecorderTakeTest : public QObject {
    Q_OBJECT
private slots:
    void one_begins_only_where_the_recorder_is_free() {
        for (const State from : all) {
            Bench bench;
            bench.lead_to(from);
            QCOMPARE(bench.take.can_begin(), from == State::idle);
            QCOMPARE(bench.take.running(), from != State::idle);
            bench.take.begin(bench.plan());
            QVERIFY(bench.take.state() == (from == State::idle ? State::waiting : from));
        }
        Bench bench;
        bench.lead_to(State::recording);
        QVERIFY(!bench.other.can_begin());
        bench.other.begin(bench.plan());
        QVERIFY(bench.other.state() == State::idle);
    }

    void the_first_sound_is_told_once() {
        Bench bench;
        bench.lead_to(State::waiting);
        QVERIFY(bench.heard.isEmpty());
        bench.hear();
        QCOMPARE(bench.heard.size(), 1);
        bench.recorder.pause();
        QTRY_VERIFY_WITH_TIMEOUT(bench.recorder.state() == RecorderState::paused, 60000);
        bench.recorder.go_on();
        bench.hear();
        QCOMPARE(bench.heard.size(), 1);
        QVERIFY(bench.take.state() == State::recording);
    }

    void it_is_ended_once_and_is_idle_when_the_file_is_there() {
        Bench bench;
        QVERIFY(!bench.take.finish());
        bench.lead_to(State::recording);
        State at_the_end = State::recording;
        connect(&bench.take, &RecorderTake::done, &bench.take, [&] { at_the_end = bench.take.state(); });
        QVERIFY(bench.take.finish());
        QVERIFY(!bench.take.finish());
        QVERIFY(bench.take.state() == State::finishing);
        QTRY_COMPARE_WITH_TIMEOUT(bench.done.size(), 1, 60000);
        QVERIFY(at_the_end == State::idle);
        const auto recording = bench.done.at(0).at(0).value<FinishedRecording>();
        QVERIFY(std::filesystem::exists(recording.file));
        QCOMPARE(recording.duration_s, 1.0);
        QTRY_VERIFY_WITH_TIMEOUT(bench.take.can_begin(), 60000);
    }

    void what_is_thrown_away_tells_nothing_any_more() {
        for (const State from : {State::idle, State::waiting, State::recording}) {
            Bench bench;
            bench.lead_to(from);
            bench.take.discard();
            QVERIFY(bench.take.state() == State::idle);
            QTRY_VERIFY_WITH_TIMEOUT(bench.take.can_begin(), 60000);
            QVERIFY(bench.done.isEmpty() && bench.failed.isEmpty());
        }
    }

    void one_that_cannot_be_made_is_idle_again() {
        Bench bench;
        QVERIFY(QFile(bench.place.filePath("no.tags")).open(QIODevice::WriteOnly));
        bench.take.begin(bench.plan("no.tags"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.failed.size(), 1, 60000);
        QVERIFY(bench.take.state() == State::idle);
        QVERIFY(bench.heard.isEmpty() && bench.done.isEmpty());
    }

    void what_is_said_and_made_for_another_is_not_told_here() {
        Bench bench;
        const QSignalSpy to_other(&bench.other, &RecorderTake::said);
        const QSignalSpy made(&bench.other, &RecorderTake::done);
        bench.other.begin(bench.plan());
        bench.with_microphone([](testing::FakeMicrophone& microphone) {
            microphone.hear(testing::tone(440.0, 1.0, sound_rate));
            microphone.vanish();
        });
        QTRY_VERIFY_WITH_TIMEOUT(!to_other.isEmpty(), 60000);
        QVERIFY(!bench.take.finish());
        bench.take.discard(); // nothing of its own
        bench.other.finish();
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), 1, 60000);
        QVERIFY(bench.heard.isEmpty() && bench.said.isEmpty() && bench.done.isEmpty() &&
                bench.failed.isEmpty());
        QVERIFY(bench.take.state() == State::idle);
    }
};

} // namespace recorder_take_test

TP_TEST(recorder_take_test, RecorderTakeTest, event_loop)
#include "recorder_take_test.moc"
