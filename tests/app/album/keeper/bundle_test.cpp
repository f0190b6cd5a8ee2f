// SPDX-License-Identifier: Apache-2.0
#include "album_folder.hpp"
#include "app/album/keeper/bundle.hpp"
#include "made_zip.hpp"
#include "places.hpp"

#include <QDir>
#include <QTest>

#include <random>

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

class BundleTest : public QObject {
    Q_OBJECT

private slots:
    void what_is_packed_comes_out_the_same() {
        const AlbumFolder album, out;
        std::vector<fs::path> photos;
        for (const std::string& name :
             {std::string("a.jpg"), std::string("2026/Mai/ä 👵.png"), std::string("2026/J\xF6rg%.jpg")}) {
            photos.push_back(album.write(name, "photo " + name));
            album.write(name + ".xmp", "sidecar");
            album.write(name + ".tags/1.flac", std::string(70'000, 'f') + name);
            album.write(name + ".tags/2.flac", "");
        }
        const auto packed = album.files();
        album.write("not named.jpg", "stays");
        album.write("a.jpg.tags/.touchphoto-1-1.tmp", "half");
        std::uintmax_t done = 0, total = 0;
        const auto report = [&](std::uintmax_t now, std::uintmax_t all) {
            QVERIFY(now >= done);
            done = now;
            total = all;
        };
        const fs::path bundle = out / "family.touchphoto";
        QCOMPARE(write_bundle(bundle, album.path(), photos, report), std::string());
        QCOMPARE(done, total);
        QVERIFY(total > 210'000);
        const AlbumFolder unpacked;
        QCOMPARE(unpack_bundle(bundle, unpacked.path()), std::string());
        QVERIFY(unpacked.files() == packed);
    }

    void hostile_bundles_are_refused_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<unsigned>("type");
        QTest::addColumn<QByteArray>("link");
        QTest::newRow("climbs out") << QByteArray("../evil.jpg") << unsigned(AE_IFREG) << QByteArray();
        QTest::newRow("climbs out deep")
            << QByteArray("a/../../evil.jpg") << unsigned(AE_IFREG) << QByteArray();
        QTest::newRow("absolute") << QByteArray("/tmp/evil.jpg") << unsigned(AE_IFREG) << QByteArray();
        QTest::newRow("back slashes") << QByteArray("..\\evil.jpg") << unsigned(AE_IFREG) << QByteArray();
        QTest::newRow("hidden in percent")
            << QByteArray("%:..%2Fevil.jpg") << unsigned(AE_IFREG) << QByteArray();
        QTest::newRow("link") << QByteArray("a.jpg") << unsigned(AE_IFLNK) << QByteArray("/etc/passwd");
        QTest::newRow("folder outside") << QByteArray("../evil") << unsigned(AE_IFDIR) << QByteArray();
    }

    void hostile_bundles_are_refused() {
        QFETCH(QByteArray, name);
        QFETCH(unsigned, type);
        QFETCH(QByteArray, link);
        const AlbumFolder place;
        write_zip(place / "b", {{"fine.jpg"}, {name.toStdString(), "x", type, link.toStdString()}});
        const std::string problem = unpack_bundle(place / "b", place / "inner/folder");
        QVERIFY2(problem.starts_with("The bundle ") && problem.ends_with('.'), problem.c_str());
        QVERIFY(!fs::exists(place / "evil.jpg") && !fs::exists(place / "inner/evil.jpg"));
        for (const auto& file : fs::recursive_directory_iterator(place.path()))
            QVERIFY(!file.is_symlink());
    }

    void what_is_packed_in_an_unusual_way_is_refused_data() {
        QTest::addColumn<QString>("bundle");
        const QDir corpus(in_source("tests/app/album/keeper/bundle_corpus"));
        for (const char* name : {"lzma", "lzma_asks_for_4_gigabyte", "bzip2"})
            QTest::newRow(name) << corpus.filePath(name);
    }
    void what_is_packed_in_an_unusual_way_is_refused() {
        QFETCH(QString, bundle);
        const AlbumFolder place;
        const std::string problem = unpack_bundle(bundle.toStdString(), place / "album");
        QVERIFY2(problem.find("is packed in an unusual way") != std::string::npos, problem.c_str());
        QVERIFY(fs::is_empty(place / "album"));
    }

    void a_bomb_goes_off_small() {
        const AlbumFolder place;
        write_zip(place / "bomb", {{"a.jpg", std::string(30'000'000, '\0')}});
        QVERIFY(fs::file_size(place / "bomb") < 100'000);
        const std::string problem = unpack_bundle(place / "bomb", place / "out");
        QVERIFY2(problem.find("too large") != std::string::npos, problem.c_str());
        BundleLimits limits;
        limits.most_growth = 1e9;
        limits.most_bytes = 1'000'000;
        QVERIFY(!unpack_bundle(place / "bomb", place / "out2", limits).empty());
        std::vector<ZipEntry> many;
        for (int i = 0; i < 20; ++i)
            many.push_back({std::to_string(i), ""});
        write_zip(place / "many", many);
        limits.most_files = 10;
        QVERIFY(unpack_bundle(place / "many", place / "out3", limits).find("more files") !=
                std::string::npos);
        std::string deep = "a.jpg";
        for (int i = 0; i < 100; ++i)
            deep.insert(0, "a/");
        write_zip(place / "deep", {{deep}});
        QVERIFY(unpack_bundle(place / "deep", place / "out5").find("more folders") != std::string::npos);
        QVERIFY(!fs::exists(place / "out5/a"));
        write_zip(place / "twice", {{"a", "first"}, {"a", "second"}});
        QVERIFY(unpack_bundle(place / "twice", place / "out4").find("already") != std::string::npos);
        QCOMPARE(place.read("out4/a"), std::string("first"));
    }

    void damaged_bundles_are_refused_or_whole() {
        const AlbumFolder album, place;
        const auto photo = album.write("a.jpg", std::string(20'000, 'p') + "end");
        album.write("a.jpg.tags/1.flac", std::string(20'000, 's'));
        QCOMPARE(write_bundle(place / "b", album.path(), {photo}), std::string());
        const std::string whole = place.read("b");
        std::mt19937 random(7);
        int refused = 0;
        for (int i = 0; i < 300; ++i) {
            std::string bytes = whole;
            if (i % 3 == 0)
                bytes.resize(random() % bytes.size());
            else
                for (int k = 0; k < 3; ++k)
                    bytes[random() % bytes.size()] = static_cast<char>(random());
            place.write("damaged", bytes);
            const fs::path out = place / ("out" + std::to_string(i));
            const std::string problem = unpack_bundle(place / "damaged", out);
            refused += !problem.empty();
            if (problem.empty() &&
                fs::exists(out / "a.jpg")) // a name or a comment was hit, or nothing that counts
                QCOMPARE(fs::file_size(out / "a.jpg"), std::uintmax_t{20'003});
            fs::remove_all(out);
        }
        QVERIFY(refused > 200);
    }

    void what_cannot_be_packed_is_said_and_leaves_the_old_bundle() {
        const AlbumFolder album, place;
        place.write("b", "old");
        const auto outside = place.write("c.jpg", "x");
        const auto photo = album.write("a.jpg", std::string(200'000, 'p'));
        QVERIFY(!write_bundle(place / "b", album.path(), {album / "missing.jpg"}).empty());
        QVERIFY(!write_bundle(place / "b", album.path(), {outside}).empty());
        QVERIFY(!write_bundle(place / "b", album.path(), {}).empty());
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!write_bundle(place / "b", album.path(), {photo}, {}, stop.get_token()).empty());
        QCOMPARE(place.read("b"), std::string("old"));
        QCOMPARE(place.files().size(), std::size_t{2});
        QVERIFY(!write_bundle(place / "no folder" / "b", album.path(), {photo}).empty());
        QVERIFY(!unpack_bundle(place / "b", place / "out").empty());
        QVERIFY(!unpack_bundle(place / "missing", place / "out2").empty());
        QVERIFY(!unpack_bundle(place / "b", place.path()).empty());
    }
};

QTEST_GUILESS_MAIN(BundleTest)
#include "bundle_test.moc"
