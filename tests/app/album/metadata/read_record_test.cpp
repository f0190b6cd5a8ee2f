// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/time_text.hpp"
#include "made_photo.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <initializer_list>

namespace read_record_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

const std::string regions_start = "<mwg-rs:Regions rdf:parseType='Resource'>";

std::string region(const std::string& area, const std::string& rest) {
    return "<rdf:li><rdf:Description " + rest + "><mwg-rs:Area " + area + "/></rdf:Description></rdf:li>";
}

std::string regions(const std::string& applied_to, const std::string& list) {
    return regions_start + (applied_to.empty() ? "" : "<mwg-rs:AppliedToDimensions " + applied_to + "/>") +
           "<mwg-rs:RegionList><rdf:Bag>" + list + "</rdf:Bag></mwg-rs:RegionList></mwg-rs:Regions>";
}

bool close(const FaceRegion& a, const FaceRegion& b) {
    return std::abs(a.x - b.x) < 1e-9 && std::abs(a.y - b.y) < 1e-9 && std::abs(a.width - b.width) < 1e-9 &&
           std::abs(a.height - b.height) < 1e-9 && a.name == b.name;
}

} // namespace

class ReadRecordTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path photo_;

    PhotoRecord record() const {
        const std::string before = fs::exists(photo_) ? bytes_of(photo_) : "";
        auto read = read_record(photo_);
        if (!read)
            qWarning("%s", read.error().c_str());
        if (bytes_of(photo_) != before)
            qFatal("the photograph's bytes changed");
        return read ? *read : PhotoRecord{};
    }
    void sidecar(const std::string& name, const std::string& text) const {
        write_bytes(photo_.parent_path() / name, text);
    }

