// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/folder_listing.hpp"
#include "app/album/index/photo_content.hpp"
#include "core/files/foreign_folder.hpp"
#include "synthetic_album.hpp"
#include "test_program.hpp"

#include <QCryptographicHash>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <sys/stat.h>

namespace folder_listing_test {

using namespace tp;
using namespace tp::testing;

class FolderListingTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path root_;

    std::vector<std::string> photos() const {
        std::vector<std::string> names;
        for (const ListedPhoto& photo : list_folder(root_).photos)
            names.push_back(photo.name);
        return names;
    }

    static std::vector<fs::path> folders(const fs::path& folder) {
        std::vector<fs::path> paths;
        for (const ListedFolder& below : list_folder(folder).folders)
            paths.push_back(below.path);
        return paths;
    }

    /// Once what is there has settled, which takes the system's clock some ticks.
    std::string settled_beside(const std::string& name) const {
        std::string beside;
        const auto look = [&] {
            for (const ListedPhoto& photo : list_folder(root_).photos)
                if (photo.name == name)
                    beside = photo.beside;
            return !beside.empty();
        };
        return QTest::qWaitFor(look) ? beside : "never settled";
    }

private slots:
    void init() {
        root_ = fs::canonical(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(root_);
    }

    void pictures_are_listed_and_others_not() {
        for (const char* name : {"a.jpg", "b.JPEG", "c.png", "d.webp", "e.tif", "f.TIFF", "g.heic", "i.avif", "j.HIF", "k.dng",
                                 "l.CR2", "m.cr3", "n.nef", "o.ARW", "p.orf", "q.rw2", "bare",
                                 "h.mp4", "a.jpg.xmp", "a.jpg.contours.svg", ".hidden.jpg"})
            write_file(root_ / name, "x");
        for (const char* name : {"a.jpg.tags", ".touchphoto", ".git", "sub", "dir.jpg"})
            fs::create_directory(root_ / name);
        QCOMPARE(photos(), (std::vector<std::string>{"a.jpg", "b.JPEG", "bare", "c.png", "d.webp", "e.tif",
                                                     "f.TIFF", "g.heic", "i.avif", "j.HIF", "k.dng", "l.CR2", "m.cr3", "n.nef",
                                                     "o.ARW", "p.orf", "q.rw2"}));
        QCOMPARE(folders(root_), (std::vector<fs::path>{root_ / "dir.jpg", root_ / "sub"}));
    }

    void content_decides() {
        using namespace std::string_view_literals;
        QVERIFY(begins_like_photo(jpeg_bytes("x")));
        QVERIFY(begins_like_photo("\x89PNG\r\n\x1A\n"));
        QVERIFY(begins_like_photo("RIFF\0\0\0\0WEBPVP8 "sv));
        QVERIFY(begins_like_photo("II*\0"sv));
        QVERIFY(begins_like_photo("MM\0*"sv));
        QVERIFY(begins_like_photo("\0\0\0\x18"
                                  "ftypheic"sv));
        QVERIFY(begins_like_photo("\0\0\0\x1C"
                                  "ftypavif"sv));
        QVERIFY(begins_like_photo("\0\0\0\x18"
                                  "ftypcrx "sv));
        for (const std::string_view raw : {"IIRO"sv, "IIRS"sv, "MMOR"sv, "IIU\0"sv})
            QVERIFY(begins_like_photo(raw));
        for (const std::string_view no : {""sv, "\xFF\xD8"sv, "<html>"sv, "RIFF\0\0\0\0WAVE"sv,
                                          "\0\0\0\x18"
                                          "ftypisom"sv})
            QVERIFY(!begins_like_photo(no));
    }

    void hashes_are_sha_256() {
        const std::string bytes = jpeg_bytes(std::string(60'000, 'x')) + std::string(200'000, 'y');
        write_file(root_ / "a.jpg", bytes);
        int error = 0;
        const auto content = read_photo_content(root_ / "a.jpg", {}, error);
        QVERIFY(content && content->photo);
        QCOMPARE(QByteArray::fromStdString(content->sha256),
                 QCryptographicHash::hash(QByteArray::fromStdString(bytes), QCryptographicHash::Sha256));
        QVERIFY(!read_photo_content(root_ / "none.jpg", {}, error));
        QCOMPARE(error, ENOENT);
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!read_photo_content(root_ / "a.jpg", stop.get_token(), error));
        QCOMPARE(error, 0);
    }

    void a_pipe_called_jpg_is_not_waited_for() {
        QCOMPARE(::mkfifo((root_ / "a.jpg").c_str(), 0600), 0);
        QVERIFY(photos().empty());
        int error = 0;
        const auto content = read_photo_content(root_ / "a.jpg", {}, error);
        QVERIFY(content && !content->photo);
    }

    void what_lies_beside_is_noticed_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<bool>("noticed");
        QTest::newRow("sidecar") << QByteArray("IMG_1.jpg.xmp") << true;
        QTest::newRow("Lightroom's sidecar") << QByteArray("IMG_1.xmp") << true;
        QTest::newRow("contours") << QByteArray("IMG_1.jpg.contours.svg") << true;
        QTest::newRow("Syncthing's copy")
            << QByteArray("IMG_1.jpg.sync-conflict-20260501-1015-AB.xmp") << true;
        QTest::newRow("Nextcloud's copy")
            << QByteArray("IMG_1.jpg (conflicted copy 2026-05-01 101500).xmp") << true;
        QTest::newRow("recording") << QByteArray("IMG_1.jpg.tags/a.flac") << true;
        QTest::newRow("another's sidecar") << QByteArray("IMG_10.jpg.xmp") << false;
        QTest::newRow("another photograph") << QByteArray("IMG_1 (2).jpg") << false;
        QTest::newRow("half-written") << QByteArray(".tmp-IMG_1.jpg.xmp") << false;
    }

