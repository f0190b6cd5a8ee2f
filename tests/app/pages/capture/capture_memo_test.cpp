// SPDX-License-Identifier: Apache-2.0
// A memo spoken for a photograph: heard, kept in its place, told; and what goes wrong with it.
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "capture_ground.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QImage>
#include <QLocale>
#include <QSignalSpy>

namespace capture_memo_test {

using namespace tp;

namespace {

/// A photograph lies in the album.
struct Bench : CaptureParts {
    std::filesystem::path photo;

    Bench() {
        QDir().mkpath(album());
        const QString file = album() + "/a.jpg";
        QImage(8, 6, QImage::Format_RGB32).save(file);
        photo = std::filesystem::canonical(file.toStdString());
    }
    QStringList sounds() const {
        return QDir(QString::fromStdString(tags_folder(photo).string())).entryList({"*.flac"});
    }
    void end() { QTRY_VERIFY_WITH_TIMEOUT(!memo.running(), 60000); }
};

} // namespace

class CaptureMemoTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }

    void it_is_kept_with_the_photograph_and_told() {
        Bench bench;
        const QSignalSpy touched(&bench.memo, &CaptureMemo::touched);
        bench.teller.tell("Something that was being said.");
        const int stops = bench.voice.stops();
        bench.memo.start(bench.photo, "de");
        QVERIFY(bench.voice.stops() > stops); // the microphone listens
        QVERIFY(bench.memo.running());
        QVERIFY(!bench.sounded(Earcon::recording_started)); // not before it hears
        bench.hear(2.0);
        QVERIFY(bench.sounded(Earcon::recording_started));
        bool stopped = false; // it is listened for before the next earcon can come over it
        QObject::connect(
            &bench.memo, &CaptureMemo::changed, &bench.memo,
            [&] { stopped = stopped || bench.sounded(Earcon::recording_stopped); }, Qt::QueuedConnection);
        QVERIFY(bench.memo.finish());
        bench.end();
        QTRY_VERIFY(stopped);
        QTRY_COMPARE_WITH_TIMEOUT(bench.last_said(), QString("Recorded: 2 seconds. Saved."), 60000);
        QVERIFY(bench.sounded(Earcon::saved));
        QCOMPARE(touched.size(), 1);
        const auto record = read_record(bench.photo);
        QVERIFY(record && record->tags.size() == 1);
        QVERIFY(record->tags[0].label.kind == RecordingKind::memo);
        QCOMPARE(record->tags[0].label.language, std::string("de"));
        QCOMPARE(record->tags[0].duration_s, 2.0);
    }

    void who_wants_it_to_end_again_while_it_goes_to_the_disk_has_said_nothing_new() {
        Bench bench;
        QVERIFY(!bench.memo.finish());
        bench.memo.start(bench.photo, "en");
        bench.hear(1.0);
        QVERIFY(bench.memo.finish());
        QVERIFY(!bench.memo.finish());
        QVERIFY(bench.memo.running());
        QVERIFY(bench.sounded(Earcon::recording_started));
        bench.memo.start(bench.photo, "en");
        QCOMPARE(bench.last_said(), QString("The recorder is still busy. Try again in a moment."));
        QVERIFY(bench.sounded(Earcon::error));
        bench.end();
        QTRY_VERIFY_WITH_TIMEOUT(bench.last_said().contains("Saved"), 60000);
        QCOMPARE(bench.sounds().size(), 1);
        QVERIFY(!bench.memo.finish());
    }

    void while_the_recorder_works_for_another_page_none_begins_and_none_is_told() {
        Bench bench;
        const QSignalSpy changed(&bench.memo, &CaptureMemo::changed);
        RecordingPlan others;
        others.folder = bench.folder.filePath("others").toStdString();
        bench.recorder.start(others);
        bench.hear(1.0);
        bench.memo.start(bench.photo, "en");
        QCOMPARE(bench.last_said(), QString("The recorder is still busy. Try again in a moment."));
        bench.voice.clear();
        const QSignalSpy done(&bench.recorder, &Recorder::done);
        bench.recorder.finish();
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, 60000);
        QVERIFY(!bench.memo.running());
        QVERIFY(changed.isEmpty() && bench.voice.said().isEmpty() && bench.sounds().isEmpty());
        QVERIFY(!bench.sounded(Earcon::recording_stopped));
    }

    void where_nothing_can_be_written_it_is_told_and_another_may_follow() {
        Bench bench;
        const QString in_the_way = QString::fromStdString(tags_folder(bench.photo).string());
        QVERIFY(QFile(in_the_way).open(QIODevice::WriteOnly));
        bench.memo.start(bench.photo, "en");
        bench.end();
        QVERIFY2(bench.last_said().startsWith("The recording cannot be made: "),
                 qPrintable(bench.last_said()));
        QVERIFY(QFile::remove(in_the_way));
        QTRY_VERIFY_WITH_TIMEOUT(bench.recorder.state() == RecorderState::idle, 60000);
        bench.memo.start(bench.photo, "en");
        bench.hear(1.0);
        bench.memo.finish();
        QTRY_VERIFY_WITH_TIMEOUT(bench.last_said().contains("Saved"), 60000);
    }

    void a_microphone_that_goes_is_told_and_what_it_heard_is_kept() {
        Bench bench;
        bench.memo.start(bench.photo, "en");
        bench.hear(1.0);
        bench.voice.clear();
        testing::FakeMicrophone* const made = bench.microphone;
        QMetaObject::invokeMethod(
            made, [made] { made->vanish(); }, Qt::BlockingQueuedConnection);
        QTRY_VERIFY_WITH_TIMEOUT(bench.last_said().contains("microphone"), 60000);
        QVERIFY(bench.memo.finish());
        QTRY_VERIFY_WITH_TIMEOUT(bench.last_said().contains("Saved"), 60000);
        QCOMPARE(bench.sounds().size(), 1);
    }
};

} // namespace capture_memo_test

TP_TEST(capture_memo_test, CaptureMemoTest, window)
#include "capture_memo_test.moc"
