// SPDX-License-Identifier: Apache-2.0
// Places, dates and words as a photograph's XMP, EXIF and IPTC give them: the last that counts, and the first that does not.
#include "app/album/metadata/photo_metadata.hpp"
#include "app/album/metadata/xmp_record.hpp"
#include "made_photo.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace record_borders_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

RecordParts parts(const std::string& attributes, const std::string& elements = "") {
    return parts_from_xmp(*XmpPacket::from(packet(attributes, elements)), {400, 300, 1});
}

QByteArray said(const std::optional<std::string>& text) {
    return QByteArray::fromStdString(text.value_or("nothing"));
}

bool is_near(const std::optional<Place>& place, double latitude, double longitude) {
    return place && std::abs(place->latitude - latitude) < 1e-12 &&
           std::abs(place->longitude - longitude) < 1e-12;
}

std::string bag(const std::string& property, const std::string& items) {
    return "<" + property + "><rdf:Bag>" + items + "</rdf:Bag></" + property + ">";
}

} // namespace

class RecordBordersTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;

    PhotoMetadata metadata_of(const MadeMetadata& made) const {
        const fs::path photo = fs::path(dir_.path().toStdString()) / "a.jpg";
        write_bytes(photo, jpeg_bytes(400, 300));
        add_metadata(photo, made);
        auto metadata = photo_metadata(photo);
        return metadata ? std::move(*metadata) : PhotoMetadata{};
    }
    std::optional<Place> exif_place(const char* latitude, const char* north, const char* longitude,
                                    const char* east) const {
        MadeMetadata made;
        made.exif["Exif.GPSInfo.GPSLatitude"] = latitude;
        made.exif["Exif.GPSInfo.GPSLatitudeRef"] = north;
        made.exif["Exif.GPSInfo.GPSLongitude"] = longitude;
        made.exif["Exif.GPSInfo.GPSLongitudeRef"] = east;
        const PhotoMetadata metadata = metadata_of(made);
        const bool told = !metadata.parts.problems.empty();
        return told ? std::optional(Place{999.0, 999.0}) : metadata.parts.place;
    }