    void what_lies_beside_is_noticed() {
        QFETCH(QByteArray, name);
        QFETCH(bool, noticed);
        fs::remove_all(root_);
        fs::create_directories(root_ / "IMG_1.jpg.tags");
        write_file(root_ / "IMG_1.jpg", jpeg_bytes("1"));
        const std::string before = settled_beside("IMG_1.jpg");
        write_file(root_ / name.toStdString(), "one");
        const std::string after = settled_beside("IMG_1.jpg");
        QCOMPARE(before != after, noticed);
        write_file(root_ / name.toStdString(), "two");
        QCOMPARE(after != settled_beside("IMG_1.jpg"), noticed);
    }

    void nobody_walks_into_links_to_folders() {
        fs::create_directories(root_ / "a" / "b");
        fs::create_directory(root_ / "elsewhere");
        fs::create_directory(root_ / ".secret");
        fs::create_directory_symlink(root_ / "elsewhere", root_ / "a" / "there");
        fs::create_directory_symlink(root_, root_ / "a" / "up");
        fs::create_directory_symlink(".", root_ / "a" / "here");
        fs::create_directory_symlink(root_ / ".secret", root_ / "a" / "secret");
        fs::create_symlink("nothing", root_ / "a" / "dangling.jpg");
        QCOMPARE(folders(root_ / "a"), std::vector<fs::path>{root_ / "a" / "b"});
        QCOMPARE(list_folder(root_ / "a").linked,
                 (std::vector<fs::path>{root_ / "a" / "here", root_ / "a" / "secret", root_ / "a" / "there",
                                        root_ / "a" / "up"}));
        QVERIFY(list_folder(root_ / "a").photos.empty());
        const ForeignFolder held(root_); // as a scan holds it
        QCOMPARE(folders(root_ / "a"), std::vector<fs::path>{root_ / "a" / "b"});
        QVERIFY(list_folder(root_ / "a" / "there").error == ELOOP);
    }

    void a_folder_that_is_not_there_is_said() {
        QCOMPARE(list_folder(root_ / "none").error, ENOENT);
        QCOMPARE(list_folder(root_).error, 0);
        QVERIFY(recordings_of(root_ / "none.jpg").empty());
    }
};

} // namespace folder_listing_test

TP_TEST(folder_listing_test, FolderListingTest, event_loop)
#include "folder_listing_test.moc"
