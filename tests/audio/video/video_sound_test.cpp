// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/byte_source.hpp"
#include "audio/recordings/import_sound.hpp"
#include "audio/recordings/sound_reader.hpp"
#include "audio/video/video_sound.hpp"
#include "byte_mutants.hpp"
#include "made_video.hpp"
#include "owned_bytes.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <numbers>

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t seed = 20260501;
constexpr int mutated_videos = 1'000;

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

Result<VideoSound> opened(std::string bytes) {
    return VideoSound::open(std::make_unique<OwnedBytes>(std::move(bytes)));
}

/// The first channel, ±1.
std::vector<double> heard(VideoSound& sound) {
    const auto channels = static_cast<std::size_t>(sound.format().channels);
    std::vector<double> samples;
    std::vector<std::int32_t> block(1'000 * channels);
    while (const std::size_t frames = sound.read(block))
        for (std::size_t i = 0; i < frames; ++i)
            samples.push_back(block[i * channels] / 2147483648.0);
    return samples;
}

/// The share of the sound's energy that lies at this frequency: 1 for nothing but a tone (Goertzel).
double share_at(const std::vector<double>& samples, double hertz, int rate) {
    double re = 0.0, im = 0.0, energy = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double phase = 2.0 * std::numbers::pi * hertz * static_cast<double>(i) / rate;
        re += samples[i] * std::cos(phase);
        im += samples[i] * std::sin(phase);
        energy += samples[i] * samples[i];
    }
    return energy == 0.0 ? 0.0 : 2.0 * (re * re + im * im) / (energy * static_cast<double>(samples.size()));
}

} // namespace

class VideoSoundTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    fs::path root_;

    std::string video(const VideoParts& parts) {
        const fs::path file = root_ / "video";
        return make_video(file, parts) ? bytes_of(file) : std::string{};
    }

