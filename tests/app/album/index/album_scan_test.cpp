// SPDX-License-Identifier: Apache-2.0
#include "test_album.hpp"
#include "test_program.hpp"

#include <QTest>

#include <array>
#include <fcntl.h>
#include <sys/stat.h>

namespace album_scan_test {

using namespace tp;
using namespace tp::testing;

class AlbumScanTest : public QObject {
    Q_OBJECT

private slots:
    void what_did_not_change_is_not_read_again() {
        TestAlbum album;
        const fs::path a = album.add("a.jpg", "a", {"Anna"});
        const fs::path b = album.add("sub/b.jpg", "b", {"Ben"});
        QVERIFY(album.settles());
        auto index = AlbumIndex::in_memory();
        const auto first = album.scan(*index);
        QCOMPARE(first.value().found, std::size_t(2));
        QCOMPARE(first.value().read, std::size_t(2));
        QCOMPARE(first.value().hashed, std::size_t(2));
        QCOMPARE(album.scan(*index).value().read, std::size_t(0));

        TestAlbum::set_people(a, {"Alma"});
        QVERIFY(album.settles());
        const auto sidecar_changed = album.scan(*index);
        QCOMPARE(sidecar_changed.value().read, std::size_t(1));
        QCOMPARE(sidecar_changed.value().hashed, std::size_t(0));

        fs::create_directory(b.string() + ".tags");
        write_file(b.string() + ".tags/one.flac", "the sea");
        QVERIFY(album.settles());
        QCOMPARE(album.scan(*index).value().read, std::size_t(1));

        write_file(b, jpeg_bytes("B"));
        QCOMPARE(album.scan(*index).value().hashed, std::size_t(1));
        QCOMPARE(index->dump().value(), album.fresh_dump());
        QVERIFY(index->dump().value().find("the sea") != std::string::npos);
    }

    /// Times may lie in the future or go back; that they are others is what counts.
    void a_clock_that_runs_backwards() {
        TestAlbum album;
        const fs::path a = album.add("a.jpg", "a");
        auto index = AlbumIndex::in_memory();
        for (const long seconds : {4'000'000'000L, 1'000'000'000L, 0L, -1'000'000L}) {
            const std::array<timespec, 2> times{timespec{seconds, 0}, timespec{seconds, 0}};
            QCOMPARE(::utimensat(AT_FDCWD, a.c_str(), times.data(), 0), 0);
            QVERIFY(album.settles());
            QCOMPARE(album.scan(*index).value().hashed, std::size_t(1));
            QCOMPARE(album.scan(*index).value().hashed, std::size_t(0));
            QCOMPARE(index->dump().value(), album.fresh_dump());
        }
    }

    void one_that_is_gone_is_missing_until_it_is_purged() {
        TestAlbum album;
        const fs::path a = album.add("a.jpg", "a", {"Anna"});
        album.add("b.jpg", "b", {"Anna"});
        auto index = AlbumIndex::in_memory();
        QVERIFY(album.scan(*index).ok());
        const std::string both = index->dump().value();
        const std::string bytes = file_bytes(a);
        fs::remove(a);
        QCOMPARE(album.scan(*index).value().missing, std::size_t(1));
        QCOMPARE(index->dump().value(), album.fresh_dump());
        QCOMPARE(index->totals().value().missing, std::size_t(1));
        QCOMPARE(index->missing().value(), (std::vector<fs::path>{album.top() / "album" / "a.jpg"}));

        write_file(a, bytes);
        QVERIFY(album.scan(*index).ok());
        QVERIFY(index->missing().value().empty());

        fs::remove(a);
        QVERIFY(album.scan(*index).ok());
        QVERIFY(forgets_missing(*index));
        QCOMPARE(index->totals().value().missing, std::size_t(0));
        QCOMPARE(index->dump().value(), album.fresh_dump());
        QCOMPARE(faults_of(*index), std::string());
    }

    void moved_and_renamed_ones_are_told() {
        TestAlbum album;
        const fs::path a = album.add("a.jpg", "a");
        const fs::path b = album.add("deep/b.jpg", "b");
        auto index = AlbumIndex::in_memory();
        QVERIFY(album.scan(*index).value().moves.empty());
        fs::create_directory(album.root() / "new");
        fs::rename(a, album.root() / "new" / "a.jpg");
        fs::rename(album.root() / "deep", album.root() / "deeper");
        const fs::path root = fs::canonical(album.root());
        const std::vector<Move> moves{{root / "a.jpg", root / "new" / "a.jpg"},
                                      {root / "deep" / "b.jpg", root / "deeper" / "b.jpg"}};
        QCOMPARE(album.scan(*index).value().moves, moves);
        QCOMPARE(index->moves().value(), moves); // until they have been dealt with
        QCOMPARE(index->forget(moves[0].from), std::string());
        QCOMPARE(index->moves().value(), (std::vector<Move>{moves[1]}));
    }

