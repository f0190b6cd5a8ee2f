// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/schema.hpp"
#include "test_album.hpp"

#include <QTest>

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace tp;
using namespace tp::testing;

namespace {

unsigned mode_of(const fs::path& file) {
    struct stat about {};
    return ::stat(file.c_str(), &about) == 0 ? about.st_mode & 0777u : 0;
}

fs::path database(const TestAlbum& album) { return album.cache() / "album.sqlite"; }

} // namespace

class AlbumIndexTest : public QObject {
    Q_OBJECT

    static void scanned(TestAlbum& album, AlbumIndex& index) {
        const auto report = album.scan(index);
        QVERIFY2(report.ok(), report.error().c_str());
        QCOMPARE(index.dump().value(), album.fresh_dump());
        QCOMPARE(faults_of(index), std::string());
    }

private slots:
    void only_its_owner_may_read_it() {
        ::umask(0);
        TestAlbum album;
        album.add("a.jpg", "a", {"Anna"});
        auto index = AlbumIndex::open(album.cache());
        scanned(album, *index);
        QCOMPARE(mode_of(album.cache()), 0700u);
        for (const auto& file : fs::directory_iterator(album.cache()))
            QCOMPARE(mode_of(file.path()), 0600u);
        QVERIFY(fs::exists(album.cache() / "album.sqlite-wal"));
        QVERIFY(index->notices().empty());
        ::umask(022);
    }

    void it_is_there_the_next_time() {
        TestAlbum album;
        album.add("a.jpg", "a", {"Anna"});
        std::string dump;
        {
            auto index = AlbumIndex::open(album.cache());
            scanned(album, *index);
            dump = index->dump().value();
        }
        auto index = AlbumIndex::open(album.cache());
        QCOMPARE(index->dump().value(), dump);
        QVERIFY(dump.find("Anna") != std::string::npos);
    }

    void an_older_schema_is_migrated_with_what_it_holds() {
        TestAlbum album;
        album.add("a.jpg", "a", {"Anna"});
        QVERIFY(album.settles());
        {
            auto index = AlbumIndex::open(album.cache());
            scanned(album, *index);
        }
        { // as the first version had it: no full-text search, and nothing seen
            SqlConnection connection = SqlConnection::to_file(database(album));
            for (const char* sql :
                 {"DROP VIEW looked", "DROP TRIGGER face_said", "DROP TRIGGER face_not_said",
                  "DROP TABLE faces_apart", "DROP TABLE known_faces", "DROP TABLE face_groups",
                  "DROP TABLE last_face_group", "DROP TABLE to_group", "DROP TABLE gone_faces",
                  "DROP TABLE told", "DROP TABLE words", "DROP TRIGGER content_forgotten",
                  "DROP TRIGGER content_changed", "DROP TABLE seen_faces", "DROP TABLE seen",
                  "ALTER TABLE photos DROP COLUMN worded"})
                connection.run_once(sql);
            connection.run_once("PRAGMA user_version = 1");
        }
        auto index = AlbumIndex::open(album.cache());
        QVERIFY(index->notices().empty());
        QCOMPARE(version_of(index->connection()), schema_version());
        QCOMPARE(index->totals().value().photos, std::size_t(1));
        const auto report = album.scan(*index);
        QCOMPARE(report.value().read, std::size_t(1));
        QCOMPARE(report.value().hashed, std::size_t(0)); // what the first version knew is not read again
        scanned(album, *index);
    }

    void every_step_of_the_schema_can_be_the_first() {
        for (int version = 1; version <= schema_version(); ++version) {
            TestAlbum album;
            fs::create_directory(album.cache());
            {
                SqlConnection connection = SqlConnection::to_file(database(album));
                migrate(connection, version);
                QCOMPARE(version_of(connection), version);
            }
            auto index = AlbumIndex::open(album.cache());
            QVERIFY(index->notices().empty());
            album.add("a.jpg", "a", {"Anna"});
            scanned(album, *index);
        }
    }

    /// Up to version 4 a look that somebody had ended was never begun again.
    void looks_that_were_never_ended_are_begun_again() {
        TestAlbum album;
        fs::create_directory(album.cache());
        {
            SqlConnection connection = SqlConnection::to_file(database(album));
            migrate(connection, 4);
            connection.run_once(
                "INSERT INTO seen VALUES(x'01', 1, 0, 0, 0, 0, 0, 0, 1), (x'02', 1, 9, 9, 0, 0, 0, 0, 1)");
        }
        auto index = AlbumIndex::open(album.cache());
        SqlRun run = index->connection().run("SELECT hash FROM seen");
        QVERIFY(run.next());
        QCOMPARE(run.bytes(0), std::string("\x02"));
        QVERIFY(!run.next());
    }

