// SPDX-License-Identifier: Apache-2.0
// A picture that was taken becomes a photograph of the album.
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/capture/shutter/photograph_store.hpp"
#include "audio/recordings/import_sound.hpp"
#include "faces/decode/picture.hpp"
#include "faces/exiv2/prepare_exiv2.hpp"
#include "test_program.hpp"

#include <QDate>
#include <QDateTime>
#include <QTest>
#include <QTime>
#include <QTimeZone>

#include <exiv2/exiv2.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace photograph_store_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

cv::Mat a_picture(cv::Size size = {400, 300}) {
    cv::Mat shapes(3, 4, CV_8UC3), picture;
    cv::RNG random(4);
    random.fill(shapes, cv::RNG::UNIFORM, 30, 220);
    cv::resize(shapes, picture, size, 0.0, 0.0, cv::INTER_CUBIC);
    return picture;
}

/// 26 November 2026, 14:03:22.045, two hours and a half east of Greenwich.
QDateTime a_time() { return {QDate(2026, 11, 26), QTime(14, 3, 22, 45), QTimeZone(9000)}; }

PhotographFacts facts() {
    PhotographFacts known;
    known.taken = a_time();
    return known;
}

std::map<std::string, std::string> exif_in(const fs::path& photo) {
    prepare_exiv2();
    const auto image = Exiv2::ImageFactory::open(photo.string());
    image->readMetadata();
    std::map<std::string, std::string> texts;
    for (const Exiv2::Exifdatum& datum : image->exifData())
        texts[datum.key()] = datum.toString();
    return texts;
}

/// An album with a keeper.
struct Album {
    AlbumFolder folder;
    AlbumKeeper keeper{folder.path()};
    PhotographStore store{keeper, folder.path()};

    fs::path take(const PhotographFacts& known = facts(), const std::vector<FaceRegion>& faces = {}) {
        const auto added = store.keep(a_picture(), known, faces);
        if (!added || !added->warning.empty())
            qFatal("not kept: %s", (added ? added->warning : added.error()).c_str());
        return added->photo;
    }
    bool holds(const std::string& name) const { return fs::exists(folder / name); }
};

} // namespace

class PhotographStoreTest : public QObject {
    Q_OBJECT
private slots:
    void the_file_says_when_and_how_it_was_taken() {
        Album album;
        PhotographFacts known = facts();
        known.make = "Acme";
        known.model = "Tab 7";
        known.software = "TouchPhoto 1.0";
        const fs::path photo = album.take(known);
        QCOMPARE(photo.filename().string(), std::string("2026-11-26 14.03.22.jpg"));
        auto exif = exif_in(photo);
        QCOMPARE(exif["Exif.Photo.DateTimeOriginal"], std::string("2026:11:26 14:03:22"));
        QCOMPARE(exif["Exif.Photo.SubSecTimeOriginal"], std::string("045"));
        QCOMPARE(exif["Exif.Photo.OffsetTimeOriginal"], std::string("+02:30"));
        QCOMPARE(exif["Exif.Image.Orientation"], std::string("1"));
        QCOMPARE(exif["Exif.Image.Make"], std::string("Acme"));
        QCOMPARE(exif["Exif.Image.Model"], std::string("Tab 7"));
        QCOMPARE(exif["Exif.Image.Software"], std::string("TouchPhoto 1.0"));
        QCOMPARE(exif["Exif.Photo.PixelXDimension"], std::string("400"));
        const auto record = read_record(photo);
        QVERIFY(record);
        QCOMPARE(record->taken, std::string("2026-11-26T14:03:22+02:30"));
        QCOMPARE(record->problems, std::vector<std::string>());
        QCOMPARE(record->content_hash, *content_hash(photo));
    }

    void west_of_greenwich_too() {
        Album album;
        PhotographFacts known = facts();
        known.taken = {QDate(2026, 1, 2), QTime(3, 4, 5), QTimeZone(-12600)};
        QCOMPARE(exif_in(album.take(known))["Exif.Photo.OffsetTimeOriginal"], std::string("-03:30"));
    }

    void a_place_is_kept_only_where_it_was_given() {
        Album album;
        const fs::path without = album.take();
        for (const auto& [key, text] : exif_in(without))
            QVERIFY2(key.find("GPS") == std::string::npos, key.c_str());
        QVERIFY(!read_record(without)->place);
        auto exif = exif_in(without);
        QVERIFY(!exif.contains("Exif.Image.Make") && !exif.contains("Exif.Image.Model"));
        PhotographFacts known = facts();
        known.place = Place{-36.8485, 174.7633};
        const auto place = read_record(album.take(known))->place;
        QVERIFY(place && std::abs(place->latitude + 36.8485) < 1e-5 &&
                std::abs(place->longitude - 174.7633) < 1e-5);
    }

    void the_picture_is_the_one_that_was_taken() {
        Album album;
        const auto read = read_picture(album.take());
        QVERIFY(read);
        QCOMPARE(read->size(), cv::Size(400, 300));
        QVERIFY(cv::norm(*read, a_picture(), cv::NORM_L1) / (400.0 * 300.0 * 3.0) < 2.0);
    }

    void no_name_is_taken_twice() {
        Album album;
        album.folder.write("2026-11-26 14.03.22.jpg", "somebody else's");
        album.folder.write("2026-11-26 14.03.22 (2).jpg.xmp", "of a photograph that is away");
        const fs::path third = album.take(), fourth = album.take();
        QCOMPARE(third.filename().string(), std::string("2026-11-26 14.03.22 (3).jpg"));
        QCOMPARE(fourth.filename().string(), std::string("2026-11-26 14.03.22 (4).jpg"));
        QCOMPARE(album.folder.read("2026-11-26 14.03.22.jpg"), std::string("somebody else's"));
        QCOMPARE(album.folder.read("2026-11-26 14.03.22 (2).jpg.xmp"),
                 std::string("of a photograph that is away"));
    }

