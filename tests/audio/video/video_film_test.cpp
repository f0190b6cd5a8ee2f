// SPDX-License-Identifier: Apache-2.0
// The pictures of videos, against what FFmpeg's own program makes of the same files; in this process and by touchphoto-decoder.
#include "audio/video/film_messages.hpp"
#include "audio/video/film_of_video.hpp"
#include "core/processes/foreign_decoder.hpp"
#include "made_video.hpp"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QVector>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

std::vector<FilmPicture> all_of(FilmStream& film) {
    std::vector<FilmPicture> pictures;
    for (double from_s = 0.0;;) {
        std::optional<FilmPicture> picture = film.next(from_s);
        if (!picture)
            return pictures;
        from_s = picture->time_s + 0.001;
        pictures.push_back(std::move(*picture));
    }
}

/// Picture after picture, as FFmpeg's program says.
QByteArray raw_pictures(const fs::path& video) {
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start("ffmpeg",
                  {"-nostdin", "-v", "error", "-noautorotate", "-i", QString::fromStdString(video.string()),
                   "-vf", "scale=out_range=tv", "-pix_fmt", "yuv420p", "-f", "rawvideo", "-"});
    process.waitForFinished(-1);
    return process.readAllStandardOutput();
}

double mean_difference(const FilmPicture& picture, const QByteArray& raw, std::size_t from) {
    double sum = 0.0;
    for (std::size_t i = 0; i < picture.planes.size(); ++i)
        sum += std::abs(static_cast<int>(picture.planes[i]) -
                        static_cast<int>(static_cast<unsigned char>(raw[static_cast<qsizetype>(from + i)])));
    return sum / static_cast<double>(picture.planes.size());
}

} // namespace

class VideoFilmTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    ForeignDecoders decoders_{qEnvironmentVariable("TP_DECODER").toStdString()};

    fs::path path(const char* name) const { return fs::path(dir_.path().toStdString()) / name; }

