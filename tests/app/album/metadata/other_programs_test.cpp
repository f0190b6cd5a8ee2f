// SPDX-License-Identifier: Apache-2.0
// exiftool and exiv2 read what we wrote, and we read what exiftool wrote.
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "made_photo.hpp"
#include "random_changes.hpp"
#include "test_program.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <filesystem>

namespace other_programs_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

class OtherProgramsTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path photo_;
    QString sidecar_;

    static QByteArray output_of(const QString& program, const QStringList& arguments) {
        QProcess process;
        process.start(program, arguments);
        process.waitForFinished(60'000);
        const QByteArray errors = process.readAllStandardError();
        if (process.exitCode() != 0 || !errors.isEmpty())
            qWarning("%s: %s", qPrintable(program), errors.constData());
        return process.exitCode() == 0 ? process.readAllStandardOutput() : QByteArray();
    }

    SidecarChanges changes() const {
        SidecarChanges all;
        all.alt_text = LanguageTexts{{"x-default", "Two \"children\" & a dog"}, {"de-AT", "Zwei Kinder"}};
        all.description = LanguageTexts{{"x-default", "A long\nstory"}};
        all.faces = {{0.5, 0.25, 0.2, 0.1, "Anna <Ä>"}, {0.1, 0.2, 0.1, 0.1, ""}};
        all.keywords = {"sea", "snow"};
        Tag tag;
        tag.file = "2026-05-01T101500-memo.flac";
        tag.label.speaker = "Ben";
        tag.duration_s = 12.5;
        all.tags = {tag};
        all.content_hash = std::string(64, 'a');
        return all;
    }

private slots:
    void init() {
        const fs::path folder = fs::path(dir_.path().toStdString()) / QTest::currentTestFunction();
        fs::create_directory(folder);
        photo_ = folder / "IMG_1.jpg";
        sidecar_ = QString::fromStdString(photo_.string() + ".xmp");
        write_bytes(photo_, jpeg_bytes(400, 300));
    }

    void exiftool_reads_what_we_wrote() {
        if (QStandardPaths::findExecutable("exiftool").isEmpty())
            QSKIP("exiftool is missing (package libimage-exiftool-perl)");
        QCOMPARE(write_sidecar(photo_, changes()), std::string());
        const QByteArray json = output_of("exiftool", {"-j", "-struct", "-G1", "-charset", "utf8", sidecar_});
        const QJsonObject read = QJsonDocument::fromJson(json).array().at(0).toObject();
        QVERIFY2(!read.isEmpty(), json.constData());
        QCOMPARE(read["XMP-iptcCore:AltTextAccessibility"].toString(), QString("Two \"children\" & a dog"));
        QCOMPARE(read["XMP-iptcCore:AltTextAccessibility-de-AT"].toString(), QString("Zwei Kinder"));
        QCOMPARE(read["XMP-iptcCore:ExtDescrAccessibility"].toString(), QString("A long\nstory"));
        const QJsonArray regions = read["XMP-mwg-rs:RegionInfo"].toObject()["RegionList"].toArray();
        QCOMPARE(regions.size(), 2);
        QCOMPARE(regions[0].toObject()["Name"].toString(), QString("Anna <Ä>"));
        QCOMPARE(regions[0].toObject()["Area"].toObject()["X"].toDouble(), 0.5);
        QCOMPARE(read["XMP-mwg-rs:RegionInfo"].toObject()["AppliedToDimensions"].toObject()["W"].toDouble(),
                 400.0);
        QCOMPARE(read["XMP-dc:Subject"].toArray().size(), 2);
        QVERIFY2(json.contains("2026-05-01T101500-memo.flac"), json.constData());
        QVERIFY(json.contains("People/Anna <Ä>"));
        QVERIFY(json.contains("People|Anna <Ä>"));
    }

    void exiv2_reads_what_we_wrote() {
        if (QStandardPaths::findExecutable("exiv2").isEmpty())
            QSKIP("exiv2 is missing (package exiv2)");
        QCOMPARE(write_sidecar(photo_, changes()), std::string());
        const QByteArray text = output_of("exiv2", {"-pa", sidecar_});
        for (const char* piece :
             {"Xmp.mwg-rs.Regions/mwg-rs:RegionList[1]/mwg-rs:Name", "Anna <Ä>", "Xmp.iptcExt.PersonInImage",
              "Xmp.digiKam.TagsList", "People/Anna <Ä>", "Xmp.lr.hierarchicalSubject", "Zwei Kinder",
              "Xmp.tp.tags[1]/tp:speaker", "Xmp.tp.contentHash", "2026-05-01T101500-memo.flac"})
            QVERIFY2(text.contains(piece), (QByteArray(piece) + " in\n" + text).constData());
    }

    void exiv2_and_exiftool_read_any_changes() {
        if (QStandardPaths::findExecutable("exiv2").isEmpty() ||
            QStandardPaths::findExecutable("exiftool").isEmpty())
            QSKIP("exiv2 or exiftool is missing (packages exiv2, libimage-exiftool-perl)");
        std::mt19937_64 random(3);
        for (int i = 0; i < 10; ++i) {
            QCOMPARE(write_sidecar(photo_, random_changes(random)), std::string());
            QVERIFY(!output_of("exiv2", {"-pa", sidecar_}).isEmpty());
            const QByteArray said =
                output_of("exiftool", {"-validate", "-warning", "-error", "-a", "-s3", sidecar_});
            QVERIFY2(said.startsWith("OK"), said.constData());
        }
    }

    void we_read_what_exiftool_wrote() {
        if (QStandardPaths::findExecutable("exiftool").isEmpty())
            QSKIP("exiftool is missing (package libimage-exiftool-perl)");
        const QStringList arguments = {
            "-q",
            "-charset",
            "utf8",
            "-XMP-iptcCore:AltTextAccessibility=Two children",
            "-XMP-iptcCore:AltTextAccessibility-de=Zwei Kinder",
            "-XMP-dc:Description=Caption",
            "-XMP-dc:Subject=sea",
            "-XMP-dc:Subject=snow",
            "-XMP-iptcExt:PersonInImage=Anna",
            "-RegionInfo={AppliedToDimensions={W=400,H=300,Unit=pixel},RegionList=[{Area={X=0.5,Y=0.25,W=0.2,"
            "H=0.1,Unit=normalized},Name=Anna,Type=Face}]}",
            "-XMP-exif:DateTimeOriginal=2026:05:01 10:15:00+02:00",
            "-XMP-exif:GPSLatitude=48.25",
            "-XMP-exif:GPSLongitude=-16.5",
            "-XMP-photoshop:City=Graz"};
        const auto check = [&] {
            const PhotoRecord read = *read_record(photo_);
            QCOMPARE(read.alt_text, (LanguageTexts{{"x-default", "Two children"}, {"de", "Zwei Kinder"}}));
            QCOMPARE(read.description, (LanguageTexts{{"x-default", "Caption"}}));
            QCOMPARE(read.keywords, (std::vector<std::string>{"sea", "snow"}));
            QCOMPARE(read.persons, (std::vector<std::string>{"Anna"}));
            QVERIFY(read.faces == (std::vector<FaceRegion>{{0.5, 0.25, 0.2, 0.1, "Anna"}}));
            QCOMPARE(read.taken, std::string("2026-05-01T10:15:00+02:00"));
            QVERIFY(std::abs(read.place->latitude - 48.25) < 1e-6 &&
                    std::abs(read.place->longitude + 16.5) < 1e-6);
            QCOMPARE(read.place_name, std::string("Graz"));
            QVERIFY(read.problems.empty());
        };
        output_of("exiftool", arguments + QStringList{sidecar_});
        check();
        fs::remove(sidecar_.toStdString());
        output_of("exiftool",
                  arguments + QStringList{"-overwrite_original", QString::fromStdString(photo_.string())});
        check();
    }

    void exiftool_changes_what_we_wrote_and_keeps_the_rest() {
        if (QStandardPaths::findExecutable("exiftool").isEmpty())
            QSKIP("exiftool is missing (package libimage-exiftool-perl)");
        QCOMPARE(write_sidecar(photo_, changes()), std::string());
        const PhotoRecord before = *read_record(photo_);
        output_of("exiftool", {"-q", "-overwrite_original", "-XMP-photoshop:City=Graz", sidecar_});
        PhotoRecord after = *read_record(photo_);
        QCOMPARE(after.place_name, std::string("Graz"));
        after.place_name.clear();
        QVERIFY(after == before);
    }
};

} // namespace other_programs_test

TP_TEST(other_programs_test, OtherProgramsTest, event_loop)
#include "other_programs_test.moc"
