// SPDX-License-Identifier: Apache-2.0
// How long the rest of an import takes, what is told while it runs, and which of several goes on first; in virtual time.
#include "album_folder.hpp"
#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/import_list.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/own_state.hpp"
#include "made_zip.hpp"

#include <QDateTime>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;
using Fate = ImportedPhoto::Fate;

namespace {

std::int64_t waited_ms = 0;
timespec begun{}; ///< when the steady clock stopped, which goes on only by what was waited; 0: it goes

} // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* now) noexcept {
    if (clock != CLOCK_MONOTONIC || begun.tv_sec == 0)
        return static_cast<int>(::syscall(SYS_clock_gettime, clock, now));
    const std::int64_t ns = begun.tv_nsec + waited_ms % 1000 * 1'000'000;
    *now = {begun.tv_sec + waited_ms / 1000 + ns / 1'000'000'000, ns % 1'000'000'000};
    return 0;
}

extern "C" int gettimeofday(timeval* now, void*) noexcept {
    *now = {1'777'630'500, 0};
    return 0;
}

class ImportProgressTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        waited_ms = 0;
        ::syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &begun);
    }
    void cleanup() { begun = {}; }

    /// By the bytes that went before, from the first second on.
    void the_rest_takes_as_long_as_what_was_brought() {
        const AlbumFolder card, album;
        const std::vector<std::size_t> sizes{1'000, 3'000, 500, 1'500};
        for (std::size_t i = 0; i < sizes.size(); ++i)
            card.write(std::to_string(i) + ".jpg", std::string(sizes[i], static_cast<char>('a' + i)));
        std::vector<std::optional<double>> left;
        std::vector<std::uintmax_t> bytes;
        ImportTools tools;
        tools.progress = [&](const ImportProgress& progress) {
            left.push_back(progress.seconds_left);
            bytes.push_back(progress.bytes_done);
            waited_ms += left.size() == 1 ? 1'000 : 3'000;
        };
        QVERIFY(import_photos(album.path(), {}, {card.path()}, tools).ok());
        QCOMPARE(bytes, (std::vector<std::uintmax_t>{0, 1'000, 4'000, 4'500, 6'000}));
        QCOMPARE(left.size(), std::size_t{5});
        QVERIFY(!left[0]);
        QCOMPARE(left[1].value_or(-1.0), 5.0); // 1 s for a sixth
        QCOMPARE(left[2].value_or(-1.0), 2.0);
        QVERIFY(std::abs(left[3].value_or(-1.0) - 7.0 / 3.0) < 1e-9);
        QCOMPARE(left[4].value_or(-1.0), 0.0);
    }

    void before_a_second_is_over_nobody_knows() {
        const AlbumFolder card, album;
        for (const char* name : {"0.jpg", "1.jpg", "2.jpg"})
            card.write(name, name);
        std::vector<bool> known;
        ImportTools tools;
        tools.progress = [&](const ImportProgress& progress) {
            known.push_back(progress.seconds_left.has_value());
            waited_ms += known.size() == 1 ? 999 : 1;
        };
        QVERIFY(import_photos(album.path(), {}, {card.path()}, tools).ok());
        QCOMPARE(known, (std::vector<bool>{false, false, true, true}));
    }

    /// A file of no bytes says nothing of the speed.
    void nor_before_the_first_byte_is_there() {
        const AlbumFolder card, album;
        card.write("0.jpg", "");
        card.write("1.jpg", "1");
        std::vector<bool> known;
        ImportTools tools;
        tools.progress = [&](const ImportProgress& progress) {
            known.push_back(progress.seconds_left.has_value());
            waited_ms += 5'000;
        };
        QVERIFY(import_photos(album.path(), {}, {card.path()}, tools).ok());
        QCOMPARE(known, (std::vector<bool>{false, false, true}));
    }

    void the_oldest_import_goes_on_first() {
        const AlbumFolder card, album;
        ImportList list;
        list.sources = {card.path()};
        std::vector<std::string> ids;
        for (int i = 0; i < 12; ++i) {
            const auto id = list.save(album.path());
            QVERIFY2(id.ok(), id.error().c_str());
            ids.push_back(*id);
        }
        QCOMPARE(ids.front(), std::string("2026-05-01T101500.000"));
        QCOMPARE(unfinished_imports(album.path()), ids);
        const fs::path lists = ImportList::place_of(album.path(), "1").parent_path();
        QCOMPARE(replace_file(lists / ".touchphoto-1-1.tmp", "what a kill left"), std::string());
        QCOMPARE(replace_file(lists / "notes.txt", "no list"), std::string());
        QCOMPARE(unfinished_imports(album.path()), ids);
        for (const std::string& id : ids)
            QCOMPARE(give_up_import(album.path(), id), std::string());
        QVERIFY(unfinished_imports(album.path()).empty());
        QCOMPARE(give_up_import(album.path(), ids[0]), "There is no unfinished import \"" + ids[0] + "\".");
    }

    /// Though there be files that would be called so: what an id leads to is deleted with all that is in it.
    void what_names_no_import_gives_up_nothing() {
        const AlbumFolder album;
        const std::string list = R"({"into":"","sources":["/a"]})";
        album.write(".touchphoto/import/a/0/x.jpg", "of a");
        for (const char* name : {".touchphoto/import/.json", ".touchphoto/import/..json",
                                 ".touchphoto/import/...json", ".touchphoto/import/a/0.json", "kept.json"})
            album.write(name, list);
        const auto before = album.files();
        for (const char* id : {"", ".", "..", "../../kept", "a/0", "/etc/passwd", "b"}) {
            QCOMPARE(give_up_import(album.path(), id),
                     "There is no unfinished import \"" + std::string(id) + "\".");
            QVERIFY(!ImportList::read(album.path(), id).ok());
        }
        QVERIFY(album.files() == before);
    }

    void a_list_that_was_spoilt_is_said_data() {
        QTest::addColumn<QByteArray>("list");
        for (const char* list :
             {"", "{", "[]", "{}", R"({"into":"a"})", R"({"into":"a","sources":"/b"})",
              R"({"sources":[1],"into":""})", R"({"into":"..","sources":[]})",
              R"({"into":"/a","sources":[]})", R"({"into":"","sources":["relative"]})",
              R"({"into":"%:a%2","sources":[]})", R"({"into":"","sources":["/a","%:plain"]})"})
            QTest::newRow(list) << QByteArray(list);
    }
    void a_list_that_was_spoilt_is_said() {
        QFETCH(QByteArray, list);
        const AlbumFolder album;
        const fs::path file = ImportList::place_of(album.path(), "1");
        QCOMPARE(make_folder(file.parent_path()), std::string());
        QCOMPARE(replace_file(file, list.toStdString()), std::string());
        QCOMPARE(go_on_importing(album.path(), "1", {}).error(),
                 std::string("The list of the import \"1\" cannot be read; import its folder again, nothing "
                             "comes twice."));
        QCOMPARE(unfinished_imports(album.path()), std::vector<std::string>{"1"});
    }

    void a_bundle_is_told_while_it_is_unpacked() {
        const AlbumFolder card, album;
        test::write_zip(card / "b.touchphoto", {{"a.jpg", std::string(300'000, 'x')}},
                        "zip:compression=store");
        std::vector<double> shares;
        ImportTools tools;
        tools.unpacking = [&](const fs::path& bundle, double share) {
            QCOMPARE(bundle, card / "b.touchphoto");
            shares.push_back(share);
        };
        const auto report = import_photos(album.path(), {}, {card / "b.touchphoto"}, tools);
        QCOMPARE(report->count(Fate::imported), std::size_t{1});
        QVERIFY(shares.size() >= 4);
        QCOMPARE(shares.front(), 0.0);
        QVERIFY(shares[1] > 0.0 && shares[1] < 0.5);
        QVERIFY(std::is_sorted(shares.begin(), shares.end()) && shares.back() > 0.9 && shares.back() <= 1.0);
    }

    /// It is not said to hold no photograph, and goes on another time.
    void an_import_that_is_stopped_while_it_unpacks_is_not_finished() {
        const AlbumFolder card, album;
        test::write_zip(card / "b.touchphoto", {{"a.jpg", std::string(300'000, 'x')}},
                        "zip:compression=store");
        std::stop_source stop;
        ImportTools tools;
        tools.stop = stop.get_token();
        tools.unpacking = [&](const fs::path&, double share) {
            if (share > 0.0)
                stop.request_stop();
        };
        const auto stopped = import_photos(album.path(), {}, {card / "b.touchphoto"}, tools);
        QVERIFY(stopped->stopped && stopped->photos.empty());
        QCOMPARE(unfinished_imports(album.path()), std::vector<std::string>{stopped->id});
        QCOMPARE(go_on_importing(album.path(), stopped->id, {})->count(Fate::imported), std::size_t{1});
    }

    /// Another try may find a bundle whole that was not yet: it was still being copied.
    void an_import_whose_bundle_is_damaged_can_go_on() {
        const AlbumFolder card, album;
        card.write("b.touchphoto", "not yet");
        const auto failed = import_photos(album.path(), {}, {card / "b.touchphoto"}, {});
        QCOMPARE(failed->count(Fate::failed), std::size_t{1});
        QCOMPARE(unfinished_imports(album.path()), std::vector<std::string>{failed->id});
        test::write_zip(card / "b.touchphoto", {{"a.jpg", "whole"}});
        QCOMPARE(go_on_importing(album.path(), failed->id, {})->count(Fate::imported), std::size_t{1});
        QVERIFY(unfinished_imports(album.path()).empty());
    }

    void what_an_import_cannot_begin_with_is_said() {
        const AlbumFolder card, album;
        const fs::path photo = card.write("a.jpg", "photo");
        QCOMPARE(import_photos(album.path(), {}, {card / "missing"}, {}).error(),
                 "There is no file or folder \"" + (card / "missing").string() + "\".");
        for (const char* into : {"..", "../x", "/tmp", "a/../.."})
            QVERIFY(import_photos(album.path(), into, {photo}, {})
                        .error()
                        .ends_with(" is not a folder in the album."));
        album.write("file", "no folder");
        QVERIFY(import_photos(album.path(), "file/x", {photo}, {}).error().find(" cannot be created: ") !=
                std::string::npos);
        QCOMPARE(make_folder(own_state_of(album.path()).parent_path()), std::string());
        QCOMPARE(replace_file(own_state_of(album.path()), "no folder either"), std::string());
        QVERIFY(
            import_photos(album.path(), {}, {photo}, {}).error().starts_with("The import cannot begin: "));
        QCOMPARE(import_photos(album.path(), "a/../b", {photo}, {}).error().substr(0, 24),
                 std::string("The import cannot begin:"));
        QVERIFY(fs::is_directory(album / "b"));
    }
};

QTEST_GUILESS_MAIN(ImportProgressTest)
#include "import_progress_test.moc"
