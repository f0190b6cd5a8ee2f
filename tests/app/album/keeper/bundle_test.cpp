// SPDX-License-Identifier: Apache-2.0
#include "album_folder.hpp"
#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/importer.hpp"
#include "core/files/file_words.hpp"
#include "made_zip.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QDir>
#include <QProcess>
#include <QTest>

#include <chrono>
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <iterator>
#include <random>
#include <set>
#include <sys/resource.h>

namespace bundle_test {

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

    void hard_names_come_back_in_every_locale_data() {
        QTest::addColumn<QByteArray>("locale");
        for (const char* locale : {"C", "C.UTF-8", "en_US.ISO-8859-1"})
            QTest::newRow(locale) << QByteArray(locale);
    }
    void hard_names_come_back_in_every_locale() {
        QFETCH(QByteArray, locale);
        const std::string before = std::setlocale(LC_ALL, nullptr);
        // Debian has it as a source; C and C.UTF-8 are part of the C library, wherever it looks for others.
        const AlbumFolder locales;
        const QString made = QString::fromStdString((locales / "en_US.ISO-8859-1").string());
        QCOMPARE(QProcess::execute("localedef", {"--no-archive", "-i", "en_US", "-f", "ISO-8859-1", made}),
                 0);
        qputenv("LOCPATH", locales.path().c_str());
        QVERIFY(std::setlocale(LC_ALL, locale.constData()) != nullptr);
        const AlbumFolder album;
        std::vector<fs::path> photos;
        const std::vector<std::string> names{"\u00E9",
                                             "e\u0301", // one letter, and the same in two: another file
                                             "\u00E9/e\u0301",
                                             "e\u0301/\u00E9",
                                             "\u1E9B\u0323",
                                             "\u1E69",
                                             "s\u0323\u0307",
                                             "s\u0307\u0323",
                                             "\u212B",
                                             "\u00C5",
                                             "A\u030A",
                                             "\uAC00",
                                             "\u1100\u1161",
                                             "\u0958",
                                             "\u0915\u093C",
                                             "a\\b",
                                             "a\\..\\b",
                                             "\\",
                                             "C:\\a",
                                             "c:a",
                                             "%",
                                             "%:a",
                                             "%41",
                                             "a%2Fb",
                                             "100 %",
                                             "a b",
                                             " a",
                                             "a ",
                                             "a\nb",
                                             "a\tb",
                                             "a\x1B[31mb",
                                             "\xFF",
                                             "\xC3",
                                             "J\xF6rg",
                                             "\xED\xA0\x80",
                                             "\u202Eabc",
                                             "\u0645\u0631\u062D\u0628\u0627",
                                             "\U0001F475\U0001F3FD",
                                             "*?\"<>|",
                                             "con",
                                             "a.",
                                             "-rf",
                                             "~",
                                             "$HOME",
                                             "a'b",
                                             "a;b",
                                             "a..",
                                             "a/b/c",
                                             std::string(200, 'n')};
        for (const std::string& name : names) {
            photos.push_back(album.write(name + ".jpg", "photo " + name));
            album.write(name + ".jpg.xmp", "sidecar of " + name);
        }
        album.write(names.front() + ".jpg.tags/" + names[1] + ".flac", "sound");
        const auto packed = album.files();
        QVERIFY(packed.size() > 2 * 40);
        const AlbumFolder place, unpacked, imported;
        const std::string written = write_bundle(place / "b.touchphoto", album.path(), photos);
        const std::string read = unpack_bundle(place / "b.touchphoto", unpacked.path());
        const auto report = import_photos(imported.path(), {}, {place / "b.touchphoto"}, {});
        std::setlocale(LC_ALL, before.c_str());
        qunsetenv("LOCPATH");
        QCOMPARE(written, std::string());
        QCOMPARE(read, std::string());
        QVERIFY(unpacked.files() == packed);
        QVERIFY(report.ok());
        QCOMPARE(report->count(ImportedPhoto::Fate::imported), photos.size());
        auto in_album = imported.files();
        std::erase_if(in_album,
                      [](const auto& file) { return std::string(file.first).starts_with(".touchphoto"); });
        QVERIFY(in_album == packed);
    }

