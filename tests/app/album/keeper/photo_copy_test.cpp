// SPDX-License-Identifier: Apache-2.0
// What goes along with a photograph into an album or out of a bundle, and what does not.
#include "album_folder.hpp"
#include "app/album/keeper/bundle_parts.hpp"
#include "app/album/keeper/import_list.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/photo_copy.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "made_zip.hpp"

#include <QTest>

#include <filesystem>
#include <map>
#include <string>
#include <sys/stat.h>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

class PhotoCopyTest : public QObject {
    Q_OBJECT

    /// Where it came to lie, with "=" where it was there before.
    static std::string copied(const AlbumFolder& card, const AlbumFolder& album, const char* name = "a.jpg") {
        const auto copy = copy_photo(card / name, companions_of(card / name), album.path());
        return copy ? copy->place.filename().string() + (copy->was_there ? "=" : "") : copy.error();
    }

private slots:
    /// As long as another is not the same as another.
    void other_bytes_of_the_same_length_are_another_photograph() {
        const AlbumFolder card, album;
        card.write("a.jpg", "new");
        album.write("a.jpg", "old");
        QCOMPARE(copied(card, album), std::string("a (2).jpg"));
        QCOMPARE(copied(card, album), std::string("a (2).jpg="));
        album.write("a.jpg", "new");
        QCOMPARE(copied(card, album), std::string("a.jpg="));
        QCOMPARE(album.files(), (Files{{"a.jpg", "new"}, {"a (2).jpg", "new"}}));
    }

    void a_companion_of_the_same_length_is_another_s() {
        for (const char* name : {"a.jpg.xmp", "a.jpg.contours.svg", "a.jpg.tags/1.flac"}) {
            const AlbumFolder card, album;
            card.write("a.jpg", "photo");
            card.write(name, "mine");
            album.write(name, "hers");
            QCOMPARE(copied(card, album), std::string("a (2).jpg"));
            QCOMPARE(album.read(name), std::string("hers"));
            const AlbumFolder again;
            again.write(name, "mine");
            QCOMPARE(copied(card, again), std::string("a.jpg"));
        }
    }

    /// Not what is half-written, and no folder; for their owner only.
    void recordings_go_along() {
        const AlbumFolder card, album;
        card.write("a.jpg", "photo");
        card.write("a.jpg.tags/1.flac", "1");
        card.write("a.jpg.tags/2.flac", "2");
        card.write("a.jpg.tags/.touchphoto-1-1.tmp", "half");
        card.write("a.jpg.tags/deeper/3.flac", "3");
        QCOMPARE(copied(card, album), std::string("a.jpg"));
        QCOMPARE(album.files(),
                 (Files{{"a.jpg", "photo"}, {"a.jpg.tags/1.flac", "1"}, {"a.jpg.tags/2.flac", "2"}}));
        struct stat about {};
        for (const char* name : {"a.jpg.tags", "a.jpg.tags/1.flac", "a.jpg.tags/2.flac"}) {
            QCOMPARE(::stat((album / name).c_str(), &about), 0);
            QCOMPARE(about.st_mode & 077u, 0u);
        }
    }

    void a_sidecar_named_by_the_stem_keeps_such_a_name() {
        const AlbumFolder card, album;
        card.write("a.jpg", "photo");
        card.write("a.XMP", "Lightroom's");
        album.write("a.jpg", "another");
        QCOMPARE(copied(card, album), std::string("a (2).jpg"));
        QCOMPARE(album.read("a (2).XMP"), std::string("Lightroom's"));
        QCOMPARE(companions_of(album / "a (2).jpg").size(), std::size_t{1});
        QVERIFY(companions_of(album / "a.jpg").empty());
    }

    void what_cannot_be_read_is_no_photograph_s_bytes() {
        QVERIFY(!content_hash("/proc/self/mem").ok()); // a file whose first byte cannot be read
        const AlbumFolder card, album;
        QVERIFY(copied(card, album).ends_with('.'));
        QVERIFY(album.files().empty());
    }

    void what_belongs_to_a_bundle_s_photographs() {
        BundleParts parts;
        QVERIFY(!parts.has_photo());
        for (const char* file :
             {"AZ.jpg", "b/c.d.HEIC", "[@.png", ".hidden/e.jpg", "f/.g/h.jpg", ".i.jpg", "notes.txt"})
            parts.add(file);
        QVERIFY(parts.has_photo());
        for (const char* file :
             {"AZ.jpg", "az.wav", "aZ.WAV", "AZ.MOV", "az.mp4", "az.xmp", "AZ.jpg.xmp", "az.JPG.contours.svg",
              "AZ.jpg.tags/any name", "b/c.d.HEIC", "b/c.d.xmp", "b/C.D.mov", "[@.svg",
              "AZ.jpg (conflicted copy 2026).xmp", "az.sync-conflict-20260501-101500.xmp"})
            QVERIFY2(parts.hold(file), file);
        for (const char* file : {"az.jpg",
                                 "AZ",
                                 "AZ.",
                                 "AZ.txt",
                                 "AZ.wave",
                                 "AZx.wav",
                                 "xaz.wav",
                                 "c.d.xmp",
                                 "b/AZ.xmp",
                                 "b/c.xmp",
                                 "az.jpg.tags/1",
                                 "AZ.jpg.tagz/1",
                                 "AZ.jpg.tags/b/1",
                                 "b/AZ.jpg.tags/1",
                                 ".hidden/e.jpg",
                                 ".hidden/e.xmp",
                                 "f/.g/h.jpg",
                                 "f/.g/h.jpg.xmp",
                                 ".i.jpg",
                                 ".i.xmp",
                                 "notes.txt",
                                 "{`.svg",
                                 "AZ.jpg (conflicted copy).exe"})
            QVERIFY2(!parts.hold(file), file);
        BundleParts none;
        none.add("a.xmp");
        none.add(".hidden/b.jpg");
        QVERIFY(!none.has_photo());
    }

    /// What a kill left of the unpacking is not taken for what the bundle holds.
    void an_import_of_a_bundle_that_was_killed_unpacks_it_again() {
        const AlbumFolder card, album;
        test::write_zip(card / "b.touchphoto", {{"a.jpg", "whole"}});
        ImportList list;
        list.sources = {card / "b.touchphoto"};
        const auto id = list.save(album.path());
        QVERIFY2(id.ok(), id.error().c_str());
        album.write(".touchphoto/import/" + *id + "/0/half.jpg", "half");
        const auto report = go_on_importing(album.path(), *id, {});
        QVERIFY2(report.ok(), report.error().c_str());
        QCOMPARE(report->photos.size(), std::size_t{1});
        QCOMPARE(album.files(), (Files{{"a.jpg", "whole"}}));
        QVERIFY(!fs::exists(album / ".touchphoto/import" / *id));
    }
};

QTEST_GUILESS_MAIN(PhotoCopyTest)
#include "photo_copy_test.moc"
