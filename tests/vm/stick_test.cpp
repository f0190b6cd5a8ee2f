// SPDX-License-Identifier: Apache-2.0
// In the virtual machine: albums on the file systems of sticks and cards, by the kernel and, of NTFS, by FUSE. They know no second names, no
// rights, no swapping, and tell times by two seconds or letters in one case.
#include "album_of_one.hpp"
#include "app/album/check/album_check.hpp"
#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/conflicts.hpp"
#include "app/album/metadata/read_record.hpp"
#include "core/files/durable_file.hpp"

#include <QProcess>
#include <QTest>

#include <memory>
#include <optional>

using namespace tp;
namespace fs = std::filesystem;
using Fate = ImportedPhoto::Fate;

namespace {

/// A stick that is plugged in while one lives, and what new albums lie on.
class Stick {
public:
    Stick(const QString& make, const QString& driver) : driver_(driver) {
        works_ = run("truncate", {"--size", "64M", image}) &&
                 run("/usr/sbin/" + make.section(' ', 0, 0), make.split(' ').mid(1) << image);
        works_ = works_ && plug_in();
    }
    ~Stick() {
        pull_out();
        run("rm", {"-f", image});
    }
    Stick(const Stick&) = delete;
    Stick& operator=(const Stick&) = delete;

    bool works() const { return works_; }
    bool plug_in() {
        fs::create_directories(place);
        qputenv("TMPDIR", place);
        return run("mount", {"-t", driver_, "-o", "loop", image, place});
    }
    bool pull_out() {
        qunsetenv("TMPDIR");
        return run("umount", {place});
    }

private:
    static constexpr const char *image = "/tmp/stick.image", *place = "/tmp/stick";
    static bool run(const QString& program, const QStringList& words) {
        QProcess process;
        process.setProcessChannelMode(QProcess::ForwardedChannels);
        process.start(program, words);
        return process.waitForFinished(-1) && process.exitStatus() == QProcess::NormalExit &&
               process.exitCode() == 0;
    }

    QString driver_;
    bool works_ = false;
};

QString findings(const fs::path& album) {
    const auto report = check_album(album);
    std::string all = report ? "" : report.error();
    if (report)
        for (const Finding& finding : report->findings)
            all += finding.sentence + "\n";
    return QString::fromStdString(all);
}

} // namespace