    void a_copy_is_no_move_and_of_several_places_the_name_decides() {
        TestAlbum album;
        const fs::path a = album.add("a.jpg", "same");
        auto index = AlbumIndex::in_memory();
        QVERIFY(album.scan(*index).ok());
        album.add("x/b.jpg", "same");
        album.add("y/a.jpg", "same");
        album.add("z/c.jpg", "same");
        QVERIFY(album.scan(*index).value().moves.empty());
        fs::remove(a);
        const fs::path root = fs::canonical(album.root());
        QCOMPARE(album.scan(*index).value().moves,
                 (std::vector<Move>{{root / "a.jpg", root / "y" / "a.jpg"}}));
    }

    void duplicates_are_told_and_links_are_none() {
        TestAlbum album;
        const fs::path a = album.add("a.jpg", "same");
        album.add("b.jpg", "same");
        album.add("c.jpg", "other");
        fs::create_symlink(a, album.root() / "link.jpg");
        fs::create_hard_link(a, album.root() / "hard.jpg");
        auto index = AlbumIndex::in_memory();
        const fs::path root = fs::canonical(album.root());
        QCOMPARE(album.scan(*index).value().duplicates,
                 (std::vector<std::vector<fs::path>>{{root / "a.jpg", root / "b.jpg"}}));
        QCOMPARE(index->totals().value().photos, std::size_t(5));
    }

    void a_stopped_scan_is_gone_on_with() {
        TestAlbum album;
        SyntheticAlbum(3).write(album.root(), 450);
        QVERIFY(album.settles());
        auto index = AlbumIndex::in_memory();
        std::size_t done = 0;
        for (int i = 0; i < 6; ++i) {
            std::stop_source stop;
            album.tools.stop = stop.get_token();
            std::size_t last = 0;
            album.tools.progress = [&](const ScanProgress& progress) {
                QCOMPARE(progress.done, last + 1);
                last = progress.done;
                QVERIFY(progress.left.has_value() && progress.left->count() >= 0);
                QCOMPARE(progress.total, 450 - done);
                if (progress.done == 90)
                    stop.request_stop();
            };
            const auto report = album.scan(*index);
            QVERIFY(report.ok());
            QCOMPARE(report.value().stopped, done < 450);
            done += report.value().read;
            QCOMPARE(done, std::min<std::size_t>(450, 90 * static_cast<std::size_t>(i + 1)));
            QCOMPARE(index->totals().value().photos, done);
        }
        album.tools.progress = {};
        album.tools.stop = {};
        QCOMPARE(index->dump().value(), album.fresh_dump());
    }

    void a_stopped_scan_takes_nothing_for_missing() {
        TestAlbum album;
        album.add("a.jpg", "a");
        auto index = AlbumIndex::in_memory();
        QVERIFY(album.scan(*index).ok());
        fs::remove(album.root() / "a.jpg");
        std::stop_source stop;
        stop.request_stop();
        album.tools.stop = stop.get_token();
        QVERIFY(album.scan(*index).value().stopped);
        QCOMPARE(index->totals().value().missing, std::size_t(0));
    }

    void bad_files_leave_the_rest_alone() {
        TestAlbum album;
        album.add("good.jpg", "good", {"Anna"});
        write_file(album.root() / "page.jpg", "<html>");
        write_file(album.root() / "empty.png", "");
        write_file(album.root() / "README", "no picture, and nobody said so");
        album.add("sour.jpg", "sour");
        const auto reader = album.tools.read_record;
        album.tools.read_record = [&](const fs::path& photo) -> Result<PhotoRecord> {
            if (photo.filename() == "sour.jpg")
                return Error{"This is sour."};
            return reader(photo);
        };
        auto index = AlbumIndex::in_memory();
        const auto report = album.scan(*index);
        QCOMPARE(report.value().problems.size(), std::size_t(3));
        QCOMPARE(index->totals().value().photos, std::size_t(2));
        QVERIFY(index->dump().value().find("This is sour.") != std::string::npos);
        for (const std::string& problem : report.value().problems)
            QVERIFY(problem.ends_with('.'));
    }

    void a_recording_that_has_just_begun_is_no_fault_and_a_broken_one_is() {
        TestAlbum album;
        const fs::path photo = album.add("a.jpg", "a");
        fs::create_directory(photo.string() + ".tags");
        write_file(photo.string() + ".tags/memo.wav.part", "");
        album.tools.read_recording = [](const fs::path&) -> Result<Tag> {
            return Error{"It holds no sound."};
        };
        auto index = AlbumIndex::in_memory();
        QCOMPARE(album.scan(*index).value().problems.size(), std::size_t(0));
        write_file(photo.string() + ".tags/memo.flac", "");
        QVERIFY(album.settles());
        QCOMPARE(album.scan(*index).value().problems.size(), std::size_t(1));
    }

