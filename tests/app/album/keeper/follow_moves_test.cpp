// SPDX-License-Identifier: Apache-2.0
#include "album_of_one.hpp"
#include "app/album/index/album_queries.hpp"
#include "app/album/index/album_scan.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/follow_moves.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/keeper/recording_facts.hpp"
#include "app/album/metadata/read_record.hpp"
#include "test_program.hpp"

#include <QTest>

#include <stop_token>
#include <utility>
#include <vector>

namespace follow_moves_test {

using namespace tp;
namespace fs = std::filesystem;

/// A photograph with a recording and a name, in an album that was scanned.
class FollowMovesTest : public QObject {
    Q_OBJECT

    struct Album : AlbumOfOne {
        Result<AlbumIndex> index = AlbumIndex::in_memory();

        ScanReport scan() {
            ScanTools tools;
            tools.read_record = read_record;
            tools.read_recording = recording_facts;
            return scan_album(*index, {folder.path()}, tools).value();
        }
        fs::path move_to(const std::string& place) {
            const fs::path to = folder / place;
            fs::create_directories(to.parent_path());
            fs::rename(photo, to);
            return to;
        }
    };

private slots:
    void recordings_and_words_go_where_the_photograph_went() {
        Album album;
        album.scan();
        const fs::path to = album.move_to("garden/Anna.jpg");
        const std::vector<Move> move{{album.photo, to}};
        QCOMPARE(album.scan().moves, move);
        const auto moves = follow_moves(*album.index);
        QVERIFY2(moves && moves->problems.empty(), moves.error().c_str());
        QCOMPARE(moves->followed, move);
        QVERIFY(companions_of(album.photo).empty());
        QVERIFY(fs::is_regular_file(tags_folder(to) / album.file));
        const auto record = read_record(to);
        QVERIFY(record && record->problems.empty());
        QCOMPARE(record->tags.at(0).file, album.file);
        QVERIFY(album.scan().moves.empty());
    }

    void a_place_that_is_taken_is_told_until_it_is_free() {
        Album album;
        album.scan();
        const fs::path to = album.move_to("Anna.jpg");
        album.folder.write("Anna.jpg.xmp", "another's");
        album.scan();
        for (int time = 0; time < 2; ++time) {
            const auto moves = follow_moves(*album.index);
            QVERIFY(moves && moves->followed.empty());
            QCOMPARE(moves->problems.size(), std::size_t{1});
            QVERIFY(moves->problems[0].find("Anna.jpg.xmp") != std::string::npos);
            QCOMPARE(companions_of(album.photo).size(), std::size_t{2});
        }
        fs::remove(album.folder / "Anna.jpg.xmp");
        QCOMPARE(follow_moves(*album.index)->followed.size(), std::size_t{1});
    }

    void what_a_kill_left_half_way_follows_the_next_time() {
        Album album;
        album.scan();
        const fs::path to = album.move_to("Anna.jpg");
        album.scan();
        fs::rename(album.photo.native() + ".xmp", to.native() + ".xmp");
        QCOMPARE(follow_moves(*album.index)->followed.size(), std::size_t{1});
        QVERIFY(fs::is_regular_file(tags_folder(to) / album.file));
    }

    void a_move_that_the_other_program_did_whole_is_only_forgotten() {
        Album album;
        album.scan();
        const fs::path to = album.move_to("Anna.jpg");
        for (const Companion& companion : companions_of(album.photo))
            fs::rename(companion.file, beside(to, companion));
        album.scan();
        const auto moves = follow_moves(*album.index);
        QVERIFY(moves && moves->followed.empty() && moves->problems.empty());
        QVERIFY(album.index->missing()->empty());
    }

    void who_stops_it_finds_each_move_whole_or_not_begun() {
        Album album;
        const fs::path second = a_photo(album.folder, "2026/IMG_2.jpg", 2);
        QVERIFY(album.keeper.add_recording(second, album.sound, {RecordingKind::memo, "Ben", {}, {}, {}, {}})
                    .ok());
        album.scan();
        album.move_to("garden/IMG_1.jpg");
        fs::rename(second, album.folder / "garden/IMG_2.jpg");
        album.scan();
        std::stop_source stop;
        std::vector<std::pair<std::size_t, std::size_t>> told;
        const auto first = follow_moves(*album.index, {[&](std::size_t done, std::size_t all) {
                                                           told.emplace_back(done, all);
                                                           stop.request_stop();
                                                       },
                                                       stop.get_token()});
        QVERIFY(first && first->stopped);
        QCOMPARE(first->followed.size(), std::size_t{1});
        QCOMPARE(told, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 2}}));
        QCOMPARE(companions_of(album.photo).size() + companions_of(second).size(), std::size_t{2});
        const auto rest = follow_moves(*album.index);
        QVERIFY(rest && !rest->stopped);
        QCOMPARE(rest->followed.size(), std::size_t{1});
        QVERIFY(companions_of(album.photo).empty() && companions_of(second).empty());
    }

    /// What moved is not known, or cannot be forgotten: it is said, and nothing is taken for done.
    void an_index_that_cannot_be_read_or_written_is_told() {
        for (const char* broken :
             {"DROP TABLE photos",
              "CREATE TRIGGER stuck BEFORE DELETE ON photos BEGIN SELECT RAISE(ABORT, 'stuck'); END"}) {
            Album album;
            album.scan();
            album.move_to("garden/Anna.jpg");
            album.scan();
            album.index->connection().run_once(broken);
            const auto moves = follow_moves(*album.index);
            QVERIFY2(!moves.ok() && moves.error().ends_with('.'), broken);
        }
    }

    void a_copy_whose_first_photograph_stays_takes_nothing() {
        Album album;
        album.scan();
        fs::copy_file(album.photo, album.folder / "copy.jpg");
        album.scan();
        QVERIFY(follow_moves(*album.index)->followed.empty());
        QCOMPARE(companions_of(album.photo).size(), std::size_t{2});
    }
};

} // namespace follow_moves_test

TP_TEST(follow_moves_test, FollowMovesTest, event_loop)
#include "follow_moves_test.moc"
