// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/playback_stream.hpp"
#include "audio/sound/sample_ring.hpp"
#include "audio/sound/sound_format.hpp"
#include "sound_files.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <atomic>
#include <filesystem>
#include <thread>

using namespace tp;
using namespace tp::testing;

class ThreadsTest : public QObject {
    Q_OBJECT
private slots:
    void a_ring_gives_everything_in_order() {
        SampleRing ring(1000);
        constexpr int count = 200'000;
        std::thread writer([&ring] {
            std::array<float, 77> block{};
            for (int next = 0; next < count;) {
                const auto size = static_cast<std::size_t>(std::min<int>(block.size(), count - next));
                for (std::size_t i = 0; i < size; ++i)
                    block[i] = static_cast<float>(next + static_cast<int>(i));
                next += static_cast<int>(ring.write(std::span(block).first(size)));
            }
        });
        std::array<float, 131> block{};
        int wrong = 0;
        for (int next = 0; next < count;)
            for (std::size_t i = 0, got = ring.read(block); i < got; ++i)
                wrong += block[i] != static_cast<float>(next++) ? 1 : 0;
        writer.join();
        QCOMPARE(wrong, 0);
        QCOMPARE(ring.filled(), 0u);
    }

    void a_full_ring_takes_no_more() {
        SampleRing ring(8);
        QCOMPARE(ring.write(std::array<float, 20>{}), 8u);
        QCOMPARE(ring.write(std::array<float, 1>{}), 0u);
        std::array<float, 20> out{};
        QCOMPARE(ring.read(out), 8u);
        QCOMPARE(ring.read(out), 0u);
    }

    /// Decoded on one thread, heard on another, watched from a third.
    void a_recording_passes_through_three_threads() {
        const QTemporaryDir folder;
        const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "tone.wav";
        const std::vector<float> source = tone(440.0, 6.0, sound_rate);
        write_wav(file, source, sound_rate);

        PlaybackStream stream(PlaybackStream::What{file});
        QCOMPARE(stream.open(), std::string());
        std::thread decoder([&stream] {
            while (stream.fill())
                std::this_thread::yield();
        });

        std::atomic<bool> over{false};
        std::size_t sounded = 0;
        std::thread listener([&] {
            std::array<float, 960> block{};
            for (std::int64_t frames = 0; !over;) {
                const std::size_t got = stream.pull(block);
                for (std::size_t i = 0; i < got; ++i)
                    sounded += block[i] != 0.0F ? 1 : 0;
                frames += static_cast<std::int64_t>(got) / played_channels;
                stream.heard(frames);
                over = got < block.size();
            }
        });
        double before = 0.0;
        int backwards = 0;
        while (!over) {
            const double now = stream.position_s();
            backwards += now < before ? 1 : 0;
            before = now;
        }
        listener.join();
        decoder.join();
        QCOMPARE(backwards, 0);
        QVERIFY(sounded > 2 * source.size() * 9 / 10); // all but the tone's own zeros
        QVERIFY(std::abs(stream.position_s() - 6.0) < 1e-3);
    }
};

QTEST_GUILESS_MAIN(ThreadsTest)
#include "threads_test.moc"
