// SPDX-License-Identifier: Apache-2.0
// What touchphoto-decoder decodes, against the same videos decoded in this process.
#include "audio/video/sound_messages.hpp"
#include "audio/video/sound_of_video.hpp"
#include "core/processes/foreign_decoder.hpp"
#include "made_video.hpp"

#include <QTemporaryDir>
#include <QTest>
#include <QVector>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

std::vector<std::int32_t> all_of(SoundStream& sound, std::size_t block) {
    std::vector<std::int32_t> samples, some(block);
    while (const std::size_t frames = sound.read(some))
        samples.insert(samples.end(), some.begin(),
                       some.begin() + static_cast<std::ptrdiff_t>(frames) * sound.format().channels);
    return samples;
}

} // namespace

class SoundOfVideoTest : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    ForeignDecoders decoders_{qEnvironmentVariable("TP_DECODER").toStdString()};

    fs::path path(const char* name) const { return fs::path(dir_.path().toStdString()) / name; }

private slots:
    void initTestCase() { QVERIFY2(can_make_videos(), "ffmpeg is not installed"); }
    void cleanup() { decode_in_helpers(nullptr); }

    void its_samples_are_the_same_data() {
        QTest::addColumn<QString>("codec");
        QTest::addColumn<int>("channels");
        QTest::newRow("one channel") << "aac" << 1;
        QTest::newRow("two channels") << "aac" << 2;
        QTest::newRow("six channels") << "pcm_s16le" << 6;
        QTest::newRow("24 bit") << "pcm_s24le" << 2;
    }
    void its_samples_are_the_same() {
        QFETCH(QString, codec);
        QFETCH(int, channels);
        const fs::path file = path("video");
        QVERIFY(make_video(file, {QStringLiteral("sine=frequency=440:sample_rate=48000:duration=2"),
                                  codec,
                                  QStringLiteral("mov"),
                                  {QStringLiteral("-ac"), QString::number(channels)},
                                  true}));
        // a video within a file, as in a motion photo
        std::ifstream stream(file, std::ios::binary);
        const std::string video{std::istreambuf_iterator<char>(stream), {}};
        std::ofstream(path("within"), std::ios::binary) << std::string(1'234, 'x') << video << "and more";
        for (const std::size_t block : {std::size_t{60}, std::size_t{1'000}, std::size_t{100'002}}) {
            decode_in_helpers(nullptr);
            const auto here = sound_of_video(path("within"), 1'234, video.size());
            QVERIFY2(here.ok(), here.error().c_str());
            decode_in_helpers(&decoders_);
            const auto foreign = sound_of_video(path("within"), 1'234, video.size());
            QVERIFY2(foreign.ok(), foreign.error().c_str());
            QVERIFY((*foreign)->format() == (*here)->format());
            QVERIFY((*foreign)->depth() == (*here)->depth());
            QCOMPARE((*foreign)->frames(), (*here)->frames());
            const auto samples = all_of(**foreign, block);
            QVERIFY(samples.size() > 90'000);
            QVERIFY(samples == all_of(**here, block));
        }
    }

    void its_sentences_are_the_same() {
        std::ofstream(path("text"), std::ios::binary) << "no video at all";
        QVERIFY(make_video(path("silent"), {QString(), QString(), QStringLiteral("mp4"), {}, true}));
        for (const char* name : {"text", "silent", "nowhere"}) {
            decode_in_helpers(nullptr);
            const std::string here = sound_of_video(path(name), 0, 100'000).error();
            QVERIFY(!here.empty());
            decode_in_helpers(&decoders_);
            QCOMPARE(sound_of_video(path(name), 0, 100'000).error(), here);
        }
    }

    void two_are_read_side_by_side() {
        QVERIFY(make_video(path("video"), {}));
        const auto size = fs::file_size(path("video"));
        decode_in_helpers(&decoders_);
        const auto one = sound_of_video(path("video"), 0, size), two = sound_of_video(path("video"), 0, size);
        QVERIFY(one.ok() && two.ok());
        std::vector<std::int32_t> first(100), second(100);
        for (int i = 0; i < 20; ++i) {
            QCOMPARE((*one)->read(first), std::size_t{100});
            QCOMPARE((*two)->read(second), std::size_t{100});
            QVERIFY(first == second);
        }
    }

    void a_decoder_that_is_missing_is_a_sentence() {
        QVERIFY(make_video(path("video"), {}));
        ForeignDecoders none(path("no decoder"));
        decode_in_helpers(&none);
        const std::string sentence = sound_of_video(path("video"), 0, 100'000).error();
        QVERIFY2(sentence.find("no decoder") != std::string::npos, sentence.c_str());
    }

    void facts_that_cannot_be_are_refused_data() {
        QTest::addColumn<QVector<qint64>>("numbers"); // rate, channels, depth, frames
        QTest::addColumn<bool>("good");
        QTest::newRow("as they should be") << QVector<qint64>{48'000, 2, 16, 100} << true;
        QTest::newRow("no rate") << QVector<qint64>{0, 2, 16, 100} << false;
        QTest::newRow("a rate of no recording") << QVector<qint64>{1'000'000, 2, 16, 100} << false;
        QTest::newRow("no channels") << QVector<qint64>{48'000, 0, 16, 100} << false;
        QTest::newRow("many channels") << QVector<qint64>{48'000, 9, 16, 100} << false;
        QTest::newRow("a depth of none") << QVector<qint64>{48'000, 2, 17, 100} << false;
        QTest::newRow("fewer than no frames") << QVector<qint64>{48'000, 2, 16, -1} << false;
        QTest::newRow("too few") << QVector<qint64>{48'000, 2, 16} << false;
    }
    void facts_that_cannot_be_are_refused() {
        QFETCH(QVector<qint64>, numbers);
        QFETCH(bool, good);
        MessageWriter writer;
        writer.add(std::string_view());
        for (const qint64 number : numbers)
            writer.add(std::int64_t{number});
        Message message = writer.take();
        QCOMPARE(sound_facts(message).ok(), good);
    }
};

QTEST_GUILESS_MAIN(SoundOfVideoTest)
#include "sound_of_video_test.moc"
