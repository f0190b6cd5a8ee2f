// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/recording_file.hpp"
#include "audio/recordings/repair_folder.hpp"
#include "audio/sound/recorder.hpp"
#include "audio/sound/sound_file.hpp"
#include "audio/sound/sound_format.hpp"
#include "audio/sound/sound_words.hpp"
#include "fake_microphone.hpp"
#include "sound_files.hpp"
#include "test_program.hpp"

#include <QDateTime>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>

namespace recorder_test {

using namespace tp;
using namespace tp::testing;
using State = RecorderState;
namespace fs = std::filesystem;

namespace {

struct Bench {
    QTemporaryDir place;
    fs::path folder = fs::path(place.path().toStdString()) / "IMG_1.jpg.tags";
    std::uint64_t free = 10'000'000'000;
    FakeMicrophone* microphone = nullptr;
    RecorderWorker recorder{[this] {
                                auto made = std::make_unique<FakeMicrophone>();
                                microphone = made.get();
                                microphone->there = microphone_there;
                                return made;
                            },
                            [this](const fs::path&) { return std::optional(free); }};
    bool microphone_there = true;
    QSignalSpy said{&recorder, &RecorderWorker::said};
    QSignalSpy done{&recorder, &RecorderWorker::done};
    QSignalSpy failed{&recorder, &RecorderWorker::failed};
    QSignalSpy times{&recorder, &RecorderWorker::time_changed};
    QSignalSpy levels{&recorder, &RecorderWorker::level_changed};

    void start(double longest_s = 3600.0) {
        RecordingPlan plan;
        plan.folder = folder;
        plan.notes.label.kind = RecordingKind::story;
        plan.notes.label.person = "Anna";
        plan.notes.label.recorded = "2026-05-01T10:15:00+02:00";
        plan.longest_s = longest_s;
        recorder.start(plan);
    }
    void hear(double seconds, double amplitude = 0.25) {
        microphone->hear(tone(440.0, seconds, sound_rate, amplitude));
    }
    FinishedRecording result() const { return done.last().at(0).value<FinishedRecording>(); }
    std::vector<float> stored() const {
        auto file = SoundFile::open(result().file);
        return file ? file.value().read(60 * sound_rate) : std::vector<float>{};
    }
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder))
            names.push_back(entry.path().filename().string());
        return names;
    }
};

} // namespace

class RecorderTest : public QObject {
    Q_OBJECT
private slots:
    void what_is_heard_is_stored_with_its_label() {
        Bench bench;
        bench.start();
        QCOMPARE(bench.recorder.state(), State::waiting);
        bench.hear(2.0);
        QCOMPARE(bench.recorder.state(), State::recording);
        bench.recorder.finish();
        QCOMPARE(bench.recorder.state(), State::idle);
        QCOMPARE(bench.done.size(), 1);
        QVERIFY(!bench.microphone->on());
        QCOMPARE(bench.files(), std::vector<std::string>{"2026-05-01T101500-story.flac"});
        const FinishedRecording result = bench.result();
        QCOMPARE(result.duration_s, 2.0);
        QCOMPARE(result.sentence, QString("Recorded: 2 seconds."));
        QVERIFY2(std::abs(result.gain_db - loudness_of(result.file).value().gain_db()) < 0.01,
                 "the gain is the file's");
        const auto about = about_recording(result.file);
        QVERIFY(about.ok());
        QCOMPARE(about->notes.label.person, std::string("Anna"));
        const std::vector<float> stored = bench.stored();
        const std::vector<float> source = tone(440.0, 2.0, sound_rate, 0.25);
        QCOMPARE(stored.size(), source.size());
        for (std::size_t i = 0; i < stored.size(); ++i)
            QVERIFY(std::abs(stored[i] - source[i]) < 1e-4F);
    }

    void the_level_is_told_for_a_meter() {
        Bench bench;
        bench.start();
        bench.hear(0.5);
        QVERIFY(!bench.levels.isEmpty());
        QVERIFY(std::abs(bench.levels.last().at(0).toDouble() + 12.04) < 0.1);
        QVERIFY(std::abs(bench.levels.last().at(1).toDouble() + 12.04) < 0.1);
    }

