// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "app/album/metadata/xmp_packet.hpp"
#include "made_photo.hpp"
#include "photo_check.hpp"
#include "places.hpp"
#include "sidecar_check.hpp"
#include "svg_mutants.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t mutated_inputs = 10'000;
constexpr std::uint64_t seed = 20260501;

std::vector<Seed> sidecars() { return corpus(tp::test::in_source("tests/app/album/metadata/corpus")); }
std::vector<Seed> regions() { return corpus(tp::test::in_source("tests/app/album/metadata/region_corpus")); }

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i)
        all += text;
    return all;
}

} // namespace

class HostileMetadata : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path photo_;

    using Complaint = std::function<std::string(std::string_view)>;

    static void mutate(const std::vector<Seed>& seeds, const Complaint& complaint_about) {
        for (const Seed& input : seeds) {
            const std::string complaint = complaint_about(input.text);
            QVERIFY2(complaint.empty(), (input.name + ": " + complaint).c_str());
        }
        Mutator mutator(seed);
        for (std::size_t i = 0; i < mutated_inputs; ++i) {
            const std::string text = mutator.mutant(seeds);
            const std::string complaint = complaint_about(text);
            QVERIFY2(complaint.empty(), (complaint + ": " + text).c_str());
        }
    }

private slots:
    void init() {
        photo_ = fs::path(dir_.path().toStdString()) / "IMG_1.jpg";
        write_bytes(photo_, jpeg_bytes(400, 300));
    }
    void cleanup() { QCOMPARE(bytes_of(photo_), jpeg_bytes(400, 300)); }

    void mutated_sidecars() { mutate(sidecars(), complaint_about_sidecar); }
    void mutated_regions() { mutate(regions(), complaint_about_regions); }

    void photo_corpus() {
        const std::vector<Seed> photos = corpus(tp::test::in_source("tests/app/album/metadata/photo_corpus"));
        QVERIFY(photos.size() >= 6);
        for (const Seed& input : photos) {
            const std::string complaint = complaint_about_photo(input.text);
            QVERIFY2(complaint.empty(), (input.name + ": " + complaint).c_str());
        }
    }

    void a_gigabyte_is_refused_by_its_size() {
        const fs::path sidecar = photo_.string() + ".xmp";
        write_bytes(sidecar, "<rdf:RDF>");
        fs::resize_file(sidecar, std::uintmax_t{1} << 30); // sparse
        QCOMPARE(read_record(photo_)->problems.size(), std::size_t{1});
        QVERIFY(!write_sidecar(photo_, SidecarChanges{}).empty());
        QCOMPARE(fs::file_size(sidecar), std::uintmax_t{1} << 30);
        fs::remove(sidecar);
    }

    void half_a_gigabyte_in_a_photo_is_refused_by_its_size() {
        constexpr std::uintmax_t half_a_gigabyte = std::uintmax_t{1} << 29; // sparse
        const std::string png = png_bytes(400, 300);
        const std::size_t before_data = 33; // signature and IHDR
        const std::string chunk("\x20\0\0\0iTXtXML:com.adobe.xmp\0\0\0\0\0<", 31);
        const fs::path file = photo_.parent_path() / "a.png";
        write_bytes(file, png.substr(0, before_data) + chunk);
        fs::resize_file(file, half_a_gigabyte + 100);
        QCOMPARE(read_record(file)->problems.size(), std::size_t{1});

        write_bytes(file, std::string("RIFF\0\0\0\x20WEBPXMP \0\0\0\x20", 20));
        fs::resize_file(file, half_a_gigabyte + 100);
        QCOMPARE(read_record(file)->problems.size(), std::size_t{1});

        write_bytes(file, std::string("II*\0\x08\0\0\0\x01\0\xBC\x02\x01\0\0\0\0\x20\x20\0\0\0\0\0\0\0", 26));
        fs::resize_file(file, half_a_gigabyte + 100);
        QCOMPARE(read_record(file)->problems.size(), std::size_t{1});

        write_bytes(file, std::string("\0\0\0\x18"
                                      "ftypheic\0\0\0\0mif1heic",
                                      24));
        fs::resize_file(file, half_a_gigabyte);
        QCOMPARE(read_record(file)->problems.size(), std::size_t{1});
        fs::remove(file);
    }

    void deep_nesting() {
        for (const int depth : {50, 1'000, 100'000}) {
            for (const auto& [open, close] : std::vector<std::pair<std::string, std::string>>{
                     {"<f:a>", "</f:a>"},
                     {"<f:a><rdf:Description>", "</rdf:Description></f:a>"},
                     {"<f:a rdf:parseType='Resource'>", "</f:a>"}}) {
                const std::string text =
                    packet("xmlns:f='f/'", repeated(open, depth) + repeated(close, depth));
                QCOMPARE(complaint_about_sidecar(text), std::string());
                QVERIFY(depth < 100 || !XmpPacket::from(text).ok());
            }
            QVERIFY(!XmpPacket::from(repeated("<a>", depth)).ok());
            QVERIFY(!XmpPacket::from(repeated("<!DOCTYPE x [", depth)).ok());
        }
    }

    void a_photo_whose_xmp_is_deep_or_laughs() {
        const auto jpeg_with = [](const std::string& xmp) {
            const std::string data = std::string("http://ns.adobe.com/xap/1.0/\0", 29) + xmp;
            const std::size_t size = data.size() + 2;
            const std::string bytes = jpeg_bytes(400, 300);
            return bytes.substr(0, 2) + "\xFF\xE1" + static_cast<char>(size >> 8) +
                   static_cast<char>(size & 0xFF) + data + bytes.substr(2);
        };
        std::string laughs = "<!DOCTYPE x [<!ENTITY a0 \"ha\">";
        for (int i = 1; i < 30; ++i) {
            const std::string before = "&a" + std::to_string(i - 1) + ";";
            laughs.append("<!ENTITY a")
                .append(std::to_string(i))
                .append(" \"")
                .append(repeated(before, 4))
                .append("\">");
        }
        const fs::path file = photo_.parent_path() / "hostile.jpg";
        for (const std::string& xmp :
             {packet("xmlns:f='f/'", repeated("<f:a>", 5'000) + repeated("</f:a>", 5'000)),
              laughs + "]>" + packet("photoshop:City='&a29;'", ""),
              packet("photoshop:City='a", "").substr(0, 500)}) {
            write_bytes(file, jpeg_with(xmp));
            const auto read = read_record(file);
            QVERIFY(read.ok());
            QCOMPARE(read->width, 400LL);
            QVERIFY(read->place_name.size() < 100);
        }
        fs::remove(file);
    }

    void more_entries_than_any_program_writes() {
        std::string attributes = "xmlns:f='f/'";
        for (int i = 0; i < 20'000; ++i)
            attributes.append(" f:a").append(std::to_string(i)).append("='1'");
        QVERIFY(!XmpPacket::from(packet(attributes, "")).ok());
        QVERIFY(!XmpPacket::from(packet("xmlns:f='f/'", repeated("<f:a/>", 20'000))).ok());
    }

    /// A reader whose work grows with the square of their number takes minutes; one that keeps each, half a gigabyte.
    void sixteen_megabytes_of_one_thing_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<std::string>("says");
        const auto list = [](const std::string& property, const char* item, int times) {
            std::string text = "<";
            text.append(property).append("><rdf:Bag>").append(repeated(item, times));
            return packet("", text.append("</rdf:Bag></").append(property).append(">"));
        };
        const std::string many = "it has more entries than any program writes.",
                          listed = "it lists more people, words or recordings than any photograph has.";
        QTest::newRow("elements") << packet("xmlns:f='f/'", repeated("<f:a/>", 2'500'000)) << many;
        QTest::newRow("instructions") << packet("", repeated("<?a?>", 3'000'000)) << many;
        QTest::newRow("attributes") << packet("xmlns:f='f/'", "<f:a " + repeated("a='' ", 3'000'000) + "/>")
                                    << many;
        QTest::newRow("quotation marks")
            << packet("photoshop:City='" + std::string(10'000'000, '"') + "'", "") << std::string();
        for (const char* property : {"dc:subject", "Iptc4xmpExt:PersonInImage", "dc:description", "tp:tags",
                                     "digiKam:TagsList", "lr:hierarchicalSubject"})
            QTest::newRow(property) << list(property, "<rdf:li>a</rdf:li>", 20'001) << listed;
        QTest::newRow("faces") << packet(
                                      "",
                                      "<mwg-rs:Regions><rdf:Description><mwg-rs:RegionList><rdf:Bag>" +
                                          repeated("<rdf:li>a</rdf:li>", 20'001) +
                                          "</rdf:Bag></mwg-rs:RegionList></rdf:Description></mwg-rs:Regions>")
                               << listed;
        QTest::newRow("dabs of a brush")
            << list("photoshop:Dabs", "<rdf:li>d 0.123456 0.654321</rdf:li>\n", 400'000) << std::string();
        QTest::newRow("keywords of a large album")
            << list("dc:subject", "\n  <rdf:li>holiday</rdf:li>", 9'999) << std::string();
    }
    void sixteen_megabytes_of_one_thing() {
        QFETCH(std::string, text);
        QFETCH(std::string, says);
        const auto packet = XmpPacket::from(text);
        QCOMPARE(packet ? std::string() : packet.error(), says);
    }

    void damaged_photos_of_every_kind() {
        const fs::path file = photo_.parent_path() / "damaged";
        MadeMetadata made;
        made.exif["Exif.Photo.DateTimeOriginal"] = "2026:05:01 10:15:00";
        made.exif["Exif.GPSInfo.GPSLatitude"] = "48/1 12/1 3000/100";
        made.exif["Exif.GPSInfo.GPSLongitude"] = "16/1 30/1 0/1";
        made.iptc["Iptc.Application2.City"] = "Graz";
        made.xmp = packet("photoshop:City='Graz'", "");
        std::vector<Seed> seeds;
        for (const std::string& bytes :
             {jpeg_bytes(400, 300), png_bytes(400, 300), tiff_bytes(400, 300), webp_bytes()}) {
            write_bytes(file, bytes);
            add_metadata(file, made);
            seeds.push_back({"", bytes_of(file)});
        }
        Mutator mutator(seed);
        std::size_t dated = 0;
        for (int i = 0; i < 2'000; ++i) {
            write_bytes(file, mutator.mutant(seeds));
            const auto read = read_record(file);
            QVERIFY(read.ok());
            dated += read->taken.empty() ? 0 : 1;
        }
        QVERIFY2(dated > 500, std::to_string(dated).c_str());
        fs::remove(file);
    }
};

QTEST_GUILESS_MAIN(HostileMetadata)
#include "hostile_test.moc"
