// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/import_list.hpp"
#include "app/pages/care/import_care.hpp"
#include "care_bench.hpp"
#include "core/files/durable_file.hpp"
#include "full_disk.hpp"

#include <QSignalSpy>

#include <atomic>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

using namespace tp;
namespace fs = std::filesystem;

namespace {

std::atomic<int> passed_s = 0; ///< of the steady clock, beyond what passed

struct Bench : CareGround {
    CareTeller teller{narrator, earcons};
    std::unique_ptr<ImportCare> import = std::make_unique<ImportCare>(*album, preferences, teller);
    using CareGround::CareGround;

    /// A camera's card with photographs IMG_0.jpg, IMG_1.jpg, … of one size.
    QUrl card(int photos) {
        fs::create_directories(folder / "card");
        for (int i = 0; i < photos; ++i)
            a_photo(folder, "card/IMG_" + std::to_string(i) + ".jpg", 100 + i);
        return url(folder / "card");
    }
    bool ends() {
        return QTest::qWaitFor([this] { return !import->running(); }, 60'000);
    }
    /// The program begins anew.
    void start() {
        import.reset();
        import = std::make_unique<ImportCare>(*album, preferences, teller);
    }
    std::string problem() const { return import->problems().join('\n').toStdString(); }
};

} // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* now) noexcept {
    const auto done = static_cast<int>(::syscall(SYS_clock_gettime, clock, now));
    if (clock == CLOCK_MONOTONIC)
        now->tv_sec += passed_s;
    return done;
}