private slots:
    void init() {
        const fs::path folder = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(folder);
        photo_ = folder / "IMG_1.jpg";
        write_bytes(photo_, jpeg_bytes(400, 300));
    }

    void cleanup() { fs::remove_all(photo_.parent_path()); } // Qt cannot remove names that are not UTF-8

    void a_photo_that_says_nothing() {
        const PhotoRecord read = record();
        PhotoRecord expected;
        expected.width = 400;
        expected.height = 300;
        QVERIFY(read == expected);
    }

    void exif_date_place_and_orientation() {
        MadeMetadata made;
        made.exif["Exif.Photo.DateTimeOriginal"] = "2026:05:01 10:15:00";
        made.exif["Exif.Photo.SubSecTimeOriginal"] = "123";
        made.exif["Exif.Photo.OffsetTimeOriginal"] = "+02:00";
        made.exif["Exif.Image.Orientation"] = std::uint16_t{6};
        made.exif["Exif.GPSInfo.GPSLatitude"] = "48/1 12/1 3000/100";
        made.exif["Exif.GPSInfo.GPSLatitudeRef"] = "S";
        made.exif["Exif.GPSInfo.GPSLongitude"] = "16/1 30/1 0/1";
        made.exif["Exif.GPSInfo.GPSLongitudeRef"] = "W";
        add_metadata(photo_, made);
        const PhotoRecord read = record();
        QCOMPARE(read.taken, std::string("2026-05-01T10:15:00+02:00"));
        QCOMPARE(read.orientation, 6);
        QVERIFY(read.place.has_value());
        QVERIFY(std::abs(read.place->latitude + 48.0 + 12.0 / 60.0 + 30.0 / 3600.0) < 1e-9);
        QVERIFY(std::abs(read.place->longitude + 16.5) < 1e-9);
        QVERIFY(read.problems.empty());
    }

    void exif_that_makes_no_sense_is_left_out() {
        MadeMetadata made;
        made.exif["Exif.Photo.DateTimeOriginal"] = "2026:02:30 10:15:00";
        made.exif["Exif.Image.Orientation"] = std::uint16_t{77};
        made.exif["Exif.GPSInfo.GPSLatitude"] = "99/1 12/1 0/0";
        made.exif["Exif.GPSInfo.GPSLongitude"] = "16/1 30/1 0/1";
        add_metadata(photo_, made);
        const PhotoRecord read = record();
        QCOMPARE(read.taken, std::string());
        QCOMPARE(read.orientation, 1);
        QVERIFY(!read.place);
    }

    void iptc_of_an_old_program() {
        MadeMetadata made;
        made.iptc["Iptc.Application2.Caption"] = "Gr\xFC\xDF"
                                                 "e"; // Latin-1
        made.iptc["Iptc.Application2.City"] = "Graz";
        made.iptc["Iptc.Application2.CountryName"] = "Austria";
        made.iptc["Iptc.Application2.DateCreated"] = "1999-12-31";
        made.iptc["Iptc.Application2.TimeCreated"] = "23:59:58+01:00";
        for (const char* word : {"sea", "snow", "sea"}) {
            Exiv2::StringValue value(word);
            made.iptc.add(Exiv2::IptcKey("Iptc.Application2.Keywords"), &value);
        }
        add_metadata(photo_, made);
        const PhotoRecord read = record();
        QCOMPARE(read.description, (LanguageTexts{{"x-default", "Grüße"}}));
        QCOMPARE(read.place_name, std::string("Graz, Austria"));
        QCOMPARE(read.taken, std::string("1999-12-31T23:59:58+01:00"));
        QCOMPARE(read.keywords, (std::vector<std::string>{"sea", "snow"}));
    }

    void our_sidecar_before_lightrooms_before_the_photo() {
        const auto words = [](const std::string& who) {
            return packet("photoshop:City='" + who + "'",
                          "<dc:subject><rdf:Bag><rdf:li>" + who + "</rdf:li></rdf:Bag></dc:subject>");
        };
        MadeMetadata made;
        made.xmp = words("photo");
        add_metadata(photo_, made);
        QCOMPARE(record().place_name, std::string("photo"));
        sidecar("IMG_1.xmp", words("lightroom"));
        QCOMPARE(record().place_name, std::string("lightroom"));
        sidecar("IMG_1.jpg.XMP", packet("photoshop:City='ours'", ""));
        const PhotoRecord read = record();
        QCOMPARE(read.place_name, std::string("ours"));
        QCOMPARE(read.keywords, (std::vector<std::string>{"lightroom"})); // field by field
    }

    void a_sidecar_that_jpeg_and_raw_share() {
        const fs::path raw = photo_.parent_path() / "IMG_1.nef";
        write_bytes(raw, jpeg_bytes(400, 300));
        sidecar("IMG_1.xmp", packet("photoshop:SidecarForExtension='NEF' photoshop:City='Graz'", ""));
        QCOMPARE(record().place_name, std::string("Graz"));
        QCOMPARE(read_record(raw)->place_name, std::string("Graz"));
    }

    void every_letter_case_of_xmp() {
        for (const char* name :
             {"IMG_1.jpg.xmp", "IMG_1.jpg.XMP", "IMG_1.jpg.Xmp", "IMG_1.XMP", "IMG_1.xMp"}) {
            sidecar(name, packet("photoshop:City='here'", ""));
            QVERIFY2(record().place_name == "here", name);
            fs::remove(photo_.parent_path() / name);
        }
    }

    void digikam_sidecar() {
        sidecar("IMG_1.jpg.xmp",
                packet("xmp:CreateDate='2026-05-01T10:15:00.25' exif:GPSLatitude='48,12.5N' "
                       "exif:GPSLongitude='16,30,36E'",
                       "<digiKam:TagsList><rdf:Seq><rdf:li>People/Anna</rdf:li></rdf:Seq></digiKam:TagsList>"
                       "<dc:description><rdf:Alt><rdf:li xml:lang='x-default'>By the "
                       "sea</rdf:li></rdf:Alt></dc:description>" +
                           regions("stDim:w='400' stDim:h='300' stDim:unit='pixel'",
                                   region("stArea:x='0.5' stArea:y='0.25' stArea:w='0.2' stArea:h='0.1' "
                                          "stArea:unit='normalized'",
                                          "mwg-rs:Name='Anna' mwg-rs:Type='Face'"))));
        const PhotoRecord read = record();
        QVERIFY(read.faces == (std::vector<FaceRegion>{{0.5, 0.25, 0.2, 0.1, "Anna"}}));
        QCOMPARE(read.taken, std::string("2026-05-01T10:15:00"));
        QCOMPARE(read.description, (LanguageTexts{{"x-default", "By the sea"}}));
        QVERIFY(std::abs(read.place->latitude - (48.0 + 12.5 / 60.0)) < 1e-9);
        QVERIFY(std::abs(read.place->longitude - 16.51) < 1e-9);
        QVERIFY(read.problems.empty());
    }

    void lightroom_sidecar() {
        sidecar(
            "IMG_1.xmp",
            packet("photoshop:DateCreated='2026-05-01T10:15:00+02:00' photoshop:City='Graz' "
                   "photoshop:Country='Austria'",
                   "<Iptc4xmpCore:AltTextAccessibility><rdf:Alt><rdf:li xml:lang='x-default'>Two "
                   "children</rdf:li>"
                   "<rdf:li xml:lang='de'>Zwei Kinder</rdf:li></rdf:Alt></Iptc4xmpCore:AltTextAccessibility>"
                   "<Iptc4xmpExt:PersonInImage><rdf:Bag><rdf:li>Anna</rdf:li><rdf:li>Ben</rdf:li></rdf:Bag></"
                   "Iptc4xmpExt:PersonInImage>"
                   "<Iptc4xmpExt:LocationCreated><rdf:Bag><rdf:li rdf:parseType='Resource'>"
                   "<Iptc4xmpExt:City>Linz</Iptc4xmpExt:City><Iptc4xmpExt:CountryName>Austria</"
                   "Iptc4xmpExt:CountryName>"
                   "</rdf:li></rdf:Bag></Iptc4xmpExt:LocationCreated>"));
        const PhotoRecord read = record();
        QCOMPARE(read.alt_text, (LanguageTexts{{"x-default", "Two children"}, {"de", "Zwei Kinder"}}));
        QCOMPARE(read.persons, (std::vector<std::string>{"Anna", "Ben"}));
        QCOMPARE(read.place_name, std::string("Linz, Austria"));
        QCOMPARE(read.taken, std::string("2026-05-01T10:15:00+02:00"));
    }

    void microsoft_regions_begin_at_their_corner() {
        sidecar("IMG_1.jpg.xmp",
                packet("", "<MP:RegionInfo rdf:parseType='Resource'><MPRI:Regions><rdf:Bag>"
                           "<rdf:li MPReg:Rectangle='0.25, 0.5, 0.5, 0.25' MPReg:PersonDisplayName='Anna'/>"
                           "<rdf:li MPReg:PersonDisplayName='Ben'/>"
                           "<rdf:li MPReg:Rectangle='0.25, 0.5'/></rdf:Bag></MPRI:Regions></MP:RegionInfo>"));
        const PhotoRecord read = record();
        QVERIFY(read.faces == (std::vector<FaceRegion>{{0.5, 0.625, 0.5, 0.25, "Anna"}}));
        QCOMPARE(read.problems.size(), std::size_t{1});
    }

    void apple_regions_with_extensions_and_other_types() {
        sidecar(
            "IMG_1.jpg.xmp",
            packet("xmlns:apple-fi='http://ns.apple.com/faceinfo/1.0/'",
                   regions("stDim:w='4000' stDim:h='3000' stDim:unit='pixel'",
                           region("stArea:x='0.5' stArea:y='0.5' stArea:w='0.1' stArea:h='0.1' "
                                  "stArea:unit='normalized'",
                                  "mwg-rs:Type='Focus'") +
                               "<rdf:li rdf:parseType='Resource'><mwg-rs:Area rdf:parseType='Resource'>"
                               "<stArea:x>0.25</stArea:x><stArea:y>0.25</stArea:y><stArea:w>0.1</stArea:w>"
                               "<stArea:h>0.2</stArea:h></mwg-rs:Area><mwg-rs:Type>Face</mwg-rs:Type>"
                               "<mwg-rs:Extensions "
                               "rdf:parseType='Resource'><apple-fi:AngleInfoYaw>270</apple-fi:AngleInfoYaw>"
                               "</mwg-rs:Extensions></rdf:li>")));
        QVERIFY(record().faces == (std::vector<FaceRegion>{{0.25, 0.25, 0.1, 0.2, ""}}));
    }

    void circles_points_and_pixels() {
        sidecar(
            "IMG_1.jpg.xmp",
            packet(
                "",
                regions(
                    "stDim:w='400' stDim:h='300' stDim:unit='pixel'",
                    region("stArea:x='0.5' stArea:y='0.5' stArea:d='0.4'", "mwg-rs:Name='circle'") +
                        region("stArea:x='0.1' stArea:y='0.2'", "mwg-rs:Name='point'") +
                        region("stArea:x='200' stArea:y='75' stArea:w='40' stArea:h='30' stArea:unit='pixel'",
                               "mwg-rs:Name='pixels'") +
                        region("stArea:x='7' stArea:y='0.2'", "mwg-rs:Name='outside'") +
                        region("stArea:x='nan' stArea:y='0.2'", "mwg-rs:Name='nonsense'"))));
        const PhotoRecord read = record();
        QCOMPARE(read.faces.size(), std::size_t{3});
        QVERIFY(close(read.faces[0], {0.5, 0.5, 0.3, 0.4, "circle"}));
        QVERIFY(close(read.faces[1], {0.1, 0.2, 0.0, 0.0, "point"}));
        QVERIFY(close(read.faces[2], {0.5, 0.25, 0.1, 0.1, "pixels"}));
        QCOMPARE(read.problems.size(), std::size_t{2});
    }

    /// The same place of the stored picture, as each program sees it that marks it on the picture turned.
    void regions_marked_on_the_turned_picture_data() {
        QTest::addColumn<int>("orientation");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("5") << 5 << 0.1 << 0.2;
        QTest::newRow("6") << 6 << 0.9 << 0.2;
        QTest::newRow("7") << 7 << 0.9 << 0.8;
        QTest::newRow("8") << 8 << 0.1 << 0.8;
    }
    void regions_marked_on_the_turned_picture() {
        QFETCH(int, orientation);
        QFETCH(double, x);
        QFETCH(double, y);
        MadeMetadata made;
        made.exif["Exif.Image.Orientation"] = static_cast<std::uint16_t>(orientation);
        add_metadata(photo_, made);
        sidecar("IMG_1.jpg.xmp",
                packet("", regions("stDim:w='300' stDim:h='400' stDim:unit='pixel'",
                                   region("stArea:x='" + std::to_string(x) + "' stArea:y='" +
                                              std::to_string(y) + "' stArea:w='0.02' stArea:h='0.04'",
                                          "mwg-rs:Name='Anna'"))));
        const PhotoRecord read = record();
        QVERIFY(close(read.faces.at(0), {0.2, 0.1, 0.04, 0.02, "Anna"}));
        QVERIFY(read.problems.empty());
    }

    void regions_of_another_crop_are_told() {
        sidecar("IMG_1.jpg.xmp", packet("", regions("stDim:w='100' stDim:h='100'",
                                                    region("stArea:x='0.5' stArea:y='0.5'", ""))));
        const PhotoRecord read = record();
        QCOMPARE(read.faces.size(), std::size_t{1});
        QCOMPARE(read.problems.size(), std::size_t{1});
    }

    void a_tag_that_is_a_path_is_dropped() {
        std::string list;
        for (const char* file : {"../x", "/etc/passwd", "a\\b", "..", ".", "", "good.flac", "good.flac"})
            list += std::string("<rdf:li tp:kind='memo' tp:file='") + file + "'/>";
        sidecar("IMG_1.jpg.xmp", packet("", "<tp:tags><rdf:Seq>" + list + "</rdf:Seq></tp:tags>"));
        const PhotoRecord read = record();
        QCOMPARE(read.tags.size(), std::size_t{1});
        QCOMPARE(read.tags[0].file, std::string("good.flac"));
        QCOMPARE(read.problems.size(), std::size_t{7});
        QVERIFY(read.problems[1].find("/etc/passwd") != std::string::npos);
    }

    void a_broken_sidecar_does_not_hide_the_photo() {
        MadeMetadata made;
        made.xmp = packet("photoshop:City='Graz'", "");
        add_metadata(photo_, made);
        sidecar("IMG_1.jpg.xmp", "<rdf:RDF");
        const PhotoRecord read = record();
        QCOMPARE(read.place_name, std::string("Graz"));
        QCOMPARE(read.problems.size(), std::size_t{1});
        QVERIFY(read.problems[0].ends_with('.'));
    }

    void a_broken_photo_is_told() {
        write_bytes(photo_, "no picture at all");
        sidecar("IMG_1.jpg.xmp", packet("photoshop:City='Graz'", ""));
        const PhotoRecord read = record();
        QCOMPARE(read.place_name, std::string("Graz"));
        QCOMPARE(read.problems.size(), std::size_t{1});
        for (const std::size_t size : std::initializer_list<std::size_t>{0, 1, 2, 20, 100, 105}) {
            write_bytes(photo_, jpeg_bytes(400, 300).substr(0, size));
            QVERIFY(read_record(photo_).ok());
        }
    }

    void no_photo_is_an_error() {
        QVERIFY(!read_record(photo_.parent_path() / "none.jpg").ok());
        QVERIFY(!read_record(photo_.parent_path()).ok());
        QVERIFY(!read_record("/dev/zero").ok());
    }

    void names_of_all_kinds() {
        for (const std::string& name :
             {std::string("a\nb.jpg"), std::string("\xFF\xFE.jpg"), std::string("שלום\u202E.jpg"),
              std::string("👩‍👧.jpg"), std::string("-"), std::string("data:image"),
              std::string(240, 'x') + ".jpg"}) {
            photo_ = photo_.parent_path() / name;
            write_bytes(photo_, jpeg_bytes(400, 300));
            sidecar(name + ".xmp", packet("photoshop:City='Graz'", ""));
            QVERIFY2(record().place_name == "Graz", name.c_str());
            QVERIFY2(record().width == 400, name.c_str());
        }
    }

    void other_kinds_of_file() {
        photo_ = photo_.parent_path() / "a.png";
        write_bytes(photo_, png_bytes(400, 300));
        MadeMetadata made;
        made.exif["Exif.Photo.DateTimeOriginal"] = "2026:05:01 10:15:00";
        made.xmp = packet("photoshop:City='Graz'", "");
        add_metadata(photo_, made);
        PhotoRecord read = record();
        QCOMPARE(read.width, 400LL);
        QCOMPARE(read.taken, std::string("2026-05-01T10:15:00"));
        QCOMPARE(read.place_name, std::string("Graz"));

        photo_ = photo_.parent_path() / "a.tif";
        write_bytes(photo_, tiff_bytes(400, 300));
        add_metadata(photo_, made);
        read = record();
        QCOMPARE(read.taken, std::string("2026-05-01T10:15:00"));
        QCOMPARE(read.place_name, std::string("Graz"));

        photo_ = photo_.parent_path() / "a.webp";
        write_bytes(photo_, webp_bytes());
        add_metadata(photo_, made);
        read = record();
        QCOMPARE(read.taken, std::string("2026-05-01T10:15:00"));
        QCOMPARE(read.place_name, std::string("Graz"));
    }

    void a_phones_heic() {
        photo_ = photo_.parent_path() / "IMG_2.HEIC";
        write_bytes(photo_, heic_bytes(4032, 3024, packet("photoshop:City='Graz'", "")));
        const PhotoRecord read = record();
        QCOMPARE(read.width, 4032LL);
        QCOMPARE(read.height, 3024LL);
        QCOMPARE(read.place_name, std::string("Graz"));
        QVERIFY2(read.problems.empty(), read.problems.empty() ? "" : read.problems.front().c_str());
    }

    void dates_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("expected");
        QTest::newRow("parts of a second") << "2026-05-01T10:15:00.123Z"
                                           << "2026-05-01T10:15:00Z";
        QTest::newRow("no seconds") << "2026-05-01T10:15+02:00"
                                    << "2026-05-01T10:15:00+02:00";
        QTest::newRow("a day") << "2026-05-01"
                               << "2026-05-01";
        QTest::newRow("a month") << "2026-05"
                                 << "2026-05";
        QTest::newRow("a year") << "2026"
                                << "2026";
        QTest::newRow("leap day") << "2024-02-29"
                                  << "2024-02-29";
        for (const char* nonsense :
             {"2026-02-29", "2026-13", "0000-00-00", "2026-05-01T24:00:00", "2026-05-01T10:60", "",
              "yesterday", "2026-05-01T10:15:00+99:00", "2026-05-01T10:15:00 x"})
            QTest::newRow(nonsense) << nonsense << "";
    }
    void dates() {
        QFETCH(QString, text);
        QFETCH(QString, expected);
        QCOMPARE(QString::fromStdString(xmp_time(text.toStdString()).value_or("")), expected);
    }
};

} // namespace read_record_test

TP_TEST(read_record_test, ReadRecordTest, event_loop)
#include "read_record_test.moc"
