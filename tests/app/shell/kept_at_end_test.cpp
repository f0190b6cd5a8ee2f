// SPDX-License-Identifier: Apache-2.0
// The program ends while something is being recorded: it is in the album when the program is started again.
#include "app/album/metadata/read_record.hpp"
#include "full_disk.hpp"
#include "sound_files.hpp"
#include "whole_program.hpp"

#include <QTest>

#include <memory>
#include <optional>

using namespace tp;
namespace fs = std::filesystem;

namespace {

constexpr int patience_ms = 60'000; ///< for a busy machine

enum class End { window, program };

void hear(const WholeProgram& whole, double seconds) {
    QTRY_VERIFY_WITH_TIMEOUT(whole.microphone.load() != nullptr, patience_ms);
    testing::FakeMicrophone* const made = whole.microphone;
    bool on = false;
    const auto is_on = [&] {
        QMetaObject::invokeMethod(
            made, [&] { on = made->on(); }, Qt::BlockingQueuedConnection);
        return on;
    };
    QTRY_VERIFY_WITH_TIMEOUT(is_on(), patience_ms);
    QMetaObject::invokeMethod(
        made, [made, seconds] { made->hear(testing::tone(440.0, seconds, sound_rate)); },
        Qt::BlockingQueuedConnection);
}

void end(WholeProgram& whole, End how) {
    if (how == End::window)
        QVERIFY(whole.window->close());
    whole.window.reset();
    whole.program.reset();
}

/// Of the photograph's recordings, those that are listed and lie there.
std::size_t recordings_of(const fs::path& photo) {
    const auto record = read_record(photo);
    if (!record)
        return 0;
    std::size_t found = 0;
    for (const Tag& tag : record->tags)
        found += fs::file_size(photo.string() + ".tags/" + tag.file) > 0 && tag.duration_s == 2.0 ? 1 : 0;
    return found;
}

} // namespace

class KeptAtEndTest : public QObject {
    Q_OBJECT
private slots:
    void a_recording_for_a_photograph_is_listed_data() {
        QTest::addColumn<End>("how");
        QTest::addColumn<bool>("asking");
        QTest::newRow("the window is closed") << End::window << false;
        QTest::newRow("the program is ended") << End::program << false;
        QTest::newRow("while it asks whether to discard it") << End::window << true;
    }
    void a_recording_for_a_photograph_is_listed() {
        QFETCH(End, how);
        QFETCH(bool, asking);
        WholeProgram whole;
        QVERIFY(whole.shown());
        const fs::path photo = whole.file("Family/anna_smiling.jpg");
        whole.program->open_page("care");
        CareSession& care = whole.program->care();
        care.open_photo(photo);
        QTRY_VERIFY_WITH_TIMEOUT(!care.keeping(), patience_ms);
        care.take()->start();
        QVERIFY(care.keeping());
        hear(whole, 2.0);
        if (asking)
            care.take()->askDiscard();
        end(whole, how);
        QCOMPARE(recordings_of(photo), std::size_t{1});
    }

    void a_memo_for_a_photograph_that_was_just_taken_is_listed() {
        WholeProgram whole;
        QVERIFY(whole.shown());
        whole.program->open_page("capture");
        CaptureSession& capture = whole.program->capture();
        QTRY_COMPARE_WITH_TIMEOUT(capture.camera()->state(), CaptureCamera::On, patience_ms);
        capture.take();
        QTRY_VERIFY_WITH_TIMEOUT(!capture.shutter()->photo().empty(), patience_ms);
        const fs::path photo = capture.shutter()->photo();
        capture.recordMemo();
        QVERIFY(capture.keeping());
        hear(whole, 2.0);
        end(whole, End::window);
        QCOMPARE(recordings_of(photo), std::size_t{1});
    }

    void a_photograph_that_is_being_kept_is_there() {
        WholeProgram whole;
        QVERIFY(whole.shown());
        whole.program->open_page("capture");
        CaptureSession& capture = whole.program->capture();
        QTRY_COMPARE_WITH_TIMEOUT(capture.camera()->state(), CaptureCamera::On, patience_ms);
        fs::path photo;
        connect(&capture, &CaptureSession::touched, this, [&](const fs::path& touched) { photo = touched; });
        capture.take();
        QVERIFY(capture.keeping());
        end(whole, End::window);
        QVERIFY(fs::file_size(photo) > 0);
    }

    void a_slow_disk_is_waited_for_and_that_is_said() {
        WholeProgram whole;
        QVERIFY(whole.shown());
        const fs::path photo = whole.file("Family/anna_smiling.jpg");
        whole.program->open_page("care");
        CareSession& care = whole.program->care();
        care.open_photo(photo);
        QTRY_VERIFY_WITH_TIMEOUT(!care.keeping(), patience_ms);
        care.take()->start();
        hear(whole, 2.0);
        SlowDisk disk("anna_smiling.jpg.xmp");
        const QString sentence = "Still saving. TouchPhoto closes when everything is saved.";
        int said = 0;
        connect(&whole.shell(), &Shell::told, this, [&] {
            if (whole.shell().sentence() != sentence)
                return;
            ++said;
            QVERIFY(whole.window->isVisible()); // a screen reader reads it there
            disk.let(1);
        });
        end(whole, End::window);
        QCOMPARE(said, 1);
        QCOMPARE(recordings_of(photo), std::size_t{1});
    }

    void nothing_is_waited_for_where_nothing_is_kept() {
        WholeProgram whole;
        QVERIFY(whole.shown());
        for (const char* page : {"care", "capture", "start"})
            whole.program->open_page(page);
        end(whole, End::window);
        QVERIFY(whole.voice.said().filter("Still saving").isEmpty());
    }
};

QTEST_MAIN(KeptAtEndTest)
#include "kept_at_end_test.moc"
