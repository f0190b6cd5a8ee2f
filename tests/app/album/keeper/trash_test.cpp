// SPDX-License-Identifier: Apache-2.0
#include "album_folder.hpp"
#include "app/album/keeper/trash.hpp"

#include <QDateTime>
#include <QTest>

#include <ctime>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

using namespace tp;
namespace fs = std::filesystem;

namespace {

std::time_t stands_still_at = 0; ///< the clock; 0: it goes

} // namespace

extern "C" int gettimeofday(timeval* now, void*) noexcept {
    timespec time{};
    const int failed = static_cast<int>(::syscall(SYS_clock_gettime, CLOCK_REALTIME, &time));
    *now = {time.tv_sec, time.tv_nsec / 1000};
    if (stands_still_at != 0)
        *now = {stands_still_at, 0};
    return failed;
}

class TrashTest : public QObject {
    Q_OBJECT

private slots:
    void what_is_deleted_comes_back_as_it_was() {
        const AlbumFolder album;
        album.write("2026/a.jpg", "photo");
        album.write("2026/a.jpg.xmp", "sidecar");
        album.write("2026/a.jpg.tags/memo.flac", "sound");
        album.write(std::string("2026/J\xF6rg\n.jpg"), "not UTF-8");
        const auto before = album.files();
        Trash trash(album.path());
        const auto id = trash.put({album / "2026/a.jpg", "2026/a.jpg.xmp", album / "2026/a.jpg.tags",
                                   std::string("2026/J\xF6rg\n.jpg")},
                                  "a.jpg with one recording");
        QVERIFY2(id.ok(), id.error().c_str());
        QVERIFY(!fs::exists(album / "2026/a.jpg"));
        QVERIFY(!fs::exists(album / "2026/a.jpg.tags"));
        QCOMPARE(trash.entries().size(), std::size_t{1});
        QCOMPARE(trash.entries()[0].what, std::string("a.jpg with one recording"));
        QCOMPARE(trash.files_in(*id).size(), std::size_t{4});
        struct stat about {};
        QCOMPARE(::stat(trash.folder().c_str(), &about), 0);
        QCOMPARE(about.st_mode & 0777u, 0700u);
        QCOMPARE(trash.restore(*id), std::string());
        QVERIFY(trash.entries().empty());
        QVERIFY(album.files() == before);
    }

    void only_the_owner_may_see_what_is_in_it_or_comes_back_to_recordings() {
        const AlbumFolder album;
        album.write("2026/a.jpg.tags/memo.flac", "sound");
        album.write(".touchphoto/people/Anna.flac", "her name");
        Trash trash(album.path());
        const mode_t before = ::umask(0);
        const auto id =
            trash.put({"2026/a.jpg.tags/memo.flac", ".touchphoto/people/Anna.flac"}, "recordings");
        QVERIFY2(id.ok(), id.error().c_str());
        const auto mode = [&](const fs::path& name) {
            struct stat about {};
            return ::stat((album / name).c_str(), &about) == 0 ? about.st_mode & 0777u : 0u;
        };
        const auto kept = mode(".touchphoto/trash/" + *id);
        fs::remove_all(album / "2026");
        fs::remove_all(album / ".touchphoto/people");
        const std::string problem = trash.restore(*id);
        ::umask(before);
        QCOMPARE(problem, std::string());
        QCOMPARE(kept, 0700u);
        QCOMPARE(mode("2026/a.jpg.tags"), 0700u);
        QCOMPARE(mode(".touchphoto/people"), 0700u);
        QCOMPARE(mode("2026"), 0777u);
    }

    /// Even where a disk is so fast that all of it happens in one millisecond.
    void the_newest_is_first_and_each_has_its_own_place() {
        const AlbumFolder album;
        Trash trash(album.path());
        std::vector<std::string> ids;
        stands_still_at = 1'777'630'500;
        QCOMPARE(QDateTime::currentMSecsSinceEpoch(), qint64{1'777'630'500'000});
        for (int i = 0; i < 30; ++i) {
            album.write("a.jpg", std::to_string(i));
            const auto id = trash.put({"a.jpg"}, std::to_string(i));
            QVERIFY(id.ok());
            ids.push_back(*id);
        }
        stands_still_at = 0;
        QCOMPARE(trash.entries().back().deleted, std::string("2026-05-01T10:15:00Z"));
        QCOMPARE(ids.front(), std::string("2026-05-01T101500.000"));
        const auto entries = trash.entries();
        QCOMPARE(entries.size(), std::size_t{30});
        for (std::size_t i = 1; i < entries.size(); ++i)
            QVERIFY(entries[i - 1].id > entries[i].id);
        QCOMPARE(entries.front().what, std::string("29"));
        QCOMPARE(trash.restore(ids[7]), std::string());
        QCOMPARE(album.read("a.jpg"), std::string("7"));
        QCOMPARE(trash.entries().size(), std::size_t{29});
    }

