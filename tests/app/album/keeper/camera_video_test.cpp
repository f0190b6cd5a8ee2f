// SPDX-License-Identifier: Apache-2.0
// The sound of motion photos and Live Photos, from a card to a recording.
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "app/album/check/album_check.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "audio/recordings/recording_file.hpp"
#include "audio/recordings/sound_reader.hpp"
#include "made_video.hpp"
#include "test_program.hpp"

#include <QDate>
#include <QTest>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace camera_video_test {

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;
using Fate = ImportedPhoto::Fate;

namespace {

/// The tone's frequency by its crossings of zero, upwards.
double frequency_of(const fs::path& file) {
    auto reader = SoundReader::open(file);
    if (!reader)
        return 0.0;
    const auto channels = static_cast<std::size_t>(reader->format().channels);
    std::vector<std::int32_t> samples(static_cast<std::size_t>(reader->frames()) * channels);
    const std::size_t frames = reader->read(samples);
    std::size_t first = 0, last = 0, crossings = 0;
    for (std::size_t i = 1; i < frames; ++i)
        if (samples[(i - 1) * channels] < 0 && samples[i * channels] >= 0) {
            if (crossings++ == 0)
                first = i;
            last = i;
        }
    return crossings < 2 ? 0.0
                         : static_cast<double>(crossings - 1) * reader->format().rate /
                               static_cast<double>(last - first);
}

} // namespace

class CameraVideoTest : public QObject {
    Q_OBJECT

    static std::string video(const VideoParts& parts = {}) {
        const AlbumFolder place;
        return make_video(place / "video", parts) ? place.read("video") : std::string{};
    }
    static std::string motion_photo(const std::string& video) {
        return made_motion_photo(motion_photo_1(video.size()), video);
    }
    /// Its video in the box that Google's "Motion Photo format 1.0" has for it, in the last one, whose size may be 0.
    static std::string heic_motion_photo(const std::string& video) {
        using namespace std::string_literals;
        return "\0\0\0\x10"
               "ftypheic\0\0\0\0\0\0\0\0"
               "mpvd"s +
               video;
    }
    static ImportReport imported(const AlbumFolder& album, const AlbumFolder& card) {
        auto report = import_photos(album.path(), {}, {card.path()}, {});
        return report ? *report : ImportReport{};
    }
    /// The only recording of a photograph; empty where it has none or several.
    static fs::path recording_of(const fs::path& photo) {
        std::error_code error;
        std::vector<fs::path> files;
        for (const auto& file : fs::directory_iterator(tags_folder(photo), error))
            files.push_back(file.path());
        return files.size() == 1 ? files.front() : fs::path();
    }

private slots:
    void initTestCase() { QVERIFY2(can_make_videos(), "ffmpeg is not installed"); }

