// SPDX-License-Identifier: Apache-2.0
// Two readers, one sidecar: what we read is what exiftool reads, in sidecars as digiKam, Lightroom, Apple
// Photos and Windows write them and in random ones of exiftool's own.
#include "app/album/metadata/motion_photo.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "made_photo.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <filesystem>
#include <random>

namespace exiftool_agrees_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

/// Degrees; exiftool prints fifteen digits, sidecars have four of a minute.
constexpr double rounding = 1e-6;

QStringList texts_in(const QJsonValue& value) {
    QStringList texts;
    if (value.isArray())
        for (const QJsonValue& one : value.toArray())
            texts << one.toVariant().toString();
    else if (!value.isUndefined())
        texts << value.toVariant().toString();
    return texts;
}

QString joined(const std::vector<std::string>& texts) {
    QStringList all;
    for (const std::string& text : texts)
        all << QString::fromStdString(text);
    return all.join("; ");
}

std::vector<FaceRegion> faces_in(const QJsonObject& read) {
    std::vector<FaceRegion> faces;
    for (const QJsonValue& region : read["XMP-mwg-rs:RegionInfo"]["RegionList"].toArray()) {
        const QJsonObject area = region["Area"].toObject();
        faces.push_back({area["X"].toDouble(), area["Y"].toDouble(), area["W"].toDouble(),
                         area["H"].toDouble(), region["Name"].toString().toStdString()});
    }
    if (!faces.empty())
        return faces;
    for (const QJsonValue& region : read["XMP-MP:RegionInfoMP"]["Regions"].toArray()) {
        const QStringList part = region["Rectangle"].toString().split(", ");
        const double width = part.value(2).toDouble(), height = part.value(3).toDouble();
        faces.push_back({part.value(0).toDouble() + width / 2.0, part.value(1).toDouble() + height / 2.0,
                         width, height, region["PersonDisplayName"].toString().toStdString()});
    }
    return faces;
}

bool same_face(const FaceRegion& a, const FaceRegion& b) {
    return a.name == b.name && std::abs(a.x - b.x) < rounding && std::abs(a.y - b.y) < rounding &&
           std::abs(a.width - b.width) < rounding && std::abs(a.height - b.height) < rounding;
}

/// What our record says that exiftool does not; empty where they agree.
QString difference(const PhotoRecord& ours, const QJsonObject& read) {
    const auto differ = [](const char* what, const QString& a, const QString& b) {
        return a == b ? QString() : QStringLiteral("%1: \"%2\", exiftool \"%3\"").arg(what, a, b);
    };
    QString found = differ("keywords", joined(ours.keywords), texts_in(read["XMP-dc:Subject"]).join("; "));
    found += differ("persons", joined(ours.persons), texts_in(read["XMP-iptcExt:PersonInImage"]).join("; "));
    static const QRegularExpression parts_of_a_second("\\.[0-9]+"); // we keep whole ones
    QString taken = read["XMP-exif:DateTimeOriginal"].toString().remove(parts_of_a_second);
    if (taken.size() >= 19)
        taken.replace(4, 1, "-").replace(7, 1, "-").replace(10, 1, "T");
    found += differ("taken", QString::fromStdString(ours.taken), taken);
    QStringList place;
    for (const char* part : {"XMP-photoshop:City", "XMP-photoshop:State", "XMP-photoshop:Country"})
        place += texts_in(read[QLatin1String(part)]);
    found += differ("place", QString::fromStdString(ours.place_name), place.join(", "));
    for (const auto& [language, text] : ours.description)
        found += differ(
            "description", QString::fromStdString(text),
            read["XMP-dc:Description" + QString::fromStdString(language == "x-default" ? "" : "-" + language)]
                .toVariant()
                .toString());
    if (ours.description.empty() != read["XMP-dc:Description"].isUndefined())
        found += "one of the two has no description";
    const QJsonValue north = read["XMP-exif:GPSLatitude"], east = read["XMP-exif:GPSLongitude"];
    if (ours.place.has_value() == north.isUndefined())
        found += "one of the two has no position";
    else if (ours.place && (std::abs(ours.place->latitude - north.toDouble()) > rounding ||
                            std::abs(ours.place->longitude - east.toDouble()) > rounding))
        found += "another position";
    const std::vector<FaceRegion> faces = faces_in(read);
    if (!std::equal(ours.faces.begin(), ours.faces.end(), faces.begin(), faces.end(), same_face))
        found += QStringLiteral("other faces: %1, exiftool %2").arg(ours.faces.size()).arg(faces.size());
    return found;
}

} // namespace

class ExiftoolAgreesTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path photo_;
    QString sidecar_;

    static QByteArray exiftool(const QStringList& arguments) {
        QProcess process;
        process.start("exiftool", arguments);
        process.waitForFinished(60'000);
        return process.exitCode() == 0 ? process.readAllStandardOutput() : QByteArray();
    }
    QJsonObject read_by_exiftool() const {
        return QJsonDocument::fromJson(exiftool({"-j", "-struct", "-G1", "-n", sidecar_}))
            .array()
            .at(0)
            .toObject();
    }
    void take(const char* corpus_name) const {
        write_bytes(sidecar_.toStdString(),
                    bytes_of(in_source("tests/app/album/metadata/corpus/") + std::string(corpus_name)));
    }

private slots:
    void initTestCase() {
        if (QStandardPaths::findExecutable("exiftool").isEmpty())
            QSKIP("exiftool is missing (package libimage-exiftool-perl)");
    }
    void init() {
        photo_ = fs::path(dir_.path().toStdString()) / "IMG_1.jpg";
        write_bytes(photo_, jpeg_bytes(400, 300));
        sidecar_ = QString::fromStdString(photo_.string() + ".xmp");
        fs::remove(sidecar_.toStdString());
    }

    void sidecars_of_other_programs_data() {
        QTest::addColumn<int>("faces");
        QTest::addColumn<int>("keywords");
        QTest::newRow("digikam.xmp") << 1 << 2;
        QTest::newRow("apple_photos.xmp") << 0 << 2;
        QTest::newRow("windows_people.xmp") << 1 << 1;
    }
    void sidecars_of_other_programs() {
        QFETCH(int, faces);
        QFETCH(int, keywords);
        take(QTest::currentDataTag());
        const PhotoRecord ours = *read_record(photo_);
        QCOMPARE(difference(ours, read_by_exiftool()), QString());
        QCOMPARE(static_cast<int>(ours.faces.size()), faces);
        QCOMPARE(static_cast<int>(ours.keywords.size()), keywords);
        QVERIFY(ours.problems.empty());
        SidecarChanges changes;
        changes.alt_text = LanguageTexts{{"x-default", "A face"}};
        QCOMPARE(write_sidecar(photo_, changes), std::string());
        QCOMPARE(difference(*read_record(photo_), read_by_exiftool()), QString());
        QVERIFY(read_by_exiftool()["XMP-iptcCore:AltTextAccessibility"] == "A face");
    }

    /// Lightroom marks faces on the picture as it is turned; we keep them in the stored one.
    void a_lightroom_sidecar_of_a_turned_photograph() {
        MadeMetadata turned;
        turned.exif["Exif.Image.Orientation"] = "6";
        add_metadata(photo_, turned);
        take("lightroom_turned.xmp");
        PhotoRecord ours = *read_record(photo_);
        QVERIFY(ours.problems.empty());
        QCOMPARE(ours.faces.size(), std::size_t{1});
        const FaceRegion stored = ours.faces[0];
        ours.faces[0] = {1.0 - stored.y, stored.x, stored.height, stored.width,
                         stored.name}; // a quarter clockwise
        QCOMPARE(difference(ours, read_by_exiftool()), QString());
    }

    /// As Samsung's camera writes them: the video behind the picture, its place in a list at the file's end.
    void a_samsung_motion_photo() {
        const std::string bytes =
            bytes_of(in_source("tests/app/album/metadata/photo_corpus/samsung_motion_jpg"));
        write_bytes(photo_, bytes);
        const auto video = video_inside(MemoryBytes(bytes));
        QVERIFY(video.has_value());
        const QByteArray theirs =
            exiftool({"-b", "-EmbeddedVideoFile", QString::fromStdString(photo_.string())});
        QVERIFY(!theirs.isEmpty());
        QCOMPARE(QByteArray::fromStdString(bytes.substr(video->begin, video->size)), theirs);
        QCOMPARE(read_record(photo_)->taken, std::string("2026-05-01T10:15:00"));
        QCOMPARE(read_record(photo_)->orientation, 8);
    }

    void random_sidecars_of_exiftool() {
        std::mt19937 random(20260501);
        const auto number = [&](int most) {
            return static_cast<int>(random() % static_cast<unsigned>(most));
        };
        const QStringList words{"sea",  "2026", "Jörg & Anna", "<b>",  "\"quoted\"",
                                "שלום", "👵",    "a; b",        "  two"};
        for (int i = 0; i < 12; ++i) {
            QStringList arguments{"-q", "-n", "-charset", "utf8"};
            for (int k = number(4); k > 0; --k)
                arguments << "-XMP-dc:Subject=" + words[number(9)] + QString::number(k);
            for (int k = number(3); k > 0; --k)
                arguments << "-XMP-iptcExt:PersonInImage=" + words[number(9)] + QString::number(k);
            arguments << "-XMP-dc:Description=" + words[number(9)]
                      << "-XMP-dc:Description-de=" + words[number(9)];
            if (number(2) == 0)
                arguments << QStringLiteral("-XMP-exif:GPSLatitude=%1").arg(number(180'000) / 1e3 - 90.0)
                          << QStringLiteral("-XMP-exif:GPSLongitude=%1").arg(number(360'000) / 1e3 - 180.0);
            if (number(2) == 0)
                arguments << QStringLiteral("-XMP-exif:DateTimeOriginal=20%1:0%2:1%3 1%4:15:0%5")
                                 .arg(10 + number(20))
                                 .arg(1 + number(9))
                                 .arg(number(10))
                                 .arg(number(10))
                                 .arg(number(10));
            if (number(2) == 0)
                arguments << "-XMP-photoshop:City=" + words[number(9)];
            QStringList regions;
            for (int k = number(4); k > 0; --k)
                regions << QStringLiteral(
                               "{Area={X=0.%1,Y=0.%2,W=0.1,H=0.0%3,Unit=normalized},Name=P%4,Type=Face}")
                               .arg(1 + number(8))
                               .arg(1 + number(8))
                               .arg(1 + number(9))
                               .arg(k);
            if (!regions.isEmpty())
                arguments << "-RegionInfo={AppliedToDimensions={W=400,H=300,Unit=pixel},RegionList=[" +
                                 regions.join(",") + "]}";
            fs::remove(sidecar_.toStdString());
            exiftool(arguments << sidecar_);
            const QJsonObject read = read_by_exiftool();
            QVERIFY(read.contains("XMP-dc:Description"));
            const QString found = difference(*read_record(photo_), read);
            QVERIFY2(found.isEmpty(), qPrintable(QString::number(i) + ": " + found));
        }
    }

    void a_difference_is_noticed() {
        take("digikam.xmp");
        const QJsonObject read = read_by_exiftool();
        const PhotoRecord right = *read_record(photo_);
        QCOMPARE(difference(right, read), QString());
        PhotoRecord wrong = right;
        wrong.keywords.pop_back();
        QVERIFY(!difference(wrong, read).isEmpty());
        wrong = right;
        wrong.faces[0].x += 0.001;
        QVERIFY(!difference(wrong, read).isEmpty());
        wrong = right;
        wrong.taken = "2026-05-01T10:15:01";
        QVERIFY(!difference(wrong, read).isEmpty());
        wrong = right;
        wrong.place = Place{48.0, 16.0};
        QVERIFY(!difference(wrong, read).isEmpty());
    }
};

} // namespace exiftool_agrees_test

TP_TEST(exiftool_agrees_test, ExiftoolAgreesTest, event_loop)
#include "exiftool_agrees_test.moc"