private slots:
    void xmp_says_where() {
        const auto place = [](const std::string& north, const std::string& east) {
            return parts("exif:GPSLatitude='" + north + "' exif:GPSLongitude='" + east + "'").place;
        };
        QVERIFY(is_near(place("48,12.5N", "16,30,36E"), 48.0 + 12.5 / 60.0, 16.51));
        QVERIFY(is_near(place("48,12,30S", "16W"), -(48.0 + 12.0 / 60.0 + 30.0 / 3600.0), -16.0));
        QVERIFY(is_near(place("90N", "180E"), 90.0, 180.0));
        QVERIFY(is_near(place("90S", "180W"), -90.0, -180.0));
        QVERIFY(is_near(place("0N", "0E"), 0.0, 0.0));
        for (const auto& [north, east] : std::vector<std::pair<const char*, const char*>>{{"90.001N", "0E"},
                                                                                          {"0N", "180.001E"},
                                                                                          {"90.001S", "0E"},
                                                                                          {"0N", "180.001W"},
                                                                                          {"1,2,3,4N", "0E"},
                                                                                          {"-1N", "0E"},
                                                                                          {"1,-2N", "0E"},
                                                                                          {"1", "0E"},
                                                                                          {"N", "0E"},
                                                                                          {"1,N", "0E"},
                                                                                          {"1E", "0E"},
                                                                                          {"1N", "0N"},
                                                                                          {"1N", ""},
                                                                                          {"", "1E"},
                                                                                          {"x,1N", "0E"}}) {
            const RecordParts none =
                parts(std::string("exif:GPSLatitude='") + north + "' exif:GPSLongitude='" + east + "'");
            QVERIFY2(!none.place, north);
            QCOMPARE(none.problems,
                     std::vector<std::string>{"The position is not a place on Earth and is left out."});
        }
        QVERIFY(!parts("").place && parts("").problems.empty());
    }

    void xmp_says_when_in_one_of_three_places() {
        const std::string first = "exif:DateTimeOriginal='2001'", second = "photoshop:DateCreated='2002'",
                          third = "xmp:CreateDate='2003'", space = " ";
        QCOMPARE(said(parts(first + space + second + space + third).taken), QByteArray("2001"));
        QCOMPARE(said(parts(second + space + third).taken), QByteArray("2002"));
        QCOMPARE(said(parts(third).taken), QByteArray("2003"));
        const RecordParts broken = parts("exif:DateTimeOriginal='yesterday' " + third);
        QCOMPARE(said(broken.taken), QByteArray("2003"));
        QCOMPARE(broken.problems,
                 std::vector<std::string>{"The date \"yesterday\" is in no calendar and is left out."});
        QCOMPARE(said(parts("").taken), QByteArray("nothing"));
    }

    void xmp_says_where_in_words() {
        QCOMPARE(said(parts("photoshop:City='Graz' photoshop:State='Styria' photoshop:Country='Austria'")
                          .place_name),
                 QByteArray("Graz, Styria, Austria"));
        QCOMPARE(said(parts("photoshop:State='Styria'").place_name), QByteArray("Styria"));
        QCOMPARE(said(parts("photoshop:City='' photoshop:Country='Austria'").place_name),
                 QByteArray("Austria"));
        QCOMPARE(said(parts("photoshop:City=''").place_name), QByteArray("nothing"));
        const std::string created =
            "<rdf:li rdf:parseType='Resource'><Iptc4xmpExt:City>Linz</Iptc4xmpExt:City>"
            "<Iptc4xmpExt:ProvinceState>Upper Austria</Iptc4xmpExt:ProvinceState>"
            "<Iptc4xmpExt:CountryName><rdf:Alt><rdf:li xml:lang='x-default'>Austria</rdf:li>"
            "</rdf:Alt></Iptc4xmpExt:CountryName></rdf:li>";
        const std::string other =
            "<rdf:li rdf:parseType='Resource'><Iptc4xmpExt:City>Wels</Iptc4xmpExt:City></rdf:li>";
        QCOMPARE(said(parts("photoshop:City='Graz'", bag("Iptc4xmpExt:LocationCreated", created + other))
                          .place_name),
                 QByteArray("Linz, Upper Austria, Austria")); // the first, and before the older way
        QCOMPARE(said(parts("", "<Iptc4xmpExt:LocationCreated rdf:parseType='Resource'><Iptc4xmpExt:City>Linz"
                                "</Iptc4xmpExt:City></Iptc4xmpExt:LocationCreated>")
                          .place_name),
                 QByteArray("Linz"));
        QCOMPARE(said(parts("photoshop:City='Graz'", bag("Iptc4xmpExt:LocationCreated", "")).place_name),
                 QByteArray("Graz"));
    }

    void texts_in_languages_and_lists() {
        const RecordParts listed = parts(
            "",
            "<dc:description><rdf:Alt><rdf:li>for all</rdf:li><rdf:li xml:lang='x-default'>second</rdf:li>"
            "<rdf:li xml:lang='de'>deutsch</rdf:li><rdf:li "
            "xml:lang='fr'></rdf:li></rdf:Alt></dc:description>" +
                bag("dc:subject", "<rdf:li>sea</rdf:li><rdf:li/><rdf:li>snow</rdf:li><rdf:li>sea</rdf:li>"));
        QCOMPARE(listed.description, (LanguageTexts{{"x-default", "for all"}, {"de", "deutsch"}}));
        QCOMPARE(listed.keywords, (std::vector<std::string>{"sea", "snow"}));
        QVERIFY(!listed.alt_text && !listed.persons && !listed.tags && !listed.content_hash && !listed.faces);
        const RecordParts plain =
            parts("Iptc4xmpCore:AltTextAccessibility='short' Iptc4xmpCore:ExtDescrAccessibility='long' "
                  "dc:description='older' dc:subject='sea' tp:contentHash=''");
        QCOMPARE(plain.alt_text, (LanguageTexts{{"x-default", "short"}}));
        QCOMPARE(plain.description, (LanguageTexts{{"x-default", "long"}}));
        QCOMPARE(plain.keywords, (std::vector<std::string>{"sea"}));
        QVERIFY(!plain.content_hash);
        const RecordParts empty = parts("dc:subject='' dc:description=''");
        QVERIFY(empty.keywords && empty.keywords->empty() && empty.description && empty.description->empty());
    }

    void exif_says_where() {
        QVERIFY(is_near(exif_place("48/1 12/1 3000/100", "N", "16/1 30/1 0/1", "E"),
                        48.0 + 12.0 / 60.0 + 30.0 / 3600.0, 16.5));
        QVERIFY(is_near(exif_place("48/1 0/1 0/1", "S", "16/1 0/1 0/1", "W"), -48.0, -16.0));
        QVERIFY(is_near(exif_place("90/1 0/1 0/1", "N", "180/1 0/1 0/1", "W"), 90.0, -180.0));
        QVERIFY(is_near(exif_place("1/2", "N", "3/2", "E"), 0.5, 1.5)); // degrees alone
        QVERIFY(is_near(exif_place("0/1 0/1 0/1", "N", "16/1 0/1 0/1", "E"), 0.0, 16.0));
        QVERIFY(is_near(exif_place("48/1 0/1 0/1", "N", "0/1 0/1 0/1", "E"), 48.0, 0.0));
        QVERIFY(
            !exif_place("0/1 0/1 0/1", "N", "0/1 0/1 0/1", "E")); // a camera that does not know where it is
        QVERIFY(is_near(exif_place("1/1 0/1 0/1 9/1", "N", "2/1 0/1 0/1 9/1", "E"), 1.0, 2.0));
        for (const char* broken : {"1/0 0/1 0/1", "1/1 1/0 0/1", "-1/1 0/1 0/1", "1/-1 0/1 0/1"})
            QVERIFY2(!exif_place(broken, "N", "16/1 0/1 0/1", "E"), broken);
        const Place told{999.0, 999.0}; // that it makes no sense
        QVERIFY(exif_place("91/1 0/1 0/1", "N", "16/1 0/1 0/1", "E") == told);
        QVERIFY(exif_place("48/1 0/1 0/1", "N", "181/1 0/1 0/1", "E") == told);
        QVERIFY(exif_place("91/1 0/1 0/1", "S", "16/1 0/1 0/1", "E") == told);
        QVERIFY(exif_place("48/1 0/1 0/1", "N", "181/1 0/1 0/1", "W") == told);
    }

    /// Older programs wrote Latin-1; what follows a NUL is not meant.
    void iptc_says_who_where_and_when() {
        MadeMetadata made;
        made.iptc["Iptc.Application2.Caption"] = "\xFC\xE9\x7F\x80\xFF";
        made.iptc["Iptc.Application2.City"] = std::string("Graz\0x", 6);
        made.iptc["Iptc.Application2.ProvinceState"] = "Styria";
        made.iptc["Iptc.Application2.CountryName"] = "\xC3\x96sterreich";
        made.iptc["Iptc.Application2.DateCreated"] = "1999-12-31";
        const RecordParts parts = metadata_of(made).parts;
        QCOMPARE(parts.description, (LanguageTexts{{"x-default", "üé\x7F\xC2\x80ÿ"}}));
        QCOMPARE(said(parts.place_name), QByteArray("Graz, Styria, Österreich"));
        QCOMPARE(said(parts.taken), QByteArray("1999-12-31"));
        QVERIFY(!parts.keywords && !parts.place);
        const RecordParts nothing = metadata_of({}).parts;
        QVERIFY(!nothing.description && !nothing.place_name && !nothing.keywords && !nothing.taken);
    }

    /// EXIF before XMP before IPTC, and the sides as the file itself says.
    void one_kind_of_metadata_counts_before_the_other() {
        MadeMetadata made;
        made.exif["Exif.Photo.DateTimeOriginal"] = "2001:01:01 00:00:00";
        made.exif["Exif.Image.Orientation"] = std::uint16_t{3};
        made.xmp = packet("exif:DateTimeOriginal='2002' photoshop:City='Linz'", "");
        made.iptc["Iptc.Application2.City"] = "Graz";
        const PhotoMetadata metadata = metadata_of(made);
        QCOMPARE(said(metadata.parts.taken), QByteArray("2001-01-01T00:00:00"));
        QCOMPARE(said(metadata.parts.place_name), QByteArray("Linz"));
        QCOMPARE(metadata.shape.orientation, 3);
        QCOMPARE(metadata.shape.width, 400LL);
        QCOMPARE(metadata.shape.height, 300LL);
        QVERIFY(metadata.xmp.has_value() && metadata.parts.problems.empty());
    }

    void what_cannot_be_read_of_a_photograph_is_said() {
        MadeMetadata made;
        made.xmp = packet("photoshop:City='Graz'", "<f:a xmlns:f='f/'>" + std::string(100, ' ') + "</f:a>");
        const fs::path folder = dir_.path().toStdString(), photo = folder / "broken.jpg";
        write_bytes(photo, jpeg_bytes(400, 300));
        add_metadata(photo, made);
        std::string bytes = bytes_of(photo);
        bytes.replace(bytes.find("</f:a>"), 6, "</f:b>");
        write_bytes(photo, bytes);
        const auto broken = photo_metadata(photo);
        QVERIFY(broken && !broken->xmp && !broken->parts.place_name);
        QCOMPARE(broken->parts.problems,
                 std::vector<std::string>{"The photograph's XMP cannot be read: it is not whole XML."});
        write_bytes(folder / "text.jpg", "no picture at all");
        QCOMPARE(photo_metadata(folder / "text.jpg")->shape.width, 0LL); // not known
        QCOMPARE(photo_metadata(folder / "text.jpg")->shape.height, 0LL);
        QCOMPARE(photo_metadata(folder / "text.jpg")->shape.orientation, 1);
        QCOMPARE(photo_metadata(folder / "text.jpg")->parts.problems,
                 std::vector<std::string>{"The metadata of the photograph \"" +
                                          (folder / "text.jpg").string() + "\" cannot be read."});
        QCOMPARE(photo_metadata(folder / "none.jpg").error(),
                 "There is no photograph \"" + (folder / "none.jpg").string() + "\".");
        QCOMPARE(photo_metadata(folder).error(), "\"" + folder.string() + "\" is not a file.");
    }
};

} // namespace record_borders_test

TP_TEST(record_borders_test, RecordBordersTest, event_loop)
#include "record_borders_test.moc"
