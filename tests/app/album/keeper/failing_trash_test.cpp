// SPDX-License-Identifier: Apache-2.0
// What becomes of what is deleted where the disk refuses in the middle.
#include "album_folder.hpp"
#include "app/album/keeper/trash.hpp"
#include "named_place.hpp"

#include <QTest>

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <string_view>
#include <sys/syscall.h>
#include <unistd.h>

using namespace tp;
namespace fs = std::filesystem;

namespace {

/// What has this in its path is refused; empty: nothing is.
std::string_view not_moved, not_removed, not_made;

bool is_refused(int folder, const char* name, std::string_view part) {
    if (part.empty() || test::named_place(folder, name).find(part) == std::string_view::npos)
        return false;
    errno = ENOSPC;
    return true;
}

} // namespace

extern "C" int renameat2(int old_folder, const char* from, int new_folder, const char* to,
                         unsigned flags) noexcept {
    if (is_refused(old_folder, from, not_moved) || is_refused(new_folder, to, not_moved))
        return -1;
    return static_cast<int>(::syscall(SYS_renameat2, old_folder, from, new_folder, to, flags));
}

extern "C" int unlinkat(int folder, const char* name, int flags) noexcept {
    if (is_refused(folder, name, not_removed))
        return -1;
    return static_cast<int>(::syscall(SYS_unlinkat, folder, name, flags));
}

extern "C" int mkdirat(int folder, const char* name, mode_t mode) noexcept {
    if (is_refused(folder, name, not_made))
        return -1;
    return static_cast<int>(::syscall(SYS_mkdirat, folder, name, mode));
}

class FailingTrashTest : public QObject {
    Q_OBJECT

private slots:
    void init() { not_moved = not_removed = not_made = {}; }
    void cleanup() { init(); }

    void a_deletion_that_breaks_off_puts_all_of_it_back() {
        const AlbumFolder album;
        album.write("a.jpg", "photo");
        album.write("b.jpg.tags/memo.flac", "sound");
        album.write("c.jpg", "another");
        const auto before = album.files();
        Trash trash(album.path());
        not_moved = "c.jpg";
        const auto id = trash.put({"a.jpg", "b.jpg.tags", "c.jpg"}, "all");
        QVERIFY(!id.ok());
        QCOMPARE(id.error(), std::string("Nothing was deleted: the disk is full."));
        QVERIFY(album.files() == before);
        QVERIFY(fs::is_empty(trash.folder()));
    }

    /// It is known to be in the trash, and comes back later.
    void what_cannot_even_be_put_back_stays_in_the_trash() {
        const AlbumFolder album;
        album.write("a.jpg", "photo");
        Trash trash(album.path());
        const auto id = trash.put({"a.jpg"}, "it");
        QVERIFY(id.ok());
        not_moved = "a.jpg";
        const std::string problem = trash.restore(*id);
        QCOMPARE(problem,
                 std::string("\"a.jpg\" cannot be restored and stays in the trash: the disk is full."));
        QCOMPARE(trash.entries().size(), std::size_t(1));
        not_moved = {};
        QCOMPARE(trash.restore(*id), std::string());
        QCOMPARE(album.read("a.jpg"), std::string("photo"));
    }

    void a_folder_that_cannot_be_made_again_keeps_what_was_in_it_in_the_trash() {
        const AlbumFolder album;
        album.write("2026/a.jpg.tags/memo.flac", "sound");
        Trash trash(album.path());
        const auto id = trash.put({"2026/a.jpg.tags/memo.flac"}, "a recording");
        QVERIFY(id.ok());
        fs::remove_all(album / "2026");
        for (const char* name : {"2026", "a.jpg.tags"}) {
            not_made = name;
            QVERIFY(trash.restore(*id).find("stays in the trash: the disk is full.") != std::string::npos);
        }
        QCOMPARE(trash.files_in(*id).size(), std::size_t(1));
        not_made = {};
        QCOMPARE(trash.restore(*id), std::string());
        QCOMPARE(album.read("2026/a.jpg.tags/memo.flac"), std::string("sound"));
    }

    void without_a_trash_nothing_is_deleted() {
        const AlbumFolder album;
        album.write("a.jpg", "photo");
        Trash trash(album.path());
        not_made = "/trash";
        QCOMPARE(trash.put({"a.jpg"}, "it").error(),
                 std::string("Nothing was deleted, because the trash cannot be created: the disk is full."));
        not_made = {};
        const auto before = trash.put({"a.jpg"}, "it");
        QCOMPARE(trash.restore(*before), std::string());
        const std::string day = before->substr(0, 10);
        not_made = day; // in the name of each entry of that day
        const auto id = trash.put({"a.jpg"}, "it");
        not_made = {};
        if (!id.ok()) // but at midnight
            QCOMPARE(id.error(), std::string("Nothing was deleted, because the trash cannot be written to: "
                                             "the disk is full."));
        QCOMPARE(album.read("a.jpg"), std::string("photo"));
    }

    /// The list goes last, in whichever order the disk names the rest: what is left is still known, and can be restored
    /// or erased another time.
    void what_cannot_be_erased_is_still_known() {
        for (const char* stuck : {"a.flac", "b.flac", "c.flac"}) {
            const AlbumFolder album;
            for (const char* name : {"a.flac", "b.flac", "c.flac"})
                album.write(fs::path(name).replace_extension(".tags") / name, name);
            Trash trash(album.path());
            const auto id = trash.put({"a.tags", "b.tags", "c.tags"}, "three");
            QVERIFY(id.ok());
            not_removed = stuck;
            const std::string erased = trash.erase(*id);
            const std::string emptied = trash.empty();
            not_removed = {};
            QCOMPARE(erased, std::string("The trash could not be emptied: the disk is full."));
            QCOMPARE(emptied, erased);
            const auto entries = trash.entries();
            QCOMPARE(entries.size(), std::size_t(1));
            QCOMPARE(entries[0].what, std::string("three"));
            QCOMPARE(trash.files_in(*id).size(), std::size_t(1));
            QCOMPARE(trash.restore(*id), std::string());
            QCOMPARE(album.read(fs::path(stuck).replace_extension(".tags") / stuck), std::string(stuck));
        }
    }

    void the_rest_of_the_trash_is_emptied_where_one_entry_stays() {
        const AlbumFolder album;
        Trash trash(album.path());
        for (const char* name : {"a", "b", "z"})
            QVERIFY(trash.put({album.write(name, "x")}, name).ok());
        album.write("later.tags/stuck", "x");
        QVERIFY(trash.put({"later.tags"}, "later").ok());
        not_removed = "stuck";
        const std::string problem = trash.empty();
        not_removed = {};
        QVERIFY(!problem.empty());
        QCOMPARE(trash.entries().size(), std::size_t(1));
        QCOMPARE(trash.entries()[0].what, std::string("later"));
    }
};

QTEST_GUILESS_MAIN(FailingTrashTest)
#include "failing_trash_test.moc"
