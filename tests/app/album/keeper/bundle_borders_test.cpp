// SPDX-License-Identifier: Apache-2.0
// How large a bundle's directory may be, what changes or is stopped while it is packed, and what a folder's photographs are.
#include "album_folder.hpp"
#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/import_sources.hpp"
#include "core/files/file_words.hpp"
#include "made_zip.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace bundle_borders_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

class BundleBordersTest : public QObject {
    Q_OBJECT

    /// What is said where `meanwhile` happens after the first piece of the first file.
    static std::string packed_while(const AlbumFolder& album, const AlbumFolder& place,
                                    const std::vector<fs::path>& photos,
                                    const std::function<void()>& meanwhile) {
        bool first = true;
        return write_bundle(place / "b", album.path(), photos, [&](std::uintmax_t, std::uintmax_t) {
            if (std::exchange(first, false))
                meanwhile();
        });
    }

private slots:
    /// A megabyte, and half a kilobyte for each file that it may hold: its name, and what programs add to it.
    void a_directory_of_long_names_is_read_up_to_its_limit() {
        BundleLimits limits;
        limits.most_files = 4'000;
        for (const auto& [name_bytes, fits] :
             {std::pair{std::size_t{600}, true}, {std::size_t{800}, false}}) {
            const AlbumFolder place;
            std::vector<ZipEntry> entries{{"a.jpg"}};
            for (int i = 1; i < 4'000; ++i) {
                const std::string number = std::to_string(i) + "/";
                entries.push_back({number + std::string(name_bytes - number.size(), 'x')});
            }
            write_zip(place / "b", entries, "zip:compression=store");
            const std::string problem = unpack_bundle(place / "b", place / "out", limits);
            QVERIFY2(problem.empty() == fits, problem.c_str());
            QVERIFY(fits || problem.ends_with("it holds more files than any album."));
        }
    }

    /// What is in a bundle may be longer than its directory.
    void a_photograph_may_be_longer_than_a_directory() {
        const AlbumFolder place;
        write_zip(place / "b", {{"a.jpg", std::string(3'000'000, 'x')}}, "zip:compression=store");
        BundleLimits limits;
        limits.most_files = 1;
        QCOMPARE(unpack_bundle(place / "b", place / "out", limits), std::string());
        QCOMPARE(fs::file_size(place / "out/a.jpg"), std::uintmax_t{3'000'000});
    }