class ImportCareTest : public QObject {
    Q_OBJECT
private slots:
    void photographs_come_and_it_is_told_what_was_there_and_what_failed() {
        Bench bench;
        a_photo(bench.folder, "card/new.jpg", 7);
        a_photo(bench.folder, "card/again.jpg", 1); // the bytes of a.jpg
        fs::create_symlink("/nowhere/at/all", bench.folder / "card/broken.jpg");
        bench.import->import({url(bench.folder / "card"), url(bench.folder / "card/broken.jpg")});
        QVERIFY(bench.import->running());
        QCOMPARE(bench.last_said(), QString("Importing…"));
        QVERIFY(bench.ends());
        QVERIFY2(bench.import->report().startsWith(
                     "1 photograph(s) imported, 1 of them already in the album, 1 failed: "),
                 qPrintable(bench.import->report()));
        QCOMPARE(bench.last_said(), bench.import->report());
        QVERIFY(bench.sounded(Earcon::error));
        QCOMPARE(bench.import->problems().size(), 1);
        QVERIFY(bench.import->problems().at(0).contains("broken.jpg"));
        QVERIFY(fs::exists(bench.photo("new.jpg")) && !fs::exists(bench.photo("again.jpg")));
        CARE_TRY_COMPARE(bench.album->index().totals()->photos, 2U);
        bench.import->import({url(bench.folder / "card/new.jpg")});
        QVERIFY(bench.import->report().isEmpty() && bench.import->problems().isEmpty()); // of the one before
        QVERIFY(bench.ends());
        QVERIFY(bench.sounded(Earcon::saved));
    }
    void how_far_it_is_is_shown_and_what_may_not_be_done_meanwhile_is_refused() {
        Bench bench;
        fs::create_directories(bench.folder / "second");
        bench.import->chooseFolder(url(bench.folder / "second"));
        const QUrl card = bench.card(4);
        QSignalSpy progressed(bench.import.get(), &ImportCare::progressed),
            changed(bench.import.get(), &ImportCare::changed);
        SlowDisk disk("album/IMG_");
        bench.import->import({card});
        QCOMPARE(bench.import->progressText(), QString("Looking for photographs…"));
        QCOMPARE(bench.import->fraction(), 0.0);
        QCOMPARE(changed.size(), 1);
        QCOMPARE(progressed.size(), 1);
        CARE_TRY_VERIFY(disk.waits());
        disk.let(1);
        CARE_TRY_COMPARE(bench.import->fraction(), 0.25);
        QVERIFY2(bench.import->progressText().startsWith("1 of 4 photographs, "),
                 qPrintable(bench.import->progressText()));
        QVERIFY(!bench.import->unfinished()); // it runs
        bench.import->setFolder(1);
        QCOMPARE(bench.import->folder(), 0);
        bench.import->look();
        QVERIFY(!bench.import->unfinished());
        bench.import->goOn();
        bench.import->giveUp();
        bench.import->import({card});
        QCOMPARE(bench.last_said(), QString("An import is running. Wait until it ends, or stop it first."));
        QVERIFY(bench.sounded(Earcon::error));
        QCOMPARE(changed.size(), 1);
        disk.let(10);
        QVERIFY(bench.ends());
        QCOMPARE(bench.import->fraction(), 1.0);
        QVERIFY(changed.size() > 1);
        QCOMPARE(bench.import->report(), QString("4 photograph(s) imported."));
    }
    void a_word_now_and_then_says_that_it_goes_on() {
        Bench bench;
        SlowDisk disk("album/IMG_");
        bench.import->import({bench.card(4)});
        disk.let(1);
        CARE_TRY_COMPARE(bench.import->fraction(), 0.25);
        QCOMPARE(bench.last_said(), QString("Importing…")); // said a moment ago
        CARE_TRY_VERIFY(disk.waits());
        passed_s = 5;
        disk.let(1);
        CARE_TRY_COMPARE(bench.import->fraction(), 0.5);
        passed_s = 0;
        QVERIFY2(bench.last_said().startsWith("2 of 4 photographs, "), qPrintable(bench.last_said()));
        disk.let(10);
        QVERIFY(bench.ends());
    }
    void one_that_is_stopped_in_the_middle_goes_on_after_a_start_of_the_program() {
        Bench bench;
        {
            SlowDisk disk("album/IMG_");
            bench.import->stop();
            bench.import->import({bench.card(5)});
            QCOMPARE(bench.last_said(), QString("Importing…")); // there was none to stop
            disk.let(2);
            CARE_TRY_COMPARE(bench.import->fraction(), 0.4);
            CARE_TRY_VERIFY(disk.waits());
            bench.import->stop();
            QCOMPARE(bench.last_said(), QString("Stopping after this photograph."));
            QVERIFY(bench.import->running());
        }
        QVERIFY(bench.ends());
        QVERIFY(bench.import->unfinished());
        QCOMPARE(bench.import->report(),
                 QString("3 photograph(s) imported. The import was stopped; you can continue it later."));
        QVERIFY(bench.sounded(Earcon::saved));
        bench.start();
        QVERIFY(bench.import->unfinished());
        const QString from = QString::fromStdString((bench.folder / "card").string());
        QVERIFY2(bench.import->unfinishedText().startsWith("From " + from),
                 qPrintable(bench.import->unfinishedText()));
        bench.import->goOn();
        QVERIFY2(bench.voice.said().filter("The import continues. From " + from).size() == 1,
                 qPrintable(bench.voice.said().join("|")));
        QVERIFY(bench.ends());
        QVERIFY(!bench.import->unfinished());
        QCOMPARE(bench.import->report(),
                 QString("2 photograph(s) imported, 3 of them already in the album."));
        bench.import->goOn();
        QVERIFY(!bench.import->running());
    }
    void the_end_of_the_program_stops_it_and_the_rest_comes_another_time() {
        Bench bench;
        {
            SlowDisk disk("album/IMG_");
            bench.import->import({bench.card(50)});
            CARE_TRY_VERIFY(disk.waits());
            const std::jthread one_by_one([&disk](const std::stop_token& stop) {
                for (; !stop.stop_requested(); std::this_thread::sleep_for(std::chrono::milliseconds(100)))
                    disk.let(1);
            });
            bench.import.reset(); // it waits for the photograph that is being copied
        }
        QVERIFY(!fs::exists(bench.photo("IMG_49.jpg")));
        bench.start();
        QVERIFY(bench.import->unfinished());
    }
    void one_that_is_given_up_keeps_what_it_brought() {
        Bench bench;
        {
            SlowDisk disk("album/IMG_0.jpg");
            bench.import->import({bench.card(2)});
            CARE_TRY_VERIFY(disk.waits());
            bench.import->stop();
        }
        QVERIFY(bench.ends());
        QSignalSpy changed(bench.import.get(), &ImportCare::changed);
        bench.import->giveUp();
        QVERIFY(!bench.import->unfinished());
        QCOMPARE(changed.size(), 1);
        QCOMPARE(bench.last_said(), QString("The import is discarded. What was imported stays."));
        QVERIFY(fs::exists(bench.photo("IMG_0.jpg")) && !fs::exists(bench.photo("IMG_1.jpg")));
        bench.start();
        QVERIFY(!bench.import->unfinished());
        bench.voice.clear();
        bench.import->giveUp();
        QVERIFY(bench.voice.said().isEmpty());
    }
    void what_came_is_in_the_album_though_nobody_watches_its_folders() {
        Bench bench;
        using namespace std::chrono_literals;
        OpenAlbum unwatched(bench.folder / "unwatched", bench.preferences, AlbumWatcher::Times{1h, 1h});
        CARE_TRY_VERIFY(!unwatched.scanning());
        ImportCare import(unwatched, bench.preferences, bench.teller);
        import.import({bench.card(1)});
        CARE_TRY_COMPARE(unwatched.index().totals()->photos, 2U);
        QVERIFY(!import.running());
    }
    /// It may be a stranger's wish.
    void a_list_that_lies_in_the_album_is_not_offered() {
        Bench bench;
        a_photo(bench.folder, "private/private.jpg", 9);
        bench.folder.write("album/.touchphoto/import/2026-05-01T101500.000.json",
                           R"({"into":"","sources":[")" + (bench.folder / "private").string() + R"("]})");
        bench.import->look();
        QVERIFY(!bench.import->unfinished());
        QCOMPARE(bench.import->unfinishedText(), QString());
        bench.import->goOn();
        QVERIFY(!bench.import->running() && !fs::exists(bench.photo("private.jpg")));
    }
    void one_whose_list_is_gone_neither_goes_on_nor_can_be_given_up_and_that_is_said() {
        for (const auto ask : {&ImportCare::goOn, &ImportCare::giveUp}) {
            Bench bench;
            const fs::path list = ImportList::place_of(bench.root(), "2026-05-01T101500.000");
            QCOMPARE(make_folder(list.parent_path()), std::string());
            QCOMPARE(replace_file(list, "{}"), std::string());
            bench.import->look();
            QVERIFY(bench.import->unfinished());
            fs::remove_all(list.parent_path());
            (bench.import.get()->*ask)();
            QVERIFY(bench.ends());
            QVERIFY2(bench.last_said().startsWith("There is no unfinished import "),
                     qPrintable(bench.last_said()));
            QVERIFY(bench.sounded(Earcon::error));
            QVERIFY(!bench.import->unfinished());
        }
    }