    void what_cannot_be_used_is_set_aside_data() {
        QTest::addColumn<QByteArray>("fault");
        for (const char* fault : {"newer", "garbage", "half a page", "another program's", "cut"})
            QTest::newRow(fault) << QByteArray(fault);
    }

    void what_cannot_be_used_is_set_aside() {
        QFETCH(QByteArray, fault);
        TestAlbum album;
        SyntheticAlbum(1).write(album.root(), 300);
        {
            auto index = AlbumIndex::open(album.cache());
            scanned(album, *index);
        }
        const fs::path file = database(album);
        if (fault == "newer" || fault == "another program's") {
            SqlConnection connection = SqlConnection::to_file(file);
            connection.run_once(fault == "newer"
                                    ? "PRAGMA user_version = " + std::to_string(schema_version() + 1)
                                    : "DROP TABLE photos");
        } else if (fault == "garbage") {
            write_file(file, std::string(100'000, 'g'));
        } else {
            fs::resize_file(file, fault == "cut" ? fs::file_size(file) / 2 : 1000);
        }
        // A database of which only a far part is gone is found out when that part is needed.
        auto index = AlbumIndex::open(album.cache());
        if (const auto report = album.scan(*index); !report || index->notices().empty()) {
            QVERIFY(fault == "cut");
            QVERIFY(!index->dump().ok());
            index = AlbumIndex::open(album.cache());
        }
        QCOMPARE(index->notices().size(), std::size_t(1));
        QVERIFY(!index->is_in_memory());
        QVERIFY(fs::exists(album.cache() / "album.sqlite.aside"));
        scanned(album, *index);
        QVERIFY(AlbumIndex::open(album.cache())->notices().empty());
    }

    void where_nothing_can_be_written_it_is_in_memory_data() {
        QTest::addColumn<QByteArray>("place");
        for (const char* place : {"below a file", "below /proc", "full disk"})
            QTest::newRow(place) << QByteArray(place);
    }

    void where_nothing_can_be_written_it_is_in_memory() {
        QFETCH(QByteArray, place);
        TestAlbum album;
        album.add("a.jpg", "a", {"Anna"});
        write_file(album.top() / "file", "x");
        const fs::path cache = place == "below a file"  ? album.top() / "file" / "cache"
                               : place == "below /proc" ? fs::path("/proc/touchphoto")
                                                        : album.cache();
        const auto previous = std::signal(SIGXFSZ, SIG_IGN);
        struct rlimit before {};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        if (place == "full disk") {
            const struct rlimit small { 4096, before.rlim_max };
            QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        }
        auto index = AlbumIndex::open(cache);
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, previous);
        QVERIFY2(index.ok(), index.error().c_str());
        QVERIFY(index->is_in_memory());
        QCOMPARE(index->notices().size(), std::size_t(1));
        QVERIFY2(index->notices().front().find("memory") != std::string::npos,
                 index->notices().front().c_str());
        scanned(album, *index);
    }

    void a_disk_that_fills_up_during_a_scan_is_said() {
        TestAlbum album;
        SyntheticAlbum(1).write(album.root(), 400);
        auto index = AlbumIndex::open(album.cache());
        const auto previous = std::signal(SIGXFSZ, SIG_IGN);
        struct rlimit before {};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        const struct rlimit small { 400'000, before.rlim_max };
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        const auto report = album.scan(*index);
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, previous);
        QVERIFY(!report.ok());
        QVERIFY2(report.error().ends_with('.'), report.error().c_str());
        scanned(album, *index); // there is room again
    }

    void a_discarded_one_is_made_anew() {
        TestAlbum album;
        album.add("a.jpg", "a", {"Anna"});
        {
            auto index = AlbumIndex::open(album.cache());
            scanned(album, *index);
        }
        QCOMPARE(AlbumIndex::discard(album.cache()), std::string());
        QCOMPARE(AlbumIndex::discard(album.cache()), std::string());
        QCOMPARE(AlbumIndex::discard(album.top() / "nowhere"), std::string());
        auto index = AlbumIndex::open(album.cache());
        QCOMPARE(index->totals().value().photos, std::size_t(0));
        scanned(album, *index);
    }

    void a_link_in_its_place_is_not_followed() {
        TestAlbum album;
        fs::create_directory(album.cache());
        write_file(album.top() / "victim", "");
        fs::create_symlink(album.top() / "victim", database(album));
        auto index = AlbumIndex::open(album.cache());
        QVERIFY(index->is_in_memory());
        QCOMPARE(file_bytes(album.top() / "victim"), std::string());
    }
};

QTEST_GUILESS_MAIN(AlbumIndexTest)
#include "album_index_test.moc"