    void a_pause_is_left_out() {
        Bench bench;
        bench.start();
        bench.hear(1.0);
        bench.recorder.pause();
        QCOMPARE(bench.recorder.state(), State::paused);
        QVERIFY(!bench.microphone->on()); // nobody is listened to meanwhile
        bench.hear(5.0);
        bench.recorder.go_on();
        bench.hear(1.0);
        bench.recorder.finish();
        QCOMPARE(bench.result().duration_s, 2.0);
    }

    void a_paused_recording_can_be_finished() {
        Bench bench;
        bench.start();
        bench.hear(1.0);
        bench.recorder.pause();
        bench.recorder.finish();
        QCOMPARE(bench.result().duration_s, 1.0);
    }

    void a_microphone_that_hears_nothing_is_told_once() {
        Bench bench;
        bench.start();
        bench.hear(2.0);
        QVERIFY(bench.said.isEmpty());
        bench.microphone->hear_nothing(10.0);
        bench.hear(1.0);
        bench.microphone->hear_nothing(10.0);
        QCOMPARE(bench.said.size(), 1);
        QVERIFY(bench.said.last().at(0).toString().startsWith("The microphone picks up nothing."));
    }

    void a_microphone_that_goes_costs_nothing_that_was_recorded() {
        Bench bench;
        bench.start();
        bench.hear(1.5);
        bench.microphone->vanish();
        QCOMPARE(bench.recorder.state(), State::waiting);
        QCOMPARE(bench.said.size(), 1);
        QCOMPARE(bench.files().size(), 1u);
        bench.microphone->come();
        bench.hear(0.5);
        QCOMPARE(bench.recorder.state(), State::recording);
        QCOMPARE(bench.said.size(), 2);
        bench.microphone->stall();
        QCOMPARE(bench.said.size(), 3);
        bench.microphone->come();
        bench.microphone->stall(); // again, before anything was heard: not said again
        QCOMPARE(bench.said.size(), 3);
        bench.recorder.finish();
        QCOMPARE(bench.result().duration_s, 2.0);
    }

    void without_a_microphone_it_waits_for_one() {
        Bench bench;
        bench.microphone_there = false;
        bench.start();
        QCOMPARE(bench.recorder.state(), State::waiting);
        QCOMPARE(bench.said.last().at(0).toString(),
                 QString("There is no microphone. The recording begins as soon as there is one."));
        bench.microphone->come();
        bench.hear(1.0);
        bench.recorder.finish();
        QCOMPARE(bench.result().duration_s, 1.0);
    }

    void nothing_recorded_leaves_nothing() {
        Bench bench;
        bench.start();
        bench.recorder.finish();
        QCOMPARE(bench.failed.size(), 1);
        QVERIFY(bench.files().empty());
        QCOMPARE(bench.recorder.state(), State::idle);
    }

    void only_discard_throws_away() {
        Bench bench;
        bench.start();
        bench.hear(1.0);
        bench.recorder.discard();
        QCOMPARE(bench.recorder.state(), State::idle);
        QVERIFY(bench.files().empty());
        QVERIFY(bench.done.isEmpty() && bench.failed.isEmpty());
        bench.start();
        bench.hear(1.0);
        bench.recorder.finish();
        QCOMPARE(bench.done.size(), 1);
    }

    void it_ends_at_the_stated_length_to_the_sample() {
        Bench bench;
        bench.start(1.234);
        bench.hear(5.0);
        QCOMPARE(bench.done.size(), 1);
        QCOMPARE(bench.stored().size(), static_cast<std::size_t>(1.234 * sound_rate));
        QVERIFY(bench.result().sentence.contains("at most"));
        QVERIFY(!bench.microphone->on());
    }

    void it_leaves_room_on_the_disk_and_tells_how_much_is_left() {
        Bench bench;
        bench.free = kept_free_bytes + 2 * 96'000 * 90;
        bench.start();
        QVERIFY(std::abs(bench.times.last().at(1).toDouble() - 90.0) < 0.01);
        bench.hear(1.0);
        QVERIFY(bench.said.isEmpty());
        bench.free = kept_free_bytes + 2 * 96'000 * 30;
        bench.hear(2.0);
        QCOMPARE(bench.said.size(), 1);
        QVERIFY(bench.said.last().at(0).toString().startsWith("The disk is almost full: "));
        bench.free = kept_free_bytes;
        bench.hear(1.0);
        QCOMPARE(bench.done.size(), 1);
        QVERIFY(bench.result().sentence.startsWith("The disk is almost full, so the recording has ended."));
        QCOMPARE(bench.result().duration_s, 4.0);
    }

