// SPDX-License-Identifier: Apache-2.0
#include "album_parts.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "app/album/open/open_album.hpp"

#include <QSignalSpy>
#include <QTest>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

using namespace tp;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

/// Folders that a person may choose, and the album that is open while the program runs.
struct Program {
    AlbumFolder folder;
    Preferences preferences;
    QStringList said;
    int changes = 0;
    std::unique_ptr<OpenAlbum> album;

    fs::path root() const { return fs::canonical(folder.path()); }
    fs::path photo(const std::string& name, int number) const {
        return root() / a_photo(folder, name, number).lexically_relative(folder.path());
    }
    void choose(const std::vector<fs::path>& folders) {
        preferences.change([&](Choices& choices) {
            choices.folders.clear();
            for (const fs::path& one : folders)
                choices.folders << QString::fromStdString(one.string());
        });
    }
    /// As at a start of the program; other programs' changes are noticed at once.
    void start(AlbumWatcher::Times times = {0ms, 1h}) {
        album = std::make_unique<OpenAlbum>(folder / "cache", preferences, times);
        QObject::connect(album.get(), &OpenAlbum::said, album.get(),
                         [this](const QString& sentence) { said << sentence; });
        QObject::connect(album.get(), &OpenAlbum::album_changed, album.get(), [this] { ++changes; });
    }
    std::vector<fs::path> photos() const {
        std::vector<fs::path> paths;
        const auto page = album->queries().page(AllByName{}, {}, 100);
        for (const PhotoEntry& entry : page.value())
            paths.push_back(entry.path);
        return paths;
    }
    bool knows(const std::vector<fs::path>& expected) const {
        return QTest::qWaitFor([&] { return !album->scanning() && photos() == expected; }, 30'000);
    }
    bool rests() const {
        return QTest::qWaitFor([&] { return !album->scanning(); }, 30'000);
    }
};

void name_somebody(const fs::path& photo, const std::string& name) {
    SidecarChanges changes;
    changes.persons = {name};
    QCOMPARE(write_sidecar(photo, changes), std::string());
}

} // namespace

class OpenAlbumTest : public QObject {
    Q_OBJECT
private slots:
    void without_folders_there_is_an_empty_album_and_no_complaint() {
        Program program;
        program.start();
        QVERIFY(!program.album->has_folders());
        QVERIFY(program.rests());
        QCOMPARE(program.album->index().totals()->photos, std::size_t{0});
        QCOMPARE(program.said, QStringList());
    }

    void chosen_folders_are_scanned_and_others_leave_the_album() {
        Program program;
        const fs::path anna = program.photo("anna/1.jpg", 1), ben = program.photo("ben/2.jpg", 2);
        program.start();
        QVERIFY(program.rests());
        QSignalSpy folders(program.album.get(), &OpenAlbum::folders_changed);
        program.choose({program.folder / "anna"});
        QVERIFY(program.album->has_folders());
        QVERIFY(program.album->scanning());
        QVERIFY(program.knows({anna}));
        QVERIFY(program.changes > 0);
        program.choose({program.folder / "anna", program.folder / "ben"});
        QVERIFY(program.knows({anna, ben}));
        program.choose({program.folder / "ben"});
        QVERIFY(program.knows({ben}));
        QCOMPARE(folders.count(), 3);
        program.preferences.change([](Choices& choices) { choices.motion = false; });
        QVERIFY(!program.album->scanning());
        QCOMPARE(folders.count(), 3);
    }

    void the_next_start_knows_the_album_before_it_has_looked() {
        Program program;
        const fs::path photo = program.photo("album/1.jpg", 1);
        program.choose({program.folder / "album"});
        program.start();
        QVERIFY(program.knows({photo}));
        program.start();
        QCOMPARE(program.photos(), std::vector<fs::path>{photo});
        QVERIFY(program.rests());
    }

    void progress_ends_with_all_that_was_new() {
        Program program;
        for (int i = 0; i < 12; ++i)
            program.photo("album/" + std::to_string(10 + i) + ".jpg", i);
        program.choose({program.folder / "album"});
        program.start();
        int done = 0, total = 0;
        connect(program.album.get(), &OpenAlbum::progress_changed, this, [&] {
            done = std::max(done, program.album->done());
            total = std::max(total, program.album->total());
            QVERIFY(program.album->done() <= program.album->total());
        });
        QVERIFY(program.rests());
        QCOMPARE(done, 12);
        QCOMPARE(total, 12);
        QCOMPARE(program.photos().size(), std::size_t{12});
    }

