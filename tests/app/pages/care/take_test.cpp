// SPDX-License-Identifier: Apache-2.0
// A recording being made for the photograph that is open, without a session.
#include "care_bench.hpp"
#include "sound_files.hpp"
#include "test_program.hpp"

#include <QSignalSpy>

#include <filesystem>
#include <string>

namespace take_test {

using namespace tp;
using State = Take::State;
namespace fs = std::filesystem;

class TakeTest : public QObject {
    Q_OBJECT
private slots:
    void a_take_is_recorded_saved_and_chosen() {
        CareParts bench;
        bench.open("a.jpg");
        bench.take.setKind(static_cast<int>(RecordingKind::story));
        bench.take.start();
        QVERIFY(bench.take.running());
        bench.hear(2.0);
        CARE_TRY_COMPARE(bench.take.stateText(), QString("Recording"));
        QVERIFY(bench.sounded(Earcon::recording_started));
        CARE_TRY_COMPARE(bench.take.time(), QString("0:02"));
        QVERIFY(bench.take.level() > 0.8);
        QCOMPARE(bench.take.levelText(), QString("good"));
        bool stop_sounded = false;
        connect(&bench.take, &Take::changed, &bench.take, [&] {
            if (!bench.take.running())
                stop_sounded = stop_sounded || bench.sounded(Earcon::recording_stopped);
        });
        bench.take.finish();
        CARE_TRY_VERIFY(!bench.take.running());
        QVERIFY(stop_sounded);
        QVERIFY(bench.rests());
        QCOMPARE(bench.last_said(), QString("Recorded: 2 seconds. Saved."));
        QVERIFY(bench.sounded(Earcon::saved));
        const PhotoRecord record = bench.record();
        QCOMPARE(record.tags.size(), std::size_t{1});
        QVERIFY(record.tags[0].label.kind == RecordingKind::story);
        QCOMPARE(record.tags[0].label.language, std::string("en"));
        QCOMPARE(record.tags[0].duration_s, 2.0);
        QVERIFY(!record.tags[0].label.recorded.empty());
        QCOMPARE(bench.recordings.chosen(), 0);
    }

    void a_pause_is_left_out() {
        CareParts bench;
        bench.open("a.jpg");
        bench.take.start();
        bench.hear(1.0);
        bench.take.pauseOrGoOn();
        CARE_TRY_VERIFY(bench.take.paused());
        QCOMPARE(bench.take.level(), 0.0);
        bench.take.pauseOrGoOn();
        CARE_TRY_VERIFY(!bench.take.paused());
        bench.hear(1.0);
        bench.take.finish();
        CARE_TRY_VERIFY(!bench.take.running());
        QVERIFY(bench.rests());
        QCOMPARE(bench.record().tags.at(0).duration_s, 2.0);
    }

    void nothing_is_thrown_away_before_it_was_asked() {
        CareParts bench;
        bench.open("a.jpg");
        bench.take.start();
        bench.hear(1.0);
        bench.take.discard();
        QVERIFY(bench.take.running());
        bench.take.askDiscard();
        CARE_TRY_VERIFY(bench.take.paused());
        QVERIFY(bench.take.asking());
        QCOMPARE(bench.last_said(), QString("Discard what was recorded? It cannot be brought back."));
        bench.take.keepOn();
        QVERIFY(!bench.take.asking() && bench.take.running());
        bench.take.askDiscard();
        bench.take.discard();
        QVERIFY(!bench.take.running());
        CARE_TRY_COMPARE(bench.recorder.state(), RecorderState::idle);
        QVERIFY(bench.rests());
        QVERIFY(bench.record().tags.empty());
    }

    void a_recording_is_made_anew_in_its_place_and_the_old_one_is_in_the_trash() {
        TwoRecordings bench;
        bench.recordings.choose(1);
        bench.recordings.move(-1); // the story first
        QVERIFY(bench.rests());
        bench.recordings.setPerson("Anna");
        QVERIFY(bench.rests());
        bench.take.startAgain();
        bench.hear(3.0);
        bench.take.finish();
        CARE_TRY_VERIFY(!bench.take.running());
        QVERIFY(bench.rests());
        QCOMPARE(texts(bench.recordings), QStringList({"Story, about Anna", "Memo"}));
        QCOMPARE(bench.recordings.chosen(), 0);
        QCOMPARE(bench.recordings.chosen_tag()->duration_s, 3.0);
        QVERIFY(!fs::exists(bench.file(bench.story)));
        QVERIFY(bench.album->keeper_for(bench.photo("a.jpg")).is_in_trash(bench.photo("a.jpg"), bench.story));
    }

    /// Though nobody has put them in order.
    void one_of_a_kind_is_made_anew_in_its_place() {
        CareParts bench;
        for (const double seconds : {1.0, 2.0}) {
            const auto sound =
                a_sound(bench.folder, "sounds/" + std::to_string(seconds) + ".wav", seconds, 500.0);
            QVERIFY(
                bench.album->keeper_for(bench.photo("a.jpg"))
                    .add_recording(bench.photo("a.jpg"), sound, {RecordingKind::story, {}, {}, {}, {}, {}})
                    .ok());
        }
        bench.open("a.jpg");
        bench.recordings.choose(0);
        bench.take.startAgain();
        bench.hear(3.0);
        bench.take.finish();
        CARE_TRY_VERIFY(!bench.take.running());
        QVERIFY(bench.rests());
        QCOMPARE(bench.recordings.chosen_tag()->duration_s, 3.0);
        QCOMPARE(bench.recordings.chosen(), 0);
    }

