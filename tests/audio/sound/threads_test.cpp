// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/playback_stream.hpp"
#include "audio/sound/sample_ring.hpp"
#include "audio/sound/sound_format.hpp"
#include "audio/sound/threaded_filler.hpp"
#include "sound_files.hpp"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <array>
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

        ThreadedFiller filler;
        QSignalSpy ready(&filler, &StreamFiller::ready);
        auto stream = std::make_shared<PlaybackStream>(PlaybackStream::What{file});
        filler.begin(7, stream);
        QTRY_COMPARE_WITH_TIMEOUT(ready.size(), 1, 60000);
        QCOMPARE(ready.last().at(0).value<quint64>(), 7u);

        std::atomic<bool> over{false};
        std::size_t sounded = 0;
        std::thread listener([&] {
            std::array<float, 960> block{};
            for (std::int64_t frames = 0; !over;) {
                const std::size_t got = stream->pull(block);
                for (std::size_t i = 0; i < got; ++i)
                    sounded += block[i] != 0.0F ? 1 : 0;
                frames += static_cast<std::int64_t>(got) / played_channels;
                stream->heard(frames);
                over = got < block.size();
            }
        });
        while (!over)
            QTest::qWait(1); // lets the filler's thread speak to this one
        listener.join();
        QVERIFY(sounded > 2 * source.size() * 9 / 10); // all but the tone's own zeros
        QVERIFY(std::abs(stream->position_s() - 6.0) < 1e-3);
    }

    void what_cannot_be_read_is_said() {
        ThreadedFiller filler;
        QSignalSpy unreadable(&filler, &StreamFiller::unreadable);
        filler.begin(1, std::make_shared<PlaybackStream>(PlaybackStream::What{"/nowhere/story.flac"}));
        QTRY_COMPARE_WITH_TIMEOUT(unreadable.size(), 1, 60000);
        QVERIFY(unreadable.last().at(1).toString().contains("story.flac"));
    }

    void a_stream_can_be_left_at_any_time() {
        const QTemporaryDir folder;
        const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "tone.wav";
        write_wav(file, tone(440.0, 3.0, sound_rate), sound_rate);
        ThreadedFiller filler;
        for (quint64 run = 1; run < 30; ++run) {
            filler.begin(run, std::make_shared<PlaybackStream>(PlaybackStream::What{file, 0.5, 1.5}));
            if (run % 3 == 0)
                filler.leave();
        }
    }
};

QTEST_GUILESS_MAIN(ThreadsTest)
#include "threads_test.moc"