    /// Its own place may be another's by now: a recording of a photograph that has moved.
    void one_file_comes_back_where_it_is_wanted() {
        const AlbumFolder album;
        Trash trash(album.path());
        album.write("a.jpg.tags/memo.flac", "sound");
        const auto id = trash.put({"a.jpg.tags/memo.flac"}, "x");
        QCOMPARE(trash.restore(*id, "moved/a.jpg.tags/memo.flac"), std::string());
        QCOMPARE(album.read("moved/a.jpg.tags/memo.flac"), std::string("sound"));
        QVERIFY(!fs::exists(album / "a.jpg.tags/memo.flac"));
        const auto again = trash.put({"moved/a.jpg.tags/memo.flac"}, "x");
        QCOMPARE(trash.restore(*again, "../out"), std::string()); // not outside the album
        QCOMPARE(album.read("moved/a.jpg.tags/memo.flac"), std::string("sound"));
        album.write("b.jpg", "b");
        const auto two = trash.put({"moved/a.jpg.tags/memo.flac", "b.jpg"}, "x");
        QCOMPARE(trash.restore(*two, "elsewhere"), std::string()); // which of the two?
        QCOMPARE(album.read("b.jpg"), std::string("b"));
        QVERIFY(!fs::exists(album / "elsewhere"));
    }

    void a_place_that_is_taken_is_not_written_over() {
        const AlbumFolder album;
        Trash trash(album.path());
        album.write("a.jpg", "old");
        album.write("b.jpg", "other");
        const auto id = trash.put({"b.jpg", "a.jpg"}, "both");
        album.write("a.jpg", "new");
        const std::string problem = trash.restore(*id);
        QVERIFY2(problem.find("a.jpg") != std::string::npos, problem.c_str());
        QCOMPARE(album.read("a.jpg"), std::string("new"));
        QVERIFY(!fs::exists(album / "b.jpg"));
        fs::remove(album / "a.jpg");
        QCOMPARE(trash.restore(*id), std::string());
        QCOMPARE(album.read("a.jpg"), std::string("old"));
    }

    /// A power cut after some files went back leaves the others and the list.
    void a_restoring_that_was_cut_off_goes_on() {
        const AlbumFolder album;
        Trash trash(album.path());
        album.write("a.jpg", "a");
        album.write("b.jpg", "b");
        const auto id = trash.put({"a.jpg", "b.jpg"}, "both");
        fs::rename(trash.files_in(*id)[0], album / "a.jpg");
        QCOMPARE(trash.restore(*id), std::string());
        QCOMPARE(album.read("a.jpg"), std::string("a"));
        QCOMPARE(album.read("b.jpg"), std::string("b"));
    }

    /// All files went back, and the list stayed.
    void a_list_without_files_is_no_entry_and_goes_with_the_rest() {
        const AlbumFolder album;
        Trash trash(album.path());
        album.write("a.jpg", "a");
        const auto id = trash.put({"a.jpg"}, "x");
        fs::rename(trash.files_in(*id)[0], album / "a.jpg");
        std::vector<std::string> problems;
        QVERIFY(trash.entries(&problems).empty() && problems.empty());
        QCOMPARE(trash.restore(*id, "b.jpg"), std::string("\"b.jpg\" is not in the trash any more."));
        QCOMPARE(album.read("a.jpg"), std::string("a"));
        QCOMPARE(trash.empty(), std::string());
        QVERIFY(fs::is_empty(trash.folder()));
    }

    void what_cannot_be_deleted_leaves_everything() {
        const AlbumFolder album, other;
        album.write("a.jpg", "a");
        const auto before = album.files();
        Trash trash(album.path());
        QVERIFY(!trash.put({"a.jpg", "missing.jpg"}, "x").ok());
        QVERIFY(!trash.put({"a.jpg", other.write("b.jpg", "b")}, "x").ok());
        QVERIFY(!trash.put({"../a.jpg"}, "x").ok());
        QVERIFY(!trash.put({album.path()}, "x").ok());
        QVERIFY(!trash.put({}, "x").ok());
        QVERIFY(album.files() == before);
        QVERIFY(trash.entries().empty());
    }