    void without_room_it_does_not_begin() {
        Bench bench;
        bench.free = kept_free_bytes;
        bench.start();
        QCOMPARE(bench.failed.size(), 1);
        QCOMPARE(bench.recorder.state(), State::idle);
        QVERIFY(!fs::exists(bench.folder));
    }

    void a_folder_that_cannot_be_made_is_a_sentence() {
        Bench bench;
        write_wav(bench.folder, {}, sound_rate); // a file of that name
        bench.start();
        QCOMPARE(bench.failed.size(), 1);
        QVERIFY(bench.failed.last().at(0).toString().startsWith("The recording cannot be made: "));
        bench.recorder.finish();
        bench.recorder.discard();
        bench.recorder.pause();
        bench.recorder.go_on();
        QCOMPARE(bench.recorder.state(), State::idle);
    }

    void a_program_that_ends_meanwhile_leaves_what_can_be_repaired() {
        auto bench = std::make_unique<Bench>();
        bench->place.setAutoRemove(false);
        const fs::path folder = bench->folder;
        bench->start();
        bench->hear(1.7);
        bench.reset();
        const auto repaired = repair_folder(folder);
        QVERIFY(repaired.ok());
        QCOMPARE(repaired->size(), 1u);
        QVERIFY(repaired->front().outcome == RepairedPart::Outcome::stored);
        QCOMPARE(SoundFile::open(repaired->front().file).value().duration_s(), 1.7);
        fs::remove_all(folder.parent_path());
    }

    void durations_in_words() {
        QCOMPARE(duration_words(0.0), QString("0 seconds"));
        QCOMPARE(duration_words(1.2), QString("1 second"));
        QCOMPARE(duration_words(65.0), QString("1 minute 5 seconds"));
        QCOMPARE(duration_words(120.0), QString("2 minutes"));
        QCOMPARE(duration_words(3599.0), QString("1 hour"));
        QCOMPARE(duration_words(3 * 3600.0 + 65.0), QString("3 hours 1 minute"));
        QCOMPARE(duration_words(-1.0), QString("0 seconds"));
    }

    void the_systems_disk_has_an_answer() {
        QVERIFY(free_bytes("/").has_value());
        QVERIFY(free_bytes("/a/folder/that/is/not/there/yet").has_value());
        QVERIFY(free_bytes("not_there_yet").has_value());
        QVERIFY(!free_bytes("/dev/null/x").has_value());
    }

    void on_its_own_thread() {
        const QTemporaryDir place;
        std::atomic<FakeMicrophone*> microphone{nullptr};
        Recorder recorder([&microphone] {
            auto made = std::make_unique<FakeMicrophone>();
            microphone = made.get();
            return made;
        });
        QSignalSpy done(&recorder, &Recorder::done);
        RecordingPlan plan;
        plan.folder = place.path().toStdString();
        recorder.start(plan);
        QTRY_COMPARE_WITH_TIMEOUT(recorder.state(), State::waiting, 60000);
        FakeMicrophone* const made = microphone;
        QMetaObject::invokeMethod(made, [made] { made->hear(tone(440.0, 1.0, sound_rate)); });
        QTRY_COMPARE_WITH_TIMEOUT(recorder.recorded_s(), 1.0, 60000);
        QVERIFY(recorder.rms_dbfs() > -10.0);
        QVERIFY(recorder.left_s() > 0.0);
        recorder.finish();
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, 60000);
        QCOMPARE(recorder.state(), State::idle);
        const auto about = about_recording(done.last().at(0).value<FinishedRecording>().file);
        QVERIFY(about);
        const QString recorded = QString::fromStdString(about->notes.label.recorded); // now, with its offset
        QVERIFY2(QDateTime::fromString(recorded, Qt::ISODate).isValid() && recorded.size() >= 20,
                 qPrintable(recorded));
        recorder.start(plan); // and is destroyed meanwhile
    }
};

} // namespace recorder_test

TP_TEST(recorder_test, RecorderTest, event_loop)
#include "recorder_test.moc"