private slots:
    void initTestCase() {
        QVERIFY2(can_make_videos(), "ffmpeg is not installed");
        root_ = dir_.path().toStdString();
    }

    void each_codec_of_a_camera_is_heard_data() {
        QTest::addColumn<QString>("codec");
        QTest::addColumn<QString>("container");
        QTest::addColumn<int>("rate");
        QTest::addColumn<int>("channels");
        QTest::newRow("telephone") << "aac"
                                   << "mp4" << 48'000 << 1;
        QTest::newRow("telephone, stereo") << "aac"
                                           << "mov" << 44'100 << 2;
        QTest::newRow("lossless") << "alac"
                                  << "mov" << 48'000 << 2;
        QTest::newRow("camera") << "pcm_s16le"
                                << "mov" << 48'000 << 2;
        QTest::newRow("camera, big end first") << "pcm_s16be"
                                               << "mov" << 32'000 << 1;
        QTest::newRow("24 bit") << "pcm_s24le"
                                << "mov" << 48'000 << 1;
        QTest::newRow("A-law") << "pcm_alaw"
                               << "mov" << 8'000 << 1;
        QTest::newRow("dolby") << "ac3"
                               << "mp4" << 48'000 << 2;
        QTest::newRow("mp3") << "libmp3lame"
                             << "mp4" << 48'000 << 1;
        QTest::newRow("3gp") << "aac"
                             << "3gp" << 16'000 << 1;
    }

    void each_codec_of_a_camera_is_heard() {
        QFETCH(QString, codec);
        QFETCH(QString, container);
        QFETCH(int, rate);
        QFETCH(int, channels);
        const std::string bytes =
            video({QStringLiteral("sine=frequency=440:sample_rate=%1:duration=1").arg(rate),
                   codec,
                   container,
                   {QStringLiteral("-ac"), QString::number(channels)},
                   true});
        QVERIFY(!bytes.empty());
        auto sound = opened(bytes);
        QVERIFY2(sound.ok(), sound.error().c_str());
        QCOMPARE(sound->format().rate, rate);
        QCOMPARE(sound->format().channels, channels);
        QVERIFY(std::abs(static_cast<double>(sound->frames()) - rate) < 0.1 * rate);
        const std::vector<double> samples = heard(*sound);
        QVERIFY2(std::abs(static_cast<double>(samples.size()) - rate) < 0.1 * rate,
                 std::to_string(samples.size()).c_str());
        const double at_440 = share_at(samples, 440.0, rate);
        QVERIFY2(at_440 > 0.95, std::to_string(at_440).c_str());
        QVERIFY(share_at(samples, 445.0, rate) < 0.01);
        QVERIFY(sound->depth() == (codec == "pcm_s24le" ? SampleDepth::bits_24 : SampleDepth::bits_16));
    }

    void samples_that_were_not_compressed_are_the_same() {
        const std::string quiet =
            video({QStringLiteral("anullsrc=channel_layout=mono:sample_rate=48000:duration=0.2"),
                   QStringLiteral("pcm_s16le"),
                   QStringLiteral("mov"),
                   {},
                   false});
        auto silence = opened(quiet);
        QVERIFY2(silence.ok(), silence.error().c_str());
        const std::vector<double> nothing = heard(*silence);
        QCOMPARE(nothing.size(), std::size_t{9'600});
        QVERIFY(std::all_of(nothing.begin(), nothing.end(), [](double sample) { return sample == 0.0; }));
        // FFmpeg's sine has a peak of an eighth of full scale
        auto tone = opened(video({QStringLiteral("sine=frequency=440:sample_rate=48000:duration=1"),
                                  QStringLiteral("pcm_s16le"),
                                  QStringLiteral("mov"),
                                  {},
                                  false}));
        const std::vector<double> samples = heard(*tone);
        QCOMPARE(samples.size(), std::size_t{48'000});
        const double peak = *std::max_element(samples.begin(), samples.end());
        QVERIFY2(std::abs(peak - 0.125) < 0.001, std::to_string(peak).c_str());
    }

    void a_video_becomes_a_flac_with_its_notes() {
        const std::string bytes = video({});
        const auto open = [&]() -> Result<std::unique_ptr<SoundStream>> {
            auto sound = opened(bytes);
            if (!sound)
                return Error{sound.error()};
            return std::unique_ptr<SoundStream>(std::make_unique<VideoSound>(std::move(*sound)));
        };
        const RecordingNotes notes{{RecordingKind::ambient, {}, {}, {}, "2026-05-01T10:15:00+02:00", {}}, {}};
        for (const char* name : {"2026-05-01T101500-ambient.flac", "2026-05-01T101500-ambient-2.flac"}) {
            const auto kept = import_sound(open, root_ / "tags", notes);
            QVERIFY2(kept.ok(), kept.error().c_str());
            QCOMPARE(kept->file, root_ / "tags" / name);
            QCOMPARE(kept->warning, std::string());
            const auto reader = SoundReader::open(kept->file);
            QCOMPARE(reader->format().rate, 48'000);
        }
    }

    void what_cannot_be_heard_is_refused_in_words() {
        const auto refused = [&](std::string bytes, const char* words) {
            const auto sound = opened(std::move(bytes));
            if (sound.ok())
                return std::string("it was taken");
            return sound.error().find(words) != std::string::npos ? std::string{} : sound.error();
        };
        QCOMPARE(refused("", "not a video"), std::string());
        QCOMPARE(refused("not a video at all", "not a video"), std::string());
        QCOMPARE(refused(std::string(100'000, '\0'), "not a video"), std::string());
        QCOMPARE(refused(video({{}, {}, QStringLiteral("mp4"), {}, true}), "it has no sound."),
                 std::string());
        QCOMPARE(
            refused(
                video({VideoParts{}.sound, QStringLiteral("wavpack"), QStringLiteral("matroska"), {}, true}),
                "not a video"),
            std::string());
        QCOMPARE(refused(video({VideoParts{}.sound,
                                QStringLiteral("flac"),
                                QStringLiteral("mp4"),
                                {QStringLiteral("-strict"), QStringLiteral("experimental")},
                                true}),
                         "(flac)"),
                 std::string());
    }

    void mutated_videos_are_refused_or_end() {
        std::vector<Seed> seeds;
        for (const auto& [codec, container] :
             {std::pair("aac", "mp4"), std::pair("pcm_s16le", "mov"), std::pair("alac", "mov")})
            seeds.push_back({codec, video({QStringLiteral("sine=frequency=440:sample_rate=8000:duration=0.3"),
                                           QString::fromUtf8(codec),
                                           QString::fromUtf8(container),
                                           {},
                                           false})});
        // where the description lies at the end, the mutants of the beginning would miss it
        seeds.push_back(
            {"description first", video({QStringLiteral("sine=frequency=440:sample_rate=8000:duration=0.3"),
                                         QStringLiteral("aac"),
                                         QStringLiteral("mp4"),
                                         {QStringLiteral("-movflags"), QStringLiteral("+faststart")},
                                         false})});
        ByteMutator mutator(seed);
        int taken = 0;
        for (int i = 0; i < mutated_videos; ++i) {
            auto sound = opened(mutator.mutant(seeds));
            if (!sound) {
                QVERIFY2(sound.error().size() > 10 && sound.error().ends_with('.'), sound.error().c_str());
                continue;
            }
            ++taken;
            QVERIFY(sound->format().channels >= 1 && sound->format().channels <= 8);
            std::vector<std::int32_t> block(4'096);
            for (int blocks = 0; blocks < 1'000; ++blocks)
                if (const std::size_t frames = sound->read(block); frames == 0)
                    break;
                else
                    QVERIFY(frames * static_cast<std::size_t>(sound->format().channels) <= block.size());
        }
        QVERIFY2(taken > mutated_videos / 20, std::to_string(taken).c_str());
    }
};

QTEST_GUILESS_MAIN(VideoSoundTest)
#include "owned_bytes.hpp"
#include "video_sound_test.moc"