    void what_a_page_changed_is_known_soon() {
        Program program;
        const fs::path photo = program.photo("album/1.jpg", 1);
        program.choose({program.folder / "album"});
        program.start({1h, 1h}); // the watcher tells nothing
        QVERIFY(program.knows({photo}));
        const PhotoId id = program.album->queries().find(photo).value()->id;
        QCOMPARE(program.album->keeper_for(photo).name_face(photo, {0.5, 0.5, 0.2, 0.3, "Anna"}),
                 std::string());
        program.album->touched(photo);
        QTRY_COMPARE(program.album->queries().summary(id).value()->record.persons,
                     std::vector<std::string>{"Anna"});
        QVERIFY(program.rests());
    }

    void what_a_page_changes_during_a_scan_is_known_as_well() {
        Program program;
        std::vector<fs::path> all;
        for (int i = 0; i < 60; ++i)
            all.push_back(program.photo("album/" + std::to_string(100 + i) + ".jpg", i));
        program.choose({program.folder / "album"});
        program.start({1h, 1h});
        name_somebody(all[59], "Tom");
        program.album->touched(all[59]);
        QVERIFY(program.knows(all));
        const auto toms = program.album->queries().page(OfTopic{"person", "Tom"}, {}, 10);
        QCOMPARE(toms->size(), std::size_t{1});
    }

    void what_other_programs_change_is_noticed() {
        Program program;
        const fs::path first = program.photo("album/1.jpg", 1);
        program.choose({program.folder / "album"});
        program.start();
        QVERIFY(program.knows({first}));
        const fs::path second = program.photo("album/new/2.jpg", 2);
        QVERIFY(program.knows({first, second}));
        fs::remove(first);
        QVERIFY(program.knows({second}));
    }

    void what_belongs_to_a_moved_photograph_goes_along() {
        Program program;
        const fs::path photo = program.photo("album/1.jpg", 1);
        name_somebody(photo, "Anna");
        program.choose({program.folder / "album"});
        program.start();
        QVERIFY(program.knows({photo}));
        const fs::path there = program.root() / "album/Anna.jpg";
        fs::rename(photo, there);
        QVERIFY(program.knows({there}));
        const auto annas = [&] {
            return program.album->queries().page(OfTopic{"person", "Anna"}, {}, 10)->size();
        };
        QTRY_COMPARE(annas(), std::size_t{1});
        QCOMPARE(read_record(there)->persons, std::vector<std::string>{"Anna"});
        QVERIFY(!fs::exists(photo.string() + ".xmp"));
    }

    void a_move_while_the_program_was_closed_is_followed_even_after_a_kill() {
        Program program;
        const fs::path photo = program.photo("album/1.jpg", 1);
        name_somebody(photo, "Anna");
        program.choose({program.folder / "album"});
        program.start();
        QVERIFY(program.knows({photo}));
        program.album.reset();
        const fs::path there = program.root() / "album/Anna.jpg";
        fs::rename(photo, there);
        { // the scan was done, what comes after it not
            auto index = AlbumIndex::open(program.folder / "cache");
            ScanTools tools;
            tools.read_record = read_record;
            QCOMPARE(scan_album(*index, {program.folder / "album"}, tools)->moves.size(), std::size_t{1});
        }
        program.start();
        QVERIFY(program.rests());
        QVERIFY(fs::exists(there.string() + ".xmp"));
        QCOMPARE(program.album->queries().page(OfTopic{"person", "Anna"}, {}, 10)->size(), std::size_t{1});
    }

    void a_folder_that_is_not_there_costs_one_sentence() {
        Program program;
        const fs::path photo = program.photo("album/1.jpg", 1);
        program.choose({program.folder / "album", program.folder / "stick"});
        program.start();
        QVERIFY(program.knows({photo}));
        QTRY_COMPARE(program.said.size(), 1);
        QVERIFY2(program.said[0].contains("stick") && program.said[0].endsWith("is missing."),
                 qPrintable(program.said[0]));
        program.album->rescan();
        QVERIFY(program.rests());
        QCOMPARE(program.said.size(), 1);
    }