    void a_photograph_that_becomes_something_else_is_missing() {
        TestAlbum album;
        const fs::path a = album.add("a.jpg", "a", {"Anna"});
        const fs::path b = album.add("b.jpg", "b", {"Ben"});
        auto index = AlbumIndex::in_memory();
        QVERIFY(album.scan(*index).ok());
        write_file(a, "<html>");
        fs::remove(b);
        fs::create_directory(b);
        QCOMPARE(album.scan(*index).value().missing, std::size_t(2));
        QCOMPARE(index->dump().value(), album.fresh_dump());
    }

    void a_folder_that_cannot_be_read_keeps_what_was_known() {
        TestAlbum album;
        album.add("open/a.jpg", "a");
        const fs::path other = album.top() / "other";
        fs::create_directory(other);
        write_file(other / "b.jpg", jpeg_bytes("b"));
        auto index = AlbumIndex::in_memory();
        QVERIFY(scan_album(*index, {album.root(), other}, album.tools).ok());
        const std::string before = index->dump().value();
        fs::rename(other, album.top() / "unplugged");
        const auto report = scan_album(*index, {album.root(), other}, album.tools);
        QCOMPARE(report.value().problems.size(), std::size_t(1));
        QCOMPARE(index->dump().value(), before);
        // One that is not asked for any more is out of the album.
        QCOMPARE(scan_album(*index, {album.root()}, album.tools).value().missing, std::size_t(1));
        QCOMPARE(index->dump().value(), album.fresh_dump());
    }

    void links_that_lead_round_are_walked_once() {
        TestAlbum album;
        album.add("a/one.jpg", "1");
        album.add("b/two.jpg", "2");
        const fs::path outside = album.top() / "outside";
        fs::create_directory(outside);
        write_file(outside / "three.jpg", jpeg_bytes("3"));
        fs::create_directory_symlink(album.root() / "b", album.root() / "a" / "b");
        fs::create_directory_symlink(album.root() / "a", album.root() / "b" / "a");
        fs::create_directory_symlink(album.root(), album.root() / "b" / "root");
        fs::create_directory_symlink(outside, album.root() / "a" / "out");
        fs::create_directory_symlink(outside, outside / "self");
        auto index = AlbumIndex::in_memory();
        const auto report = scan_album(*index, {album.root(), album.root() / "a"}, album.tools);
        QCOMPARE(report.value().found, std::size_t(2));
        QCOMPARE(report.value().problems.size(), std::size_t(4)); // each link once
        QCOMPARE(index->dump().value(), album.fresh_dump());
    }

    void names_of_every_kind() {
        TestAlbum album;
        const std::vector<std::string> names{
            "line\nend.jpg", "J\xF6rg.jpg",        std::string(251, 'n') + ".jpg",
            "שלום עולם.jpg", "👵🏽 Oma.jpg",   "tab\tand \"quotes\" 'n' %.jpg",
            "-rf.jpg",       "a\u202Egpj.exe.jpg", "back\\slash|pipe.jpg",
            " blank .jpg",   "\xFF\xFE\x80.jpg",   "NUL.jpg"};
        for (const std::string& name : names)
            album.add("f\xF6lder\n/" + name, name);
        auto index = AlbumIndex::open(album.cache());
        const auto report = album.scan(*index);
        QVERIFY2(report.ok(), report.error().c_str());
        QCOMPARE(index->totals().value().photos, names.size());
        QCOMPARE(index->dump().value(), album.fresh_dump());
        fs::remove_all(album.root() / "f\xF6lder\n");
        QCOMPARE(album.scan(*index).value().missing, names.size());
        const std::vector<fs::path> missing = index->missing().value();
        for (const fs::path& path : missing)
            QCOMPARE(index->forget(path), std::string());
        QCOMPARE(index->totals().value().missing, std::size_t(0));
    }

    void only_the_folders_asked_for_are_looked_into() {
        TestAlbum album;
        const fs::path a = album.add("a/one.jpg", "1", {"Anna"});
        const fs::path b = album.add("b/two.jpg", "2", {"Ben"});
        auto index = AlbumIndex::in_memory();
        QVERIFY(album.scan(*index).ok());
        TestAlbum::set_people(a, {"Alma"});
        TestAlbum::set_people(b, {"Berta"});
        QVERIFY(rescan_folders(*index, {a.parent_path()}, album.tools).ok());
        const std::string dump = index->dump().value();
        QVERIFY(dump.find("Alma") != std::string::npos);
        QVERIFY(dump.find("Berta") == std::string::npos);
        fs::create_directory(b.string() + ".tags"); // another program recorded something
        write_file(b.string() + ".tags/one.flac", "the sea");
        QVERIFY(rescan_folders(*index, {b.string() + ".tags"}, album.tools).ok());
        QCOMPARE(index->dump().value(), album.fresh_dump());
    }
};

} // namespace album_scan_test

TP_TEST(album_scan_test, AlbumScanTest, event_loop)
#include "album_scan_test.moc"