    void known_faces_are_in_its_sidecar() {
        Album album;
        const fs::path photo = album.take(facts(), {{0.5, 0.4, 0.2, 0.3, "Anna"}});
        const auto record = read_record(photo);
        QCOMPARE(record->faces.size(), std::size_t{1});
        QCOMPARE(record->faces[0].name, std::string("Anna"));
        QCOMPARE(record->persons, std::vector<std::string>{"Anna"});
    }

    void one_undo_deletes_it_and_redo_brings_it_back() {
        Album album;
        const fs::path photo = album.take(facts(), {{0.5, 0.4, 0.2, 0.3, "Anna"}});
        const std::map<std::string, std::string> before = album.folder.files();
        QCOMPARE(album.keeper.history().next_undo(), std::string("2026-11-26 14.03.22.jpg was added"));
        QCOMPARE(album.keeper.history().undo(), std::string());
        QVERIFY(!fs::exists(photo) && !album.holds("2026-11-26 14.03.22.jpg.xmp"));
        QCOMPARE(album.keeper.trash().entries().size(), std::size_t{1});
        QCOMPARE(album.keeper.history().redo(), std::string());
        QCOMPARE(album.folder.files(), before);
        QCOMPARE(album.keeper.history().undo(), std::string());
        QVERIFY(!fs::exists(photo));
    }

    void the_moment_becomes_an_ambient_recording_and_goes_by_the_same_undo() {
        Album album;
        const AlbumFolder elsewhere;
        const fs::path sound = a_sound(elsewhere, "moment.wav", 0.4, 300.0);
        const fs::path photo = album.take();
        const auto added = album.store.add_moment(photo, sound, a_time().addSecs(-5));
        QVERIFY(added);
        const auto record = read_record(photo);
        QCOMPARE(record->tags.size(), std::size_t{1});
        QVERIFY(record->tags[0].label.kind == RecordingKind::ambient);
        QCOMPARE(record->tags[0].label.recorded, std::string("2026-11-26T14:03:17+02:30"));
        QVERIFY(fs::exists(sound));
        const std::map<std::string, std::string> before = album.folder.files();
        QCOMPARE(album.keeper.history().steps(), std::size_t{1});
        QCOMPARE(album.keeper.history().undo(), std::string());
        QVERIFY(!fs::exists(photo) && !fs::exists(tags_folder(photo)));
        QCOMPARE(album.keeper.history().redo(), std::string());
        QVERIFY(fs::exists(photo));
        QCOMPARE(read_record(photo)->tags.size(), std::size_t{1});
    }

    void a_moment_that_lies_there_already_is_listed() {
        Album album;
        const AlbumFolder elsewhere;
        const fs::path photo = album.take();
        const auto flac =
            import_sound(a_sound(elsewhere, "moment.wav", 0.3, 300.0), tags_folder(photo),
                         {{RecordingKind::ambient, {}, {}, {}, "2026-11-26T14:03:17+02:30", {}}, {}});
        QVERIFY(flac);
        const auto added = album.store.add_moment(photo, flac->file);
        QVERIFY(added);
        QCOMPARE(added->tag.file, flac->file.filename().string());
        QCOMPARE(added->tag.label.recorded, std::string("2026-11-26T14:03:17+02:30"));
        QCOMPARE(album.keeper.history().steps(), std::size_t{1});
        QCOMPARE(album.keeper.history().undo(), std::string());
        QVERIFY(!fs::exists(photo));
    }

    void what_was_done_between_is_taken_back_alone() {
        Album album;
        const AlbumFolder elsewhere;
        const fs::path photo = album.take();
        QCOMPARE(album.keeper.describe(photo, "en", "Anna", ""), std::string());
        QVERIFY(album.store.add_moment(photo, a_sound(elsewhere, "moment.wav", 0.2, 300.0), a_time()));
        QCOMPARE(album.keeper.history().steps(), std::size_t{3});
        QCOMPARE(album.keeper.history().undo(), std::string());
        QVERIFY(fs::exists(photo) && read_record(photo)->tags.empty());
    }

    void a_folder_is_made_and_one_outside_is_refused() {
        AlbumFolder folder;
        AlbumKeeper keeper(folder.path());
        PhotographStore below(keeper, folder / "Taken" / "2026");
        QVERIFY(below.keep(a_picture(), facts()));
        QVERIFY(fs::exists(folder / "Taken" / "2026" / "2026-11-26 14.03.22.jpg"));
        AlbumFolder other;
        PhotographStore outside(keeper, other.path());
        QVERIFY(outside.keep(a_picture(), facts()).error().ends_with('.'));
        QVERIFY(other.files().empty());
    }

    void what_is_no_picture_is_a_sentence_and_no_file() {
        Album album;
        for (const cv::Mat& none : {cv::Mat(), cv::Mat(9, 9, CV_8UC1), cv::Mat(2, 70000, CV_8UC3)}) {
            const auto refused = album.store.keep(none, facts());
            QVERIFY(!refused && refused.error().ends_with('.'));
        }
        QVERIFY(album.folder.files().empty());
        QCOMPARE(album.keeper.history().steps(), std::size_t{0});
    }
};

} // namespace photograph_store_test

TP_TEST(photograph_store_test, PhotographStoreTest, nothing)
#include "photograph_store_test.moc"
