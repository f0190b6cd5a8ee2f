// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/photo_files.hpp"
#include "app/pages/care/recording_wait.hpp"
#include "care_bench.hpp"
#include "test_program.hpp"

#include <QStringList>

namespace recording_wait_test {

using namespace tp;

namespace {

struct Bench : CareParts {
    QStringList done;
    using CareParts::CareParts;

    void after(const QString& what) {
        recording.after([this, what] { done << what; });
    }
    void begin_take() {
        take.start();
        hear(1.0);
    }
};

} // namespace

class RecordingWaitTest : public QObject {
    Q_OBJECT
private slots:
    void where_nothing_is_recorded_a_step_is_done_at_once() {
        Bench bench;
        bench.after("one");
        QCOMPARE(bench.done, QStringList{"one"});
        bench.open();
        bench.after("two");
        QCOMPARE(bench.done, QStringList({"one", "two"}));
    }
    void a_recording_is_ended_and_what_waits_follows_in_order_once() {
        Bench bench;
        bench.open();
        bench.begin_take();
        bench.after("one");
        bench.after("two");
        QCOMPARE(bench.done, QStringList());
        CARE_TRY_VERIFY(!bench.take.running());
        CARE_TRY_COMPARE(bench.done, QStringList({"one", "two"}));
        QVERIFY(bench.rests());
        QCOMPARE(bench.record().tags.size(), std::size_t{1});
        bench.take.setKind(1); // it tells of a change
        QTest::qWait(0);
        QCOMPARE(bench.done.size(), 2);
    }
    void the_recording_has_its_place_in_the_album_before_what_waits_is_asked_for() {
        Bench bench;
        bench.open();
        bench.begin_take();
        std::size_t recordings = 0;
        bench.recording.after([&bench, &recordings] {
            bench.cared.change(
                bench.cared.place(), [](AlbumKeeper&, const std::filesystem::path&) { return std::string(); },
                [&bench, &recordings](const QString&) { recordings = bench.cared.record().tags.size(); });
        });
        CARE_TRY_VERIFY(!bench.take.running());
        CARE_TRY_COMPARE(recordings, std::size_t{1});
    }
    void a_recording_that_cannot_be_made_holds_nothing_up() {
        Bench bench;
        bench.open();
        bench.folder.write("album/a.jpg.tags", "a file in the place of the folder");
        bench.take.start();
        bench.after("one");
        CARE_TRY_COMPARE(bench.done, QStringList{"one"});
    }
    void what_may_not_happen_meanwhile_is_refused_and_that_is_said() {
        Bench bench;
        bench.open();
        QVERIFY(!bench.recording.refused());
        QVERIFY(bench.voice.said().isEmpty());
        bench.begin_take();
        QVERIFY(bench.recording.refused());
        QCOMPARE(bench.last_said(), QString("A recording is being made. Finish it first."));
        QVERIFY(bench.take.running());
        QVERIFY(bench.recording.stop());
        CARE_TRY_VERIFY(!bench.take.running());
        QVERIFY(!bench.recording.refused());
        QVERIFY(bench.rests());
    }
    void what_plays_ends_when_it_is_stopped_and_when_the_microphone_listens() {
        Bench bench;
        bench.add_sound("a.jpg", 2.0, 300.0);
        bench.open();
        const auto play = [&bench] {
            const Tag& tag = *bench.recordings.chosen_tag();
            bench.listening.play(tags_folder(bench.photo("a.jpg")) / tag.file, tag);
        };
        play();
        QVERIFY(bench.recording.stop());
        QVERIFY(!bench.listening.playing());
        QVERIFY(!bench.recording.stop());
        play();
        bench.take.start();
        QVERIFY(!bench.listening.playing());
        QVERIFY(bench.recording.stop());
        CARE_TRY_VERIFY(!bench.take.running());
        QVERIFY(bench.rests());
    }
};

} // namespace recording_wait_test

TP_TEST(recording_wait_test, RecordingWaitTest, window)
#include "recording_wait_test.moc"