    void a_joystick_is_noticed_when_it_comes_and_keeps_its_place_when_it_goes() {
        Program program;
        const fs::path photo = program.photo("stick/1.jpg", 1), put_away = program.root() / "put away";
        fs::rename(program.root() / "stick", put_away);
        program.choose({program.folder / "stick"});
        program.start();
        QVERIFY(program.knows({}));
        fs::rename(put_away, program.root() / "stick");
        QVERIFY(program.knows({photo}));
        fs::rename(program.root() / "stick", put_away);
        QTRY_COMPARE(program.said.size(), 1);
        QVERIFY(program.knows({photo}));
        fs::rename(put_away, program.root() / "stick");
        const fs::path second = program.photo("stick/2.jpg", 2);
        QVERIFY(program.knows({photo, second}));
        QCOMPARE(program.said.size(), 1);
    }

    void a_folder_that_may_not_be_opened_costs_a_sentence() {
        if (::geteuid() == 0)
            QSKIP("the superuser may open every folder");
        Program program;
        const fs::path photo = program.photo("album/1.jpg", 1);
        fs::permissions(program.root() / "album", fs::perms::none);
        program.choose({program.folder / "album"});
        program.start();
        QVERIFY(program.rests());
        fs::permissions(program.root() / "album", fs::perms::owner_all);
        QCOMPARE(program.said.size(), 1);
        QVERIFY(program.said[0].contains("you are not allowed to"));
    }

    void many_problems_are_not_read_out_one_by_one() {
        Program program;
        for (int i = 0; i < 8; ++i)
            program.folder.write("album/" + std::to_string(i) + ".jpg", "no photograph");
        program.choose({program.folder / "album"});
        program.start();
        QVERIFY(program.rests());
        QTRY_COMPARE(program.said.size(), 4);
        QVERIFY2(program.said[3].startsWith("5 more"), qPrintable(program.said[3]));
    }

    void an_index_that_cannot_be_kept_is_told_and_the_album_works() {
        Program program;
        const fs::path photo = program.photo("album/1.jpg", 1);
        program.folder.write("cache", "a file in the way");
        program.choose({program.folder / "album"});
        program.start();
        QVERIFY(program.knows({photo}));
        QCOMPARE(program.said.size(), 1);
        QVERIFY(program.said[0].contains("held in memory"));
    }

    void every_folder_has_one_keeper_that_takes_back() {
        Program program;
        const fs::path anna = program.photo("album/a/1.jpg", 1), ben = program.photo("album/b/2.jpg", 2),
                       other = program.photo("other/3.jpg", 3);
        program.choose({program.folder / "album", program.folder / "album/a", program.folder / "other/"});
        program.start();
        OpenAlbum& album = *program.album;
        QCOMPARE(album.folders(),
                 (std::vector<fs::path>{program.root() / "album", program.root() / "other"}));
        QCOMPARE(&album.keeper_for(anna), &album.keeper_for(ben));
        QVERIFY(&album.keeper_for(anna) != &album.keeper_for(other));
        QCOMPARE(album.folder_of(anna), program.root() / "album");
        QCOMPARE(album.folder_of("/elsewhere/x.jpg"), fs::path("/elsewhere"));
        QCOMPARE(album.keeper_for(anna).describe(anna, "en", "Anna", {}), std::string());
        QVERIFY(read_record(anna)->alt_text.contains("en"));
        QCOMPARE(album.keeper_for(ben).history().undo(), std::string());
        QVERIFY(!read_record(anna)->alt_text.contains("en"));
    }

    void it_can_end_in_the_middle_of_a_scan() {
        Program program;
        for (int i = 0; i < 300; ++i)
            program.photo("album/" + std::to_string(1000 + i) + ".jpg", i);
        program.choose({program.folder / "album"});
        program.start();
        QTRY_VERIFY(program.album->total() > 0);
        program.album.reset();
        program.start();
        QVERIFY(program.rests());
        QCOMPARE(program.album->index().totals()->photos, std::size_t{300});
    }
};

QTEST_GUILESS_MAIN(OpenAlbumTest)
#include "open_album_test.moc"