class StickTest : public QObject {
    Q_OBJECT

private slots:
    void an_album_on_a_stick_is_an_album_data() {
        QTest::addColumn<QString>("make"), QTest::addColumn<QString>("driver");
        QTest::newRow("exFAT") << "mkfs.exfat"
                               << "exfat";
        QTest::newRow("FAT 32") << "mkfs.vfat -F 32"
                                << "vfat";
        QTest::newRow("FAT 16") << "mkfs.vfat -F 16"
                                << "vfat";
        QTest::newRow("NTFS") << "mkfs.ntfs -F -Q"
                              << "ntfs-3g";
    }
    void an_album_on_a_stick_is_an_album() {
        QFETCH(QString, make);
        QFETCH(QString, driver);
        const AlbumFolder at_home;
        Stick stick(make, driver);
        QVERIFY(stick.works());
        AlbumOfOne album;
        AlbumKeeper& keeper = album.keeper;
        const fs::path& photo = album.photo;
        QVERIFY(photo.string().starts_with("/tmp/stick/"));

        // Words and recordings, and back.
        QCOMPARE(keeper.describe(photo, "en", "A garden", "With Anna."), std::string());
        QCOMPARE(keeper.describe(photo, "de", "Ein Garten", ""), std::string());
        QCOMPARE(keeper.name_face(photo, {0.5, 0.5, 0.2, 0.2, "Jörg: \"Ö\"?"}), std::string());
        QCOMPARE(keeper.keep_name_recording("Jörg: \"Ö\"?", album.sound), std::string());
        const auto story = keeper.add_recording(photo, a_sound(at_home, "b.wav", 2.0, 400.0),
                                                {RecordingKind::story, "Anna", {}, {}, {}, {}});
        QVERIFY2(story.ok(), story.error().c_str());
        const auto part = keeper.trim_recording(photo, story->tag.file, 0.5, 1.5);
        QVERIFY2(part.ok(), part.error().c_str());
        RecordingLabel label = part->label;
        label.kind = RecordingKind::memo;
        QCOMPARE(keeper.label_recording(photo, part->file, label), std::string());
        QCOMPARE(keeper.delete_recording(photo, album.file), std::string());
        QCOMPARE(read_record(photo)->tags.size(), std::size_t{1});
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(read_record(photo)->tags.size(), std::size_t{2});
        QCOMPARE(keeper.delete_photo(photo), std::string());
        QVERIFY(!fs::exists(photo) && !fs::exists(tags_folder(photo)));
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(read_record(photo)->tags.size(), std::size_t{2});
        QCOMPARE(findings(album.folder.path()), QString());

        // Another machine's sidecar.
        const fs::path copy = photo.parent_path() / "IMG_1.jpg.sync-conflict-20260501-101500-ABCDEFG.xmp";
        QCOMPARE(copy_whole(photo.string() + ".xmp", copy), std::string());
        QCOMPARE(check_album(album.folder.path(), {.mend = true})->findings.size(), std::size_t{1});
        QVERIFY(!fs::exists(copy));

        // A card, a bundle, and both ways.
        for (int i = 2; i < 5; ++i)
            a_photo(at_home, "IMG_" + std::to_string(i) + ".jpg", i);
        const auto imported = import_photos(album.folder.path(), "card", {at_home.path()}, {});
        QVERIFY2(imported.ok(), imported.error().c_str());
        QCOMPARE(imported->count(Fate::imported), std::size_t{3});
        const fs::path bundle = album.folder.path() / "all.touchphoto";
        QCOMPARE(export_bundle(bundle, album.folder.path(), {album.folder.path()}), std::string());
        QVERIFY(copy_whole(photo, photo).find("there is a file of that name") != std::string::npos);
        {
            const AlbumFolder other;
            const auto all = import_photos(other.path(), {}, {bundle}, {});
            QCOMPARE(all->count(Fate::imported), std::size_t{4});
            QCOMPARE(read_record(other / "2026/IMG_1.jpg")->tags.size(), std::size_t{2});
            QCOMPARE(findings(other.path()), QString());
        }

        // Pulled out when all is said to be kept, and plugged in again.
        const auto before = album.folder.files();
        QVERIFY(stick.pull_out());
        QVERIFY(keeper.describe(photo, "en", "Lost", "") != std::string());
        QVERIFY(stick.plug_in());
        QVERIFY(album.folder.files() == before);
        QCOMPARE(findings(album.folder.path()), QString());
        QCOMPARE(read_record(photo)->alt_text, (LanguageTexts{{"en", "A garden"}, {"de", "Ein Garten"}}));

        // Full.
        fs::path filler = album.folder.path() / "filler";
        for (std::size_t size = 64 << 20; size >= 512; size /= 2) {
            filler += "x";
            static_cast<void>(replace_file(filler, std::string(size, 'x')));
        }
        const std::string refused = keeper.describe(photo, "en", std::string(60'000, 'a'), "");
        QVERIFY2(refused.find("the disk is full") != std::string::npos, refused.c_str());
        QVERIFY(!keeper.add_recording(photo, a_sound(at_home, "c.wav", 20.0, 400.0), label).ok());
        QCOMPARE(read_record(photo)->alt_text, (LanguageTexts{{"en", "A garden"}, {"de", "Ein Garten"}}));
        QCOMPARE(read_record(photo)->tags.size(), std::size_t{2});
        QCOMPARE(findings(album.folder.path()), QString());
    }
};

QTEST_GUILESS_MAIN(StickTest)
#include "stick_test.moc"