    void what_is_recorded_again_is_of_now() {
        CareParts bench;
        RecordingLabel old{RecordingKind::story, {}, {}, {}, {}, {}};
        old.recorded = "2020-05-01T10:00:00+02:00";
        const auto sound = a_sound(bench.folder, "sounds/old.wav", 1.0, 500.0);
        QVERIFY(
            bench.album->keeper_for(bench.photo("a.jpg")).add_recording(bench.photo("a.jpg"), sound, old));
        bench.open("a.jpg");
        bench.recordings.choose(0);
        QCOMPARE(bench.recordings.chosen_tag()->label.recorded, old.recorded);
        bench.take.startAgain();
        bench.hear(1.0);
        bench.take.finish();
        CARE_TRY_VERIFY(!bench.take.running());
        QVERIFY(bench.rests());
        const RecordingLabel& label = bench.recordings.chosen_tag()->label;
        QVERIFY2(label.recorded > old.recorded, label.recorded.c_str());
    }

    void where_nothing_can_be_written_it_is_told_and_nothing_runs() {
        CareParts bench;
        bench.open("a.jpg");
        bench.folder.write("album/a.jpg.tags", "a file in the place of the folder");
        bench.take.start();
        CARE_TRY_VERIFY(!bench.take.running());
        QVERIFY(bench.last_said().startsWith("The recording cannot be made: "));
    }

    void the_table_of_its_states_holds() {
        const auto lead_to = [](CareParts& bench, State state) {
            bench.open("a.jpg");
            if (state != State::None) {
                bench.take.start();
                bench.hear(1.0);
            }
            if (state == State::Asking)
                bench.take.askDiscard();
            QVERIFY(bench.take.state() == state);
        };
        const auto after = [&](State from, void (Take::*what)()) {
            CareParts bench;
            lead_to(bench, from);
            (bench.take.*what)();
            const State to = bench.take.state();
            bench.take.askDiscard();
            bench.take.discard();
            return to;
        };
        QVERIFY(after(State::None, &Take::start) == State::Running);
        QVERIFY(after(State::None, &Take::startAgain) == State::None); // there is none to be made anew
        for (const auto what :
             {&Take::askDiscard, &Take::keepOn, &Take::discard, &Take::finish, &Take::pauseOrGoOn})
            QVERIFY(after(State::None, what) == State::None);
        QVERIFY(after(State::Running, &Take::askDiscard) == State::Asking);
        for (const auto what : {&Take::start, &Take::keepOn, &Take::discard, &Take::pauseOrGoOn})
            QVERIFY(after(State::Running, what) == State::Running);
        QVERIFY(after(State::Asking, &Take::keepOn) == State::Running);
        QVERIFY(after(State::Asking, &Take::discard) == State::None);
        for (const auto what : {&Take::start, &Take::askDiscard, &Take::pauseOrGoOn})
            QVERIFY(after(State::Asking, what) == State::Asking);
    }

    void one_that_was_asked_about_can_still_be_kept() {
        CareParts bench;
        bench.open("a.jpg");
        bench.take.start();
        bench.hear(1.0);
        bench.take.askDiscard();
        bench.take.finish();
        CARE_TRY_VERIFY(bench.take.state() == State::None);
        QVERIFY(bench.rests());
        QCOMPARE(bench.record().tags.size(), std::size_t{1});
    }

    void while_the_recorder_works_for_another_page_none_begins_and_none_is_told() {
        CareParts bench;
        bench.open("a.jpg");
        RecordingPlan others;
        others.folder = bench.folder / "others";
        bench.recorder.start(others);
        bench.hear(1.0);
        const QSignalSpy begins(&bench.take, &Take::begins);
        bench.take.start();
        QCOMPARE(bench.last_said(), QString("The recorder is still busy. Try again in a moment."));
        QVERIFY(bench.sounded(Earcon::error));
        QVERIFY(begins.isEmpty() && !bench.take.running());
        QCOMPARE(bench.take.time(), QString("0:00"));
        QCOMPARE(bench.take.stateText(), QString());
        const QSignalSpy changed(&bench.take, &Take::changed);
        const QSignalSpy done(&bench.recorder, &Recorder::done);
        bench.recorder.finish();
        CARE_TRY_COMPARE(done.size(), 1);
        QVERIFY(changed.isEmpty() && bench.record().tags.empty());
    }

    void all_else_is_silent_before_the_microphone_listens() {
        CareParts bench;
        bench.open("a.jpg");
        int stops = -1;
        RecorderState then = RecorderState::recording;
        connect(&bench.take, &Take::begins, &bench.take, [&] {
            stops = bench.voice.stops();
            then = bench.recorder.state();
        });
        bench.take.start();
        QVERIFY(then == RecorderState::idle);
        QVERIFY(bench.voice.stops() > stops && stops >= 0);
        bench.take.askDiscard();
        bench.take.discard();
    }
};

} // namespace take_test

TP_TEST(take_test, TakeTest, window)
#include "take_test.moc"
