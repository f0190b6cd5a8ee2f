// SPDX-License-Identifier: Apache-2.0
// What touchphoto-decoder reads of photographs' metadata, against the same files read in this process; and what comes of a
// file that ends it.
#include "app/album/metadata/photo_metadata.hpp"
#include "core/processes/foreign_decoder.hpp"
#include "corpus.hpp"
#include "faces/exiv2/stated_metadata.hpp"
#include "made_photo.hpp"
#include "places.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

/// While one lives, this program reads in helpers.
class InHelpers {
public:
    explicit InHelpers(ForeignDecoders& decoders) { decode_in_helpers(&decoders); }
    ~InHelpers() { decode_in_helpers(nullptr); }
    InHelpers(const InHelpers&) = delete;
    InHelpers& operator=(const InHelpers&) = delete;
};

std::optional<StatedMetadata> stated(const fs::path& file) {
    return stated_metadata(OpenFile(file, OpenMode{}));
}

} // namespace

class StatedMetadataTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    ForeignDecoders decoders_{qEnvironmentVariable("TP_DECODER").toStdString()};

    fs::path path(const std::string& name) const { return fs::path(dir_.path().toStdString()) / name; }
    fs::path written(const std::string& name, const std::string& bytes) const {
        write_bytes(path(name), bytes);
        return path(name);
    }
    /// Says of all that can be said, in so many bytes of XMP and so many words.
    fs::path made(const std::string& name, std::size_t xmp_bytes, int keywords) const {
        MadeMetadata all;
        all.exif["Exif.Photo.DateTimeOriginal"] = "2026:05:01 10:15:00";
        all.exif["Exif.Photo.OffsetTimeOriginal"] = "+02:00";
        all.exif["Exif.Image.Orientation"] = std::uint16_t{6};
        all.exif["Exif.GPSInfo.GPSLatitude"] = "48/1 30/1 0/1";
        all.exif["Exif.GPSInfo.GPSLatitudeRef"] = "S";
        all.exif["Exif.GPSInfo.GPSLongitude"] = "16/1 15/1 0/1";
        all.exif["Exif.GPSInfo.GPSLongitudeRef"] = "E";
        all.iptc["Iptc.Application2.Caption"] = "Gr\xFC\xDF"
                                                "e";
        all.iptc["Iptc.Application2.City"] = "Graz";
        all.iptc["Iptc.Application2.CountryName"] = "Austria";
        all.iptc["Iptc.Application2.DateCreated"] = "1999-12-31";
        all.iptc["Iptc.Application2.TimeCreated"] = "23:59:58+01:00";
        for (int i = 0; i < keywords; ++i) {
            Exiv2::StringValue value("word " + std::to_string(i));
            all.iptc.add(Exiv2::IptcKey("Iptc.Application2.Keywords"), &value);
        }
        all.xmp = packet("", "<dc:source>" + std::string(xmp_bytes, 'x') + "</dc:source>");
        const fs::path file = written(name, jpeg_bytes(400, 300));
        add_metadata(file, all);
        return file;
    }

private slots:
    void it_reads_the_same_data() {
        QTest::addColumn<QString>("file");
        const auto row = [](const std::string& name, const fs::path& file) {
            QTest::newRow(name.c_str()) << QString::fromStdString(file.string());
        };
        for (const Seed& seed : corpus(in_source("tests/app/album/metadata/photo_corpus")))
            row(seed.name, written(seed.name, seed.text));
        for (const Seed& seed : corpus(in_source("tests/faces/decode/corpus")))
            row("picture " + seed.name, written("picture " + seed.name, seed.text));
        row("HEIC", written("a.heic", heic_bytes(400, 300, packet("", "<dc:source>phone</dc:source>"))));
        row("everything", made("all.jpg", 100, 2));
        row("a packet longer than a message", made("long.jpg", 60'000, 2'000));
        row("text", written("text.jpg", "text"));
        row("nothing", written("empty.jpg", ""));
    }
    void it_reads_the_same() {
        QFETCH(QString, file);
        const auto here = stated(file.toStdString());
        const InHelpers in_helpers(decoders_);
        QVERIFY(stated(file.toStdString()) == here);
    }

    void everything_is_there() {
        const InHelpers in_helpers(decoders_);
        const auto said = stated(made("all.jpg", 60'000, 3'000));
        QVERIFY(said);
        QCOMPARE(said->width, std::int64_t{400});
        QCOMPARE(said->orientation.value_or(0), 6);
        QCOMPARE(said->latitude.value_or(0.0), -48.5);
        QCOMPARE(said->longitude.value_or(0.0), 16.25);
        QCOMPARE(said->taken, std::string("2026:05:01 10:15:00"));
        QCOMPARE(said->keywords.size(), std::size_t{3'000});
        QCOMPARE(said->places, (std::vector<std::string>{"Graz", "Austria"}));
        QVERIFY(said->xmp.size() > 60'000);
    }

    void no_more_words_than_any_person_gives() {
        const InHelpers in_helpers(decoders_);
        const auto said = stated(made("words.jpg", 10, 10'500));
        QVERIFY(said);
        QCOMPARE(said->keywords.size(), std::size_t{10'000});
        QCOMPARE(said->keywords.back(), std::string("word 9999"));
    }

    void a_file_that_ends_the_decoder_is_one_sentence() {
        const fs::path file = made("ends.jpg", 10, 1);
        ForeignDecoders ending(in_build("tests/faces/decode/ending_decoder"));
        const InHelpers in_helpers(ending);
        for (int i = 0; i < 3; ++i) {
            const auto metadata = photo_metadata(file);
            QVERIFY(metadata.ok());
            QCOMPARE(metadata->parts.problems,
                     std::vector<std::string>{"The metadata of the photograph \"" + file.string() +
                                              "\" cannot be read."});
        }
        decode_in_helpers(&decoders_);
        QVERIFY(photo_metadata(file)->parts.problems.empty());
    }

    void without_a_decoder_it_is_read_here() {
        const fs::path file = made("here.jpg", 10, 1);
        ForeignDecoders none(path("no decoder"));
        const InHelpers in_helpers(none);
        QCOMPARE(photo_metadata(file)->shape.orientation, 6);
    }

    void threads_have_a_decoder_each() {
        const fs::path file = made("threads.jpg", 40'000, 2'000);
        const auto here = stated(file);
        const InHelpers in_helpers(decoders_);
        std::atomic<int> right = 0;
        std::vector<std::thread> threads;
        for (int t = 0; t < 4; ++t)
            threads.emplace_back([&] {
                for (int i = 0; i < 50; ++i)
                    right += stated(file) == here ? 1 : 0;
            });
        for (std::thread& thread : threads)
            thread.join();
        QCOMPARE(right.load(), 200);
    }
};

QTEST_APPLESS_MAIN(StatedMetadataTest)
#include "stated_metadata_test.moc"
