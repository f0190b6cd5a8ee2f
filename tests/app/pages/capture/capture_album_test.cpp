// SPDX-License-Identifier: Apache-2.0
// Steps on the album's folder: one after the other beside the page, answered on its thread, taken back one by one.
#include "app/album/metadata/read_record.hpp"
#include "app/pages/capture/capture_album.hpp"
#include "test_program.hpp"

#include <QDir>
#include <QImage>
#include <QSignalSpy>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include <filesystem>
#include <memory>
#include <new>
#include <string>

namespace capture_album_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

struct Bench {
    QTemporaryDir folder;
    QString name = "one"; ///< of the album that is open
    std::unique_ptr<CaptureAlbum> album = std::make_unique<CaptureAlbum>([this] { return path(name); });
    QStringList answers;

    Bench() {
        for (const char* other : {"one", "other"}) {
            QDir().mkpath(folder.filePath(other));
            QImage(8, 6, QImage::Format_RGB32).save(folder.filePath(other) + "/a.jpg");
        }
    }
    fs::path path(const QString& of) const {
        return fs::canonical(folder.path().toStdString()) / of.toStdString();
    }
    fs::path photo() const { return path(name) / "a.jpg"; }
    /// Describes the photograph of the album that is open now.
    void describe(const std::string& words) {
        album->run(
            [photo = photo(), words](AlbumKeeper& keeper, PhotographStore&) {
                return keeper.describe(photo, "en", words, "");
            },
            [this](const QString& problem) { answers << problem; });
    }
    std::string description() const {
        auto record = read_record(photo());
        return record ? record->alt_text["en"] : record.error();
    }
};

} // namespace

class CaptureAlbumTest : public QObject {
    Q_OBJECT
private slots:
    void steps_are_done_in_their_order_and_answered_on_the_thread_that_asked() {
        Bench bench;
        QStringList done;
        bool beside = false, here = false;
        for (const char* step : {"first", "second", "third"})
            bench.album->run(
                [&, step](AlbumKeeper&, PhotographStore&) {
                    done << step;
                    beside = QThread::currentThread() != bench.album->thread();
                    return std::string(step) == "second" ? std::string("It cannot be done.") : std::string();
                },
                [&](const QString& problem) {
                    bench.answers << problem;
                    here = QThread::currentThread() == bench.album->thread();
                });
        QTRY_COMPARE_WITH_TIMEOUT(bench.answers, QStringList({"", "It cannot be done.", ""}), 60000);
        QCOMPARE(done, QStringList({"first", "second", "third"}));
        QVERIFY(beside && here);
    }

    void each_step_can_be_taken_back_and_what_it_was_is_told() {
        Bench bench;
        const QSignalSpy changed(bench.album.get(), &CaptureAlbum::changed);
        QCOMPARE(bench.album->steps(), std::size_t(0));
        bench.describe("A first try.");
        bench.describe("A face.");
        QTRY_COMPARE_WITH_TIMEOUT(bench.answers, QStringList({"", ""}), 60000);
        QCOMPARE(bench.album->steps(), std::size_t(2));
        QCOMPARE(bench.description(), std::string("A face."));
        QString told;
        const auto tell = [&](const QString& what, const QString& problem) {
            told = problem.isEmpty() ? what : problem;
        };
        bench.album->undo(tell);
        QTRY_VERIFY_WITH_TIMEOUT(told.contains("was described"), 60000);
        QCOMPARE(bench.album->steps(), std::size_t(1));
        QCOMPARE(bench.description(), std::string("A first try."));
        QCOMPARE(changed.size(), 3);
    }

    void another_folder_has_steps_of_its_own() {
        Bench bench;
        bench.describe("In the first album.");
        bench.name = "other";
        bench.describe("In the other one.");
        QTRY_COMPARE_WITH_TIMEOUT(bench.answers, QStringList({"", ""}), 60000);
        QCOMPARE(bench.album->steps(), std::size_t(1));
        QCOMPARE(bench.description(), std::string("In the other one."));
    }

    void what_a_step_throws_is_a_sentence_and_the_next_one_is_done() {
        Bench bench;
        bench.album->run([](AlbumKeeper&, PhotographStore&) -> std::string { throw std::bad_alloc(); },
                         [&](const QString& problem) { bench.answers << problem; });
        bench.describe("A face.");
        QTRY_COMPARE_WITH_TIMEOUT(bench.answers.size(), 2, 60000);
        QVERIFY2(bench.answers[0].startsWith("This could not be done, because the computer reports: "),
                 qPrintable(bench.answers[0]));
        QCOMPARE(bench.answers[1], QString());
    }

    void what_was_asked_for_is_on_the_disk_although_the_page_ends() {
        Bench bench;
        bench.describe("A face.");
        bench.album.reset();
        QCOMPARE(bench.description(), std::string("A face."));
    }
};

} // namespace capture_album_test

TP_TEST(capture_album_test, CaptureAlbumTest, event_loop)
#include "capture_album_test.moc"