    // --- what fails ---

    void on_a_full_disk_the_others_come_and_the_rest_goes_on_when_there_is_room() {
        Bench bench;
        {
            const FullDisk disk("album/IMG_1.jpg");
            bench.import->import({bench.card(3)});
            QVERIFY(bench.ends());
        }
        QVERIFY2(bench.import->report().startsWith("2 photograph(s) imported, 1 failed: "),
                 qPrintable(bench.import->report()));
        QVERIFY2(bench.problem().ends_with("the disk is full."), bench.problem().c_str());
        QVERIFY(bench.sounded(Earcon::error));
        QVERIFY(bench.import->unfinished());
        bench.import->goOn();
        QVERIFY(bench.ends());
        QVERIFY(fs::exists(bench.photo("IMG_1.jpg")));
        QVERIFY(!bench.import->unfinished() && bench.import->problems().isEmpty());
    }
    void where_nothing_can_be_begun_the_sentence_is_the_report() {
        Bench bench;
        const QUrl card = bench.card(1);
        const FullDisk disk("/imports/");
        QSignalSpy progressed(bench.import.get(), &ImportCare::progressed);
        bench.import->import({card});
        QVERIFY(bench.ends());
        QCOMPARE(progressed.size(), 2); // it looks for photographs, and no more
        QVERIFY2(bench.import->report().contains("the disk is full."), qPrintable(bench.import->report()));
        QCOMPARE(bench.last_said(), bench.import->report());
        QVERIFY(bench.sounded(Earcon::error));
        QVERIFY(bench.import->problems().isEmpty() && !bench.import->unfinished());
    }
    void what_is_not_on_this_computer_is_not_imported() {
        Bench bench;
        bench.import->import({QUrl("https://example.org/a.jpg")});
        QVERIFY(!bench.import->running());
        QCOMPARE(bench.last_said(),
                 QString("Only photographs and folders on this computer can be imported."));
        QVERIFY(bench.sounded(Earcon::error));
        bench.import->import({QUrl("https://example.org/a.jpg"), url("/nowhere/at/all.jpg")});
        QVERIFY(bench.ends());
        QVERIFY(bench.import->report().contains("/nowhere/at/all.jpg"));
    }

