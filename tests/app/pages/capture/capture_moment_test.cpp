// SPDX-License-Identifier: Apache-2.0
// The sound round a photograph: kept only where the person chose it, and only with a photograph.
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/pages/capture/capture_moment.hpp"
#include "capture_ground.hpp"
#include "test_program.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QImage>
#include <QSignalSpy>

#include <filesystem>

namespace capture_moment_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

Choices with(bool moment) {
    Choices choices = CaptureGround::told();
    choices.keep_moment = moment;
    return choices;
}

/// A photograph lies in the album.
struct Bench : CaptureParts {
    CaptureMoment moment{keeping, choices, moment_recorder, teller};
    QSignalSpy touched{&moment, &CaptureMoment::touched};
    fs::path photo;

    explicit Bench(bool wanted = true) : CaptureParts(with(wanted)) {
        QDir().mkpath(album());
        QImage(8, 6, QImage::Format_RGB32).save(album() + "/a.jpg");
        photo = fs::canonical((album() + "/a.jpg").toStdString());
    }
    bool heard() {
        return QTest::qWaitFor([this] { return (hear_moment(0.1), moment.hears()); }, 60000);
    }
    /// The microphone hears, but nobody is there who listens.
    bool deaf() {
        if (moment_microphone.load() == nullptr)
            return true;
        hear_moment(0.5);
        QCoreApplication::processEvents();
        return !moment.hears();
    }
    QStringList sounds() const {
        return QDir(QString::fromStdString(tags_folder(photo).string())).entryList({"*.flac"});
    }
};

} // namespace

class CaptureMomentTest : public QObject {
    Q_OBJECT
private slots:
    void the_microphone_is_on_while_the_camera_is_and_the_person_wants_it() {
        Bench bench(false);
        bench.moment.begin();
        QVERIFY(bench.deaf());
        bench.choices.setMoment(true);
        QVERIFY(bench.heard());
        bench.choices.setMoment(false);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.moment.hears(), 60000);
        QVERIFY(bench.deaf());
        bench.choices.setMoment(true);
        QVERIFY(bench.heard());
        bench.moment.end();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.moment.hears(), 60000);
        QVERIFY(bench.deaf());
        bench.choices.setMoment(false);
        bench.choices.setMoment(true); // the camera is off
        QVERIFY(bench.deaf());
    }

    void what_was_heard_round_the_shutter_becomes_an_ambient_recording() {
        Bench bench;
        bench.moment.begin();
        QVERIFY(bench.heard());
        bench.hear_moment(2.0);
        bench.moment.shutter();
        bench.moment.keep(bench.photo);
        bench.hear_moment(6.0);
        QTRY_COMPARE_WITH_TIMEOUT(bench.touched.size(), 1, 60000);
        QVERIFY(bench.touched.last().at(0).value<fs::path>() == bench.photo);
        const auto record = read_record(bench.photo);
        QVERIFY(record && record->tags.size() == 1);
        QVERIFY(record->tags[0].label.kind == RecordingKind::ambient);
        QVERIFY(record->tags[0].duration_s > 6.0 && record->tags[0].duration_s <= 10.0);
    }

    void of_a_photograph_that_was_not_kept_nothing_is_written() {
        Bench bench;
        bench.moment.begin();
        QVERIFY(bench.heard());
        bench.moment.shutter();
        bench.moment.drop();
        bench.moment.keep(bench.photo); // of no shutter
        bench.hear_moment(6.0);
        bench.moment.end();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.moment.hears(), 60000);
        QVERIFY(bench.touched.isEmpty() && bench.sounds().isEmpty());
    }

    void a_shutter_without_that_choice_keeps_no_sound() {
        Bench bench(false);
        bench.moment.begin();
        bench.moment.shutter();
        bench.choices.setMoment(true);
        QVERIFY(bench.heard());
        bench.moment.keep(bench.photo);
        bench.hear_moment(6.0);
        bench.moment.end();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.moment.hears(), 60000);
        QVERIFY(bench.sounds().isEmpty());
    }

    void a_photograph_that_was_deleted_meanwhile_is_left_alone() {
        Bench bench;
        bench.moment.begin();
        QVERIFY(bench.heard());
        bench.moment.shutter();
        bench.moment.keep(bench.photo);
        fs::remove(bench.photo);
        const QSignalSpy kept(&bench.moment_recorder, &MomentRecorder::kept);
        const QSignalSpy changed(&bench.keeping, &CaptureAlbum::changed);
        bench.voice.clear();
        bench.hear_moment(6.0);
        QTRY_COMPARE_WITH_TIMEOUT(kept.size(), 1, 60000);
        QTRY_COMPARE_WITH_TIMEOUT(changed.size(), 1, 60000); // the step is over
        QVERIFY2(bench.voice.said().isEmpty(), qPrintable(bench.last_said()));
        QVERIFY(!fs::exists(bench.photo));
    }
};

} // namespace capture_moment_test

TP_TEST(capture_moment_test, CaptureMomentTest, window)
#include "capture_moment_test.moc"