private slots:
    void initTestCase() { QVERIFY2(can_make_videos(), "ffmpeg is not installed"); }
    void cleanup() { decode_in_helpers(nullptr); }

    void each_codec_of_a_camera_is_seen_data() {
        QTest::addColumn<QStringList>("how");
        QTest::addColumn<QString>("container");
        QTest::newRow("old telephone") << QStringList{} << "3gp";
        QTest::newRow("telephone") << QStringList{"-c:v", "libx264", "-pix_fmt", "yuv420p"} << "mp4";
        QTest::newRow("of odd size") << QStringList{"-c:v",    "libx264", "-pix_fmt",
                                                    "yuv444p", "-vf",     "scale=63:47"}
                                     << "mp4";
        QTest::newRow("ten bits") << QStringList{"-c:v", "libx264", "-pix_fmt", "yuv420p10le"} << "mov";
        QTest::newRow("camera") << QStringList{"-c:v", "mjpeg", "-pix_fmt", "yuvj422p"} << "mov";
    }
    void each_codec_of_a_camera_is_seen() {
        QFETCH(QStringList, how);
        QFETCH(QString, container);
        const fs::path file = path("video");
        QVERIFY(make_video(file, {QString(), QString(), container, how, true}));
        for (ForeignDecoders* const by : {static_cast<ForeignDecoders*>(nullptr), &decoders_}) {
            decode_in_helpers(by);
            const auto film = film_of_video(file);
            QVERIFY2(film.ok(), film.error().c_str());
            const std::vector<FilmPicture> pictures = all_of(**film);
            QCOMPARE(pictures.size(), std::size_t{5});
            const QByteArray raw = raw_pictures(file);
            const bool odd = how.contains("scale=63:47");
            for (std::size_t i = 0; i < pictures.size(); ++i) {
                const FilmPicture& picture = pictures[i];
                QVERIFY(std::abs(picture.time_s - 0.2 * static_cast<double>(i)) < 0.01);
                QCOMPARE(picture.turn_deg, 0);
                QCOMPARE(picture.width, odd ? 62 : 64);
                QCOMPARE(picture.height, odd ? 46 : 48);
                QCOMPARE(picture.planes.size(), film_bytes(picture.width, picture.height));
                if (odd)
                    continue;
                const double difference = mean_difference(picture, raw, i * picture.planes.size());
                QVERIFY2(difference < 2.5, qPrintable(QString::number(difference)));
            }
        }
    }

    void what_comes_too_soon_is_passed_over() {
        QVERIFY(make_video(path("video"), {QString(), QString(), "mp4", {}, true}));
        const auto film = film_of_video(path("video"));
        QVERIFY2(film.ok(), film.error().c_str());
        QVERIFY(std::abs((*film)->next(0.35)->time_s - 0.4) < 0.01);
        QVERIFY(std::abs((*film)->next(0.7)->time_s - 0.8) < 0.01);
        QVERIFY(!(*film)->next(0.9));
    }

    void a_telephone_held_upright_says_so() {
        QVERIFY(make_video(path("video"), {QString(), QString(), "mp4", {}, true}));
        QVERIFY(turn_video(path("video"), 48));
        const auto film = film_of_video(path("video"));
        QVERIFY2(film.ok(), film.error().c_str());
        QCOMPARE((*film)->next(0.0)->turn_deg, 90);
    }

    void its_sentences_are_the_same() {
        std::ofstream(path("text"), std::ios::binary) << "no video at all";
        VideoParts sound;
        sound.pictures = false;
        QVERIFY(make_video(path("sound"), sound));
        QVERIFY(make_video(path("other"), {QString(), QString(), "mov", {"-c:v", "png"}, true}));
        for (const char* name : {"text", "sound", "other", "nowhere"}) {
            decode_in_helpers(nullptr);
            const std::string here = film_of_video(path(name)).error();
            QVERIFY2(here.ends_with('.'), name);
            decode_in_helpers(&decoders_);
            QCOMPARE(film_of_video(path(name)).error(), here);
        }
    }

    void one_of_another_size_after_it_is_seen_whole() {
        QVERIFY(make_video(path("small"), {QString(), QString(), "mp4", {}, true}));
        QVERIFY(make_video(path("large"), {QString(), QString(), "mp4", {"-vf", "scale=320:240"}, true}));
        decode_in_helpers(&decoders_);
        for (const auto& [name, width] : {std::pair{"small", 64}, {"large", 320}, {"small", 64}}) {
            const auto film = film_of_video(path(name));
            QVERIFY2(film.ok(), film.error().c_str());
            const std::vector<FilmPicture> pictures = all_of(**film);
            QCOMPARE(pictures.size(), std::size_t{5});
            QCOMPARE(pictures.back().width, width);
        }
    }

    void answers_that_cannot_be_are_refused_data() {
        QTest::addColumn<QVector<qint64>>("numbers"); // us, width, height, turn
        QTest::addColumn<bool>("good");
        QTest::newRow("as it should be") << QVector<qint64>{1'000, 8, 6, 90} << true;
        QTest::newRow("larger than its memory") << QVector<qint64>{1'000, 8, 8, 0} << false;
        QTest::newRow("odd") << QVector<qint64>{1'000, 7, 6, 0} << false;
        QTest::newRow("less than nothing") << QVector<qint64>{1'000, -8, -6, 0} << false;
        QTest::newRow("turned halfway") << QVector<qint64>{1'000, 8, 6, 45} << false;
        QTest::newRow("too few") << QVector<qint64>{1'000, 8, 6} << false;
    }
    void answers_that_cannot_be_are_refused() {
        QFETCH(QVector<qint64>, numbers);
        QFETCH(bool, good);
        const auto memory = SharedMemory::make(film_bytes(8, 6));
        QVERIFY(memory);
        MessageWriter writer;
        writer.add(std::string_view());
        for (const qint64 number : numbers)
            writer.add(std::int64_t{number});
        writer.hand_over(memory->another());
        Message message = writer.take();
        std::optional<Mapping> tray;
        const auto answer = film_answer(message, tray);
        QCOMPARE(answer.ok(), good);
        QVERIFY(!good || (*answer)->planes.size() == film_bytes(8, 6));
    }
};

QTEST_GUILESS_MAIN(VideoFilmTest)
#include "video_film_test.moc"