    void what_is_hidden_is_not_exported() {
        const AlbumFolder album, place;
        for (const char* const name : {".a.jpg", ".private/a.jpg", "b/.c/a.jpg"}) {
            const std::string problem = write_bundle(place / "b", album.path(), {album.write(name, "photo")});
            QVERIFY2(problem.find("is hidden") != std::string::npos, problem.c_str());
        }
        QVERIFY(!fs::exists(place / "b"));
    }

    /// As other programs unpack it: with the time of each file, for its owner only, and as it was.
    void a_bundle_says_when_each_file_was_written() {
        const AlbumFolder album, place;
        const auto photo = album.write("a.jpg", std::string(50'000, 'p'));
        album.write("a.jpg.xmp", "sidecar");
        constexpr std::time_t then = 1'600'000'000;
        for (const auto& file : {photo, album / "a.jpg.xmp"})
            fs::last_write_time(file, std::chrono::file_clock::from_sys(
                                          std::chrono::sys_seconds(std::chrono::seconds(then))));
        QCOMPARE(write_bundle(place / "b", album.path(), {photo}), std::string());
        archive* zip = archive_read_new();
        archive_read_support_format_zip_seekable(zip);
        QCOMPARE(archive_read_open_filename(zip, (place / "b").c_str(), 1 << 16), ARCHIVE_OK);
        archive_entry* entry = nullptr;
        int entries = 0;
        for (; archive_read_next_header(zip, &entry) == ARCHIVE_OK; ++entries) {
            QVERIFY(std::abs(archive_entry_mtime(entry) - then) <= 2); // ZIP counts in two seconds
            QCOMPARE(archive_entry_perm(entry) & 0777u, 0600u);
            QVERIFY(std::string(archive_format_name(zip)).ends_with("(uncompressed)"));
        }
        archive_read_free(zip);
        QCOMPARE(entries, 2);
    }

    void a_disk_that_is_full_leaves_no_half_bundle_and_no_half_photograph() {
        const AlbumFolder album, place;
        const auto photo = album.write("a.jpg", std::string(200'000, 'p'));
        QCOMPARE(write_bundle(place / "whole", album.path(), {photo}), std::string());
        const auto previous = std::signal(SIGXFSZ, SIG_IGN);
        struct rlimit before {};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        const struct rlimit small { 100'000, before.rlim_max };
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        const std::string packed = write_bundle(place / "b", album.path(), {photo});
        const std::string unpacked = unpack_bundle(place / "whole", place / "out");
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, previous);
        QVERIFY2(packed.starts_with("The bundle " + quoted(place / "b") + " was not written: ") &&
                     packed.ends_with('.'),
                 packed.c_str());
        QVERIFY2(
            unpacked.starts_with("The bundle " + quoted(place / "whole") + " cannot be used: \"a.jpg\": ") &&
                unpacked.ends_with('.'),
            unpacked.c_str());
        QVERIFY(fs::is_empty(place / "out"));
        QCOMPARE(place.files().size(), std::size_t{1});
    }

    void what_is_locked_with_a_password_is_said() {
        const AlbumFolder place;
        write_zip(place / "b", {{"a.jpg"}}, "zip:encryption=zipcrypt", "secret");
        QCOMPARE(unpack_bundle(place / "b", place / "out"),
                 "The bundle " + quoted(place / "b") + " cannot be used: it is locked with a password.");
        QVERIFY(fs::is_empty(place / "out"));
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
    }

    /// What shrinks to nothing is a bomb only beyond a megabyte: a page of one colour shrinks so too.
    void a_megabyte_may_have_shrunk_to_nothing() {
        const AlbumFolder place;
        write_zip(place / "small", {{"a.jpg", std::string(1'000'000, '\0')}});
        QVERIFY(fs::file_size(place / "small") < 5'000);
        QCOMPARE(unpack_bundle(place / "small", place / "out"), std::string());
        write_zip(place / "more", {{"a.jpg", std::string(1'100'000, '\0')}});
        QVERIFY(unpack_bundle(place / "more", place / "out2").find("too large") != std::string::npos);
        BundleLimits limits;
        limits.most_bytes = 1'000;
        write_zip(place / "just", {{"a.jpg", std::string(600, 'x')}, {"b.jpg", std::string(400, 'x')}});
        QCOMPARE(unpack_bundle(place / "just", place / "out3", limits), std::string());
        write_zip(place / "one_more", {{"a.jpg", std::string(600, 'x')}, {"b.jpg", std::string(401, 'x')}});
        QVERIFY(!unpack_bundle(place / "one_more", place / "out4", limits).empty());
        limits = {};
        limits.most_growth = 20.0; // stored, nothing grows
        write_zip(place / "stored", {{"a.jpg", std::string(3'000'000, 'x')}}, "zip:compression=store");
        QCOMPARE(unpack_bundle(place / "stored", place / "out5", limits), std::string());
    }

    void folders_may_lie_63_deep() {
        const AlbumFolder place;
        std::string deep = "a.jpg";
        for (int i = 0; i < 63; ++i)
            deep.insert(0, "a/");
        write_zip(place / "just", {{deep}});
        QCOMPARE(unpack_bundle(place / "just", place / "out"), std::string());
        QVERIFY(fs::exists(place / "out" / deep));
        write_zip(place / "more", {{"a/" + deep}});
        QVERIFY(unpack_bundle(place / "more", place / "out2").find("more folders") != std::string::npos);
    }

    void unpacking_that_is_stopped_says_so() {
        const AlbumFolder place;
        write_zip(place / "b", {{"a.jpg"}});
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(
            unpack_bundle(place / "b", place / "out", {}, {}, stop.get_token()).ends_with("it was stopped."));
        QVERIFY(fs::is_empty(place / "out"));
        std::stop_source later;
        const auto report = [&](std::uintmax_t, std::uintmax_t) { later.request_stop(); };
        write_zip(place / "large", {{"a.jpg", std::string(400'000, 'x')}}, "zip:compression=store");
        QVERIFY(unpack_bundle(place / "large", place / "out2", {}, report, later.get_token())
                    .ends_with("it was stopped."));
        QVERIFY(!fs::exists(place / "out2/a.jpg"));
    }

    void only_what_belongs_to_photographs_is_unpacked() {
        const AlbumFolder place;
        const std::vector<std::string> parts{"a.jpg",
                                             "a.jpg.xmp",
                                             "a.xmp",
                                             "a.jpg.contours.svg",
                                             "a.jpg.tags/1.flac",
                                             "A.WAV",
                                             "a.mov",
                                             "a.jpg.sync-conflict-20260501-101500-ABCDEFG.xmp",
                                             "2026/b.c.HEIC",
                                             "2026/b.c.mp4"};
        const std::vector<std::string> foreign{"a.txt",
                                               "readme",
                                               "b.xmp",
                                               "2026/a.xmp",
                                               "c.jpg.tags/1.flac",
                                               "a.jpg.exe",
                                               "a.jpg.tags/deeper/1.flac",
                                               ".hidden/d.jpg",
                                               ".e.jpg",
                                               "a.jpgs/1.flac"};
        std::vector<ZipEntry> entries;
        for (const auto* names : {&foreign, &parts})
            for (const std::string& name : *names)
                entries.push_back({name});
        entries.push_back({"empty", "", AE_IFDIR});
        write_zip(place / "b", entries);
        const AlbumFolder out;
        QCOMPARE(unpack_bundle(place / "b", out.path()), std::string());
        std::set<std::string> came;
        for (const auto& file : fs::recursive_directory_iterator(out.path()))
            if (!file.is_directory())
                came.insert(file.path().lexically_relative(out.path()).string());
        QCOMPARE(came, std::set<std::string>(parts.begin(), parts.end()));
        QVERIFY(!fs::exists(out / "empty"));
    }

    void names_that_are_there_twice_are_refused() {
        const AlbumFolder place;
        const std::vector<std::vector<ZipEntry>> bundles{
            {{"a.jpg", "first"}, {"a.jpg", "second"}},
            {{"a.jpg"}, {"foreign"}, {"foreign"}},
            {{"a.jpg"}, {"b"}, {"b", "", AE_IFDIR}},
            {{"a.jpg"}, {"b", "", AE_IFDIR}, {"b"}},
        };
        for (std::size_t i = 0; i < bundles.size(); ++i) {
            write_zip(place / "twice", bundles[i]);
            const fs::path out = place / ("out" + std::to_string(i));
            const std::string problem = unpack_bundle(place / "twice", out);
            QVERIFY2(problem.ends_with(" twice."), problem.c_str());
            QVERIFY(fs::is_empty(out));
        }
    }

    /// Known by what is written, which is nothing, and by what is told of the bytes read.
    void a_hundred_thousand_foreign_files_are_passed_over() {
        const AlbumFolder place;
        std::vector<ZipEntry> many;
        for (int i = 0; i < 100'000; ++i)
            many.push_back({"papers/" + std::to_string(i) + ".txt"});
        write_zip(place / "many", many, "zip:compression=store");
        int reports = 0;
        const auto report = [&](std::uintmax_t, std::uintmax_t) { ++reports; };
        const std::string problem = unpack_bundle(place / "many", place / "out", {}, report);
        QCOMPARE(problem,
                 "The bundle " + quoted(place / "many") + " cannot be used: it holds no photograph.");
        QVERIFY(fs::is_empty(place / "out"));
        many.push_back({"a.jpg"});
        write_zip(place / "one", many, "zip:compression=store");
        QCOMPARE(unpack_bundle(place / "one", place / "out1", {}, report), std::string());
        QCOMPARE(reports, 1);
        QCOMPARE(std::distance(fs::recursive_directory_iterator(place / "out1"), {}), 1);
    }

    void a_bundle_may_hold_so_many_files_and_no_more() {
        const AlbumFolder place;
        BundleLimits limits;
        limits.most_files = 10;
        std::vector<ZipEntry> some{{"a.jpg"}, {"b", "", AE_IFDIR}};
        while (some.size() < limits.most_files)
            some.push_back({std::to_string(some.size())});
        write_zip(place / "just", some);
        QCOMPARE(unpack_bundle(place / "just", place / "out", limits), std::string());
        some.push_back({"one more"});
        write_zip(place / "more", some);
        const std::string problem = unpack_bundle(place / "more", place / "out2", limits);
        QVERIFY2(problem.ends_with("it holds more files than any album."), problem.c_str());
        QVERIFY(fs::is_empty(place / "out2"));
    }

    /// libarchive would keep each of them in memory before it gave the first file.
    void a_directory_of_more_files_than_any_album_is_not_read() {
        const AlbumFolder folder;
        const fs::path bundle = folder / "many.zip";
        write_zip(bundle, {{"a", "x"}}, "zip:compression=store");
        const std::string zip = folder.read("many.zip");
        const std::size_t directory = zip.find("PK\x01\x02"), end = zip.find("PK\x05\x06");
        std::string many = zip.substr(0, directory);
        std::string entry = zip.substr(directory, end - directory);
        for (std::size_t i = 0; i < 100'000; ++i) {
            entry[42] = static_cast<char>(i); // where in the file it says that it lies
            entry[43] = static_cast<char>(i >> 8);
            entry[44] = static_cast<char>(i >> 16);
            many += entry;
        }
        const auto size = many.size() - directory;
        std::string last = zip.substr(end);
        for (std::size_t i = 0; i < 4; ++i)
            last[12 + i] = static_cast<char>(size >> (8 * i));
        folder.write("many.zip", many + last);
        BundleLimits limits;
        limits.most_files = 1'000;
        const AlbumFolder out;
        const std::string problem = unpack_bundle(bundle, out.path(), limits);
        QVERIFY2(problem.find("more files than any album") != std::string::npos, problem.c_str());
        QVERIFY(out.files().empty());
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

} // namespace bundle_test

TP_TEST(bundle_test, BundleTest, event_loop)
#include "bundle_test.moc"