    void the_sound_of_each_kind_becomes_an_ambient_recording_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("source");
        QTest::newRow("motion photo") << "format 1"
                                      << "motion_photo";
        QTest::newRow("older motion photo") << "micro video"
                                            << "motion_photo";
        QTest::newRow("Samsung's") << "samsung"
                                   << "motion_photo";
        QTest::newRow("motion photo as HEIC") << "heic"
                                              << "motion_photo";
        QTest::newRow("Live Photo") << "live"
                                    << "live_photo";
        QTest::newRow("Live Photo, as JPEG and MP4") << "live, mp4"
                                                     << "live_photo";
        QTest::newRow("sound file") << "wav"
                                    << "sound_file";
    }

    void the_sound_of_each_kind_becomes_an_ambient_recording() {
        QFETCH(QString, kind);
        QFETCH(QString, source);
        const AlbumFolder card, album;
        const std::string film = video();
        const bool heic = kind == "live" || kind == "heic";
        const std::string name = heic ? "IMG_1.HEIC" : "IMG_1.JPG";
        card.write(name, kind == "format 1"      ? motion_photo(film)
                         : kind == "micro video" ? made_motion_photo(micro_video(film.size()), film)
                         : kind == "samsung"     ? made_motion_photo(">", samsung_end(film))
                         : kind == "heic"        ? heic_motion_photo(film)
                                                 : "a picture");
        fs::path sounding = card / name;
        if (kind == "live")
            sounding = card.write("img_1.mov", film);
        else if (kind == "live, mp4")
            sounding = card.write("IMG_1.MP4", film);
        else if (kind == "wav")
            sounding = a_sound(card, "IMG_1.WAV", 1.0, 440.0);
        const auto before = card.files();
        fs::last_write_time(sounding, fs::file_time_type::clock::now() - std::chrono::hours(24 * 365));

        const ImportReport report = imported(album, card);
        QCOMPARE(report.photos.size(), std::size_t{1});
        QCOMPARE(report.photos[0].problem, std::string());
        QVERIFY(report.photos[0].sound.has_value());
        QCOMPARE(QString::fromStdString(std::string(name_of(report.photos[0].sound->source))), source);
        QVERIFY(card.files() == before);
        QVERIFY(album.read(name) == before.at(name));

        const fs::path file = recording_of(album / name);
        QCOMPARE(file.filename().string(), report.photos[0].sound->recording);
        QCOMPARE(file.extension(), fs::path(".flac"));
        const double hertz = frequency_of(file);
        QVERIFY2(std::abs(hertz - 440.0) < 2.0, std::to_string(hertz).c_str());
        const auto about = about_recording(file);
        QVERIFY(about->notes.label.kind == RecordingKind::ambient);
        const int year = QDate::currentDate().addDays(-365).year();
        QVERIFY2(about->notes.label.recorded.starts_with(std::to_string(year)),
                 about->notes.label.recorded.c_str());
        QVERIFY(std::abs(about->seconds() - 1.0) < 0.1);
        const auto record = read_record(album / name);
        QCOMPARE(record->tags.size(), std::size_t{1});
        QCOMPARE(record->tags[0].file, file.filename().string());
        QVERIFY(check_album(album.path())->findings.empty());
    }

    void nothing_comes_twice() {
        const AlbumFolder card, album;
        card.write("IMG_1.JPG", motion_photo(video()));
        card.write("the same again.JPG", card.read("IMG_1.JPG"));
        card.write("IMG_2.HEIC", "a picture");
        card.write("IMG_2.MOV", video({{}, QStringLiteral("aac"), QStringLiteral("mov"), {}, true}));
        card.write("IMG_2.MP4", video());
        for (int i = 0; i < 2; ++i) {
            const ImportReport report = imported(album, card);
            QCOMPARE(report.count(Fate::imported), std::size_t(i == 0 ? 2 : 0));
            QVERIFY(!recording_of(album / "IMG_1.JPG").empty());
        }
        QVERIFY(!fs::exists(album / "the same again.JPG.tags"));
        const ImportReport again = imported(album, card);
        for (const ImportedPhoto& photo : again.photos)
            QVERIFY(!photo.sound.has_value());
    }

    void a_sound_file_counts_more_than_a_video() {
        const AlbumFolder card, album;
        card.write("IMG_1.JPG", motion_photo(video()));
        a_sound(card, "IMG_1.WAV", 0.5, 300.0);
        card.write("IMG_1.MOV", video());
        imported(album, card);
        const double hertz = frequency_of(recording_of(album / "IMG_1.JPG"));
        QVERIFY2(std::abs(hertz - 300.0) < 2.0, std::to_string(hertz).c_str());
    }

    /// A kill came after the photograph and before its sound.
    void an_import_that_goes_on_brings_the_sound() {
        const AlbumFolder card, album;
        card.write("IMG_1.JPG", motion_photo(video()));
        card.write("IMG_2.JPG", "another");
        std::stop_source stop;
        ImportTools tools;
        tools.stop = stop.get_token();
        tools.progress = [&](const ImportProgress& progress) {
            if (progress.done == 1)
                stop.request_stop();
        };
        const auto stopped = import_photos(album.path(), {}, {card.path()}, tools);
        QVERIFY(stopped->stopped);
        fs::remove_all(album / "IMG_1.JPG.tags");
        fs::remove(album / "IMG_1.JPG.xmp");
        const fs::path half = album.write("IMG_1.JPG.tags/.touchphoto-1-1.tmp", "what was being written");
        QVERIFY(is_temporary(half));
        fs::permissions(half.parent_path(), fs::perms::owner_all);
        const auto rest = go_on_importing(album.path(), stopped->id, {});
        QVERIFY2(rest.ok(), rest.error().c_str());
        QCOMPARE(rest->photos.size(), std::size_t{2});
        QVERIFY(rest->photos[0].fate == Fate::duplicate && rest->photos[0].sound.has_value());
        fs::remove(half);
        QVERIFY(!recording_of(album / "IMG_1.JPG").empty());
        QVERIFY(check_album(album.path())->findings.empty());
    }

    void what_cannot_come_along_is_said_and_the_import_goes_on() {
        const AlbumFolder card, album;
        const VideoParts mute{{}, {}, QStringLiteral("mp4"), {}, true};
        card.write("a mute.JPG", motion_photo(video(mute)));
        card.write("b broken.HEIC", "a picture");
        card.write("b broken.MOV", "no video");
        VideoParts film;
        film.sound = QStringLiteral("sine=frequency=440:sample_rate=8000:duration=70");
        film.pictures = false;
        card.write("c film.JPG", "another picture");
        card.write("c film.MP4", video(film));
        VideoParts strange;
        strange.codec = QStringLiteral("flac");
        strange.more = {QStringLiteral("-strict"), QStringLiteral("experimental")};
        card.write("d strange.JPG", "a third");
        card.write("d strange.MP4", video(strange));
        card.write("z.JPG", "the last");
        const auto before = card.files();
        const ImportReport report = imported(album, card);
        QCOMPARE(report.count(Fate::imported), std::size_t{5});
        const std::vector<std::string> words{"it has no sound.", "not a video", "longer than a minute",
                                             "(flac)"};
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::string& problem = report.photos[i].problem;
            QVERIFY2(problem.find(words[i]) != std::string::npos && problem.ends_with('.') &&
                         problem.find('\n') == std::string::npos,
                     problem.c_str());
            QVERIFY(!report.photos[i].sound.has_value());
            QVERIFY(!fs::exists(tags_folder(report.photos[i].place)));
        }
        QCOMPARE(report.photos[4].problem, std::string());
        QVERIFY(card.files() == before);
        QVERIFY(unfinished_imports(album.path()).empty());
    }
};

} // namespace camera_video_test

TP_TEST(camera_video_test, CameraVideoTest, event_loop)
#include "camera_video_test.moc"