    // --- where to ---

    void without_a_folder_one_is_asked_for_and_the_import_follows() {
        Bench bench({}, false);
        const QUrl card = bench.card(1);
        QSignalSpy wanted(bench.import.get(), &ImportCare::folderWanted),
            folders(bench.import.get(), &ImportCare::foldersChanged);
        QVERIFY(bench.import->folders().isEmpty());
        bench.import->import({card});
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(bench.last_said(),
                 QString("Choose the folder to keep the album in. The photographs are copied into it."));
        bench.import->chooseFolder(url(bench.folder / "nowhere"));
        QCOMPARE(bench.last_said(), QString("The album needs a folder on this computer."));
        bench.import->chooseFolder(QUrl("https://example.org/"));
        QVERIFY(!bench.import->running() && folders.isEmpty());
        bench.import->chooseFolder(url(bench.folder / "album"));
        QVERIFY(bench.ends());
        QCOMPARE(bench.import->report(), QString("1 photograph(s) imported."));
        QVERIFY(fs::exists(bench.photo("IMG_0.jpg")));
        QCOMPARE(bench.import->folders(), QStringList{QString::fromStdString(bench.root().string())});
        QCOMPARE(folders.size(), 1);
    }
    void a_wish_that_was_dropped_is_not_fulfilled_later() {
        Bench bench({}, false);
        bench.import->import({bench.card(1)});
        bench.import->dropWish();
        const QUrl album = url(bench.folder / "album");
        bench.import->chooseFolder(album);
        QVERIFY(!bench.import->running());
        QCOMPARE(bench.last_said(),
                 QString("The folder %1 now belongs to the album.").arg(album.toLocalFile()));
        bench.import->chooseFolder(album);
        QCOMPARE(bench.preferences.choices().folders.size(), 1); // once
    }
    void it_goes_to_the_folder_that_was_chosen_though_others_come_and_go() {
        Bench bench;
        QVERIFY(!bench.import->unfinished());
        const fs::path list = ImportList::place_of(bench.folder / "second", "2026-05-01T101500.000");
        QCOMPARE(make_folder(list.parent_path()), std::string());
        QCOMPARE(replace_file(list, "{}"), std::string());
        for (const char* name : {"second", "third"}) {
            fs::create_directories(bench.folder / name);
            bench.import->chooseFolder(url(bench.folder / name));
        }
        QSignalSpy folders(bench.import.get(), &ImportCare::foldersChanged);
        for (const int same_or_none : {0, -1, 3})
            bench.import->setFolder(same_or_none);
        QVERIFY(folders.isEmpty());
        bench.import->setFolder(1);
        QCOMPARE(folders.size(), 1);
        QVERIFY(bench.import->unfinished()); // that folder's
        const auto leave_out = [&bench](int folder) {
            bench.preferences.change([folder](Choices& choices) { choices.folders.removeAt(folder); });
        };
        leave_out(0);
        QCOMPARE(bench.import->folder(), 0);
        bench.import->import({bench.card(1)});
        QVERIFY(bench.ends());
        QVERIFY(fs::exists(bench.folder / "second/IMG_0.jpg"));
        leave_out(0);
        QCOMPARE(bench.import->folders().size(), 1);
        QVERIFY(!bench.import->unfinished());
        bench.import->import({bench.card(2)});
        QVERIFY(bench.ends());
        QVERIFY(fs::exists(bench.folder / "third/IMG_1.jpg"));
        QCOMPARE(folders.size(), 3);
    }
};

QTEST_MAIN(ImportCareTest)
#include "import_care_test.moc"