    void emptied_is_gone() {
        const AlbumFolder album;
        Trash trash(album.path());
        album.write("a.jpg.tags/x.flac", "a");
        const auto id = trash.put({"a.jpg.tags"}, "x");
        QVERIFY(!trash.erase("../x").empty());
        QVERIFY(!trash.erase("unknown").empty());
        QCOMPARE(trash.empty(), std::string());
        QVERIFY(trash.entries().empty());
        QVERIFY(!trash.restore(*id).empty());
        QVERIFY(album.files().empty());
    }

    void what_names_no_entry_is_left_alone() {
        const AlbumFolder album;
        Trash trash(album.path());
        album.write("a.jpg", "a");
        const auto id = trash.put({"a.jpg"}, "x");
        const auto before = album.files();
        for (const std::string& name :
             {std::string(), std::string("."), std::string(".."), *id + "/0", *id + "/list.json",
              "../trash/" + *id, (album / ".touchphoto").string(), std::string("unknown")}) {
            for (const std::string& said :
                 {trash.erase(name), trash.restore(name), trash.entry(name).error()})
                QVERIFY2(said.starts_with("There is nothing of the name ") &&
                             said.ends_with(" in the trash."),
                         said.c_str());
            QVERIFY(trash.files_in(name).empty());
        }
        QVERIFY(album.files() == before);
    }

    /// A power cut before its list was there: nothing was moved. A file without a list is somebody's.
    void a_folder_without_a_list_is_told_where_something_lies_in_it() {
        const AlbumFolder album;
        Trash trash(album.path());
        fs::create_directories(trash.folder() / "empty");
        album.write(".touchphoto/trash/cut/.touchphoto-1-1.tmp", "half a list");
        std::vector<std::string> problems;
        QVERIFY(trash.entries(&problems).empty() && problems.empty());
        album.write(".touchphoto/trash/cut/0", "a photograph");
        QVERIFY(trash.entries(&problems).empty());
        QCOMPARE(problems, std::vector<std::string>{"The list of what was deleted in \"" +
                                                    (trash.folder() / "cut").string() +
                                                    "\" cannot be read; its files are still there."});
        QVERIFY(trash.entries().empty());
    }

    void a_list_is_read_up_to_16_megabytes() {
        const AlbumFolder album;
        const std::string list = R"({"what":"x","files":["a"]})";
        for (const std::size_t more : {std::size_t{0}, std::size_t{1}}) {
            album.write(".touchphoto/trash/1/list.json",
                        list + std::string((16u << 20) - list.size() + more, ' '));
            QCOMPARE(Trash(album.path()).entry("1").ok(), more == 0);
        }
    }

    void a_list_that_was_spoilt_is_said_and_left_alone_data() {
        QTest::addColumn<QByteArray>("list");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("not JSON") << QByteArray("{");
        QTest::newRow("no files") << QByteArray(R"({"what":"x","files":[]})");
        QTest::newRow("leads out") << QByteArray(R"({"what":"x","files":["../evil"]})");
        QTest::newRow("no name of ours") << QByteArray(R"({"what":"x","files":["a","%:b%2"]})");
        QTest::newRow("absolute") << QByteArray(R"({"what":"x","files":["/tmp/evil"]})");
    }

    void a_list_that_was_spoilt_is_said_and_left_alone() {
        QFETCH(QByteArray, list);
        const AlbumFolder album;
        Trash trash(album.path());
        album.write("a.jpg", "a");
        const auto id = trash.put({"a.jpg"}, "x");
        album.write(fs::path(".touchphoto/trash") / *id / "list.json", list.toStdString());
        std::vector<std::string> problems;
        QVERIFY(trash.entries(&problems).empty());
        QCOMPARE(problems.size(), std::size_t{1});
        QVERIFY(!trash.restore(*id).empty());
        QCOMPARE(trash.empty(), problems.front());
        QVERIFY(fs::exists(trash.folder() / *id / "0"));
    }
};

QTEST_GUILESS_MAIN(TrashTest)
#include "trash_test.moc"