    void what_changes_while_it_is_packed_is_said_and_leaves_no_bundle() {
        for (const std::uintmax_t bytes : {std::uintmax_t{100'000}, std::uintmax_t{300'000}}) {
            const AlbumFolder album, place;
            const fs::path photo = album.write("a.jpg", std::string(200'000, 'p'));
            const std::string problem =
                packed_while(album, place, {photo}, [&] { fs::resize_file(photo, bytes); });
            QVERIFY2(problem.starts_with("The bundle " + quoted(place / "b") + " was not written: ") &&
                         problem.ends_with('.'),
                     problem.c_str());
            QVERIFY(place.files().empty());
        }
        const AlbumFolder album, place;
        const fs::path photo = album.write("a.jpg", "one"), second = album.write("b.jpg", "two");
        const std::string problem = packed_while(album, place, {photo, second}, [&] { fs::remove(second); });
        QVERIFY2(problem.ends_with(quoted(second) + " cannot be read."), problem.c_str());
        QVERIFY(place.files().empty());
    }

    void packing_that_is_stopped_says_so_and_leaves_the_old_bundle() {
        const AlbumFolder album, place;
        place.write("b", "old");
        const fs::path photo = album.write("a.jpg", std::string(200'000, 'p'));
        std::stop_source stop;
        int reports = 0;
        const std::string problem = write_bundle(
            place / "b", album.path(), {photo},
            [&](std::uintmax_t, std::uintmax_t) {
                ++reports;
                stop.request_stop();
            },
            stop.get_token());
        QVERIFY2(problem.ends_with(" was not written: it was stopped."), problem.c_str());
        QCOMPARE(reports, 1);
        QCOMPARE(place.files(), (std::map<std::string, std::string>{{"b", "old"}}));
    }

    /// Nothing is behind the directory's end, which is 22 bytes long.
    void a_bundle_ends_with_its_directory() {
        for (const char* bytes : {"1", "12"}) {
            const AlbumFolder album, place;
            QCOMPARE(write_bundle(place / "b", album.path(), {album.write("a.jpg", bytes)}), std::string());
            const std::string bundle = place.read("b");
            QCOMPARE(bundle.rfind("PK\x05\x06"), bundle.size() - 22);
        }
    }

    /// What the READMEs promise.
    void how_much_a_bundle_may_hold() {
        QCOMPARE(BundleLimits{}.most_files, std::size_t{200'000});
        QCOMPARE(BundleLimits{}.most_bytes, std::uintmax_t{68'719'476'736}); // 64 GiB
        QCOMPARE(BundleLimits{}.most_growth, 200.0);
    }

    void how_much_of_it_is_packed_is_told() {
        const AlbumFolder album, place;
        const fs::path first = album.write("a.jpg", std::string(100'000, 'a'));
        album.write("a.jpg.xmp", std::string(10, 'x'));
        const fs::path second = album.write("b.jpg", std::string(1'000, 'b'));
        std::vector<std::uintmax_t> told;
        QCOMPARE(write_bundle(place / "b", album.path(), {first, second},
                              [&](std::uintmax_t done, std::uintmax_t total) {
                                  QCOMPARE(total, std::uintmax_t{101'010});
                                  told.push_back(done);
                              }),
                 std::string());
        QCOMPARE(told, (std::vector<std::uintmax_t>{10, 65'546, 100'010, 101'010}));
    }

    void what_belongs_elsewhere_is_not_packed() {
        const AlbumFolder album, other, place;
        const fs::path outside = other.write("a.jpg", "x");
        QCOMPARE(write_bundle(place / "b", album.path(), {outside}),
                 quoted(outside) + " is not in the album " + quoted(album.path()) + ".");
        QCOMPARE(write_bundle(place / "b", album.path(), {album / "none.jpg"}),
                 "There is no photograph " + quoted(album / "none.jpg") + ".");
        QCOMPARE(write_bundle(place / "b", album.path(), {}),
                 std::string("There is no photograph to export."));
        const fs::path photo = album.write("a.jpg", "x");
        QVERIFY(!write_bundle(album.path(), album.path(), {photo}).empty()); // a folder
        QCOMPARE(export_bundle(place / "b", album.path(), {album.path()}), std::string());
        QCOMPARE(unpack_bundle(place / "b", place / "out"), std::string());
        QCOMPARE(place.read("out/a.jpg"), std::string("x"));
        QCOMPARE(unpack_bundle(place / "b", place / "out"),
                 "The bundle cannot be unpacked, because " + quoted(place / "out") + " is not empty.");
        QVERIFY(unpack_bundle(place / "b", place / "b/out").starts_with("The bundle cannot be unpacked: "));
        QCOMPARE(unpack_bundle(place / "none", place / "out2"),
                 "The bundle " + quoted(place / "none") + " cannot be used: there is no such file.");
        QCOMPARE(unpack_bundle(place / "out", place / "out3"),
                 "The bundle " + quoted(place / "out") + " cannot be used: there is no such file.");
    }

    void a_bundle_that_is_none_or_holds_nothing_is_said() {
        const AlbumFolder place;
        const auto said = [&](const std::string& bundle) {
            static int number = 0;
            const std::string problem =
                unpack_bundle(place / bundle, place / ("out" + std::to_string(++number)));
            const std::string start = "The bundle " + quoted(place / bundle) + " cannot be used: ";
            return problem.starts_with(start) ? problem.substr(start.size()) : "?" + problem;
        };
        place.write("text", "no zip file at all");
        QCOMPARE(said("text"), std::string("it is not a bundle, or it is damaged."));
        write_zip(place / "empty", {});
        QCOMPARE(said("empty"), std::string("it is not a bundle, or it is damaged."));
        write_zip(place / "folder", {{"a", "", AE_IFDIR}});
        QCOMPARE(said("folder"), std::string("it holds no photograph."));
        write_zip(place / "link", {{"a.jpg"}, {"b", "", AE_IFLNK, "/etc/passwd"}});
        QCOMPARE(said("link"), std::string("it holds \"b\", which is not a plain file."));
        write_zip(place / "twice", {{"a.jpg"}, {"b"}, {"b"}});
        QCOMPARE(said("twice"), std::string("it holds \"b\" twice."));
        write_zip(place / "folders", {{"a", "", AE_IFDIR}, {"a", "", AE_IFDIR}, {"a/b.jpg"}});
        QCOMPARE(said("folders"), std::string("?")); // of folders that is nothing
        write_zip(place / "file, then folder", {{"a.jpg"}, {"a.jpg/b.jpg"}});
        QVERIFY(said("file, then folder").ends_with('.'));
        write_zip(place / "folder, then file", {{"a.jpg/b.jpg"}, {"a.jpg"}});
        QVERIFY(said("folder, then file").ends_with('.'));
        write_zip(place / "out of it", {{"a.jpg"}, {"../b"}});
        QCOMPARE(said("out of it"), std::string("it holds \"../b\", which would lie outside the album."));
        write_zip(place / "back", {{"a.jpg"}, {"c/a\\b"}});
        QVERIFY2(said("back").ends_with(", which would lie outside the album."), said("back").c_str());
    }

    void photographs_in_folders_come_in_order() {
        const AlbumFolder album;
        for (const char* name : {"b/2.jpg", "b/1.JPG", "a/3.png", "b/c/4.heic", "b/notes.txt",
                                 "b/.hidden/5.jpg", "b/.6.jpg", ".hidden/7.jpg"})
            album.write(name, name);
        fs::create_directory(album / "b/8.jpg"); // a folder of that name
        album.write("b/8.jpg/9.jpg", "inside");
        std::vector<std::string> told;
        for (const PhotoToImport& photo : photographs_in({album / "b", album / "a/3.png", album.path() / "a",
                                                          album / "missing.jpg", album / ".hidden"})
                                              .photos)
            told.push_back(photo.file.lexically_relative(album.path()).string() + " to " +
                           photo.folder.string() + " " + std::to_string(photo.bytes));
        QCOMPARE(told, (std::vector<std::string>{"b/1.JPG to  7", "b/2.jpg to  7", "b/8.jpg/9.jpg to 8.jpg 6",
                                                 "b/c/4.heic to c 10", "a/3.png to  7", "a/3.png to  7",
                                                 "missing.jpg to  0", ".hidden/7.jpg to  13"}));
        QVERIFY(photographs_in({}).photos.empty());
        QVERIFY(photographs_in({album / "b/.hidden/.."}).photos.size() == 4);
    }
};

} // namespace bundle_borders_test

TP_TEST(bundle_borders_test, BundleBordersTest, event_loop)
#include "bundle_borders_test.moc"
