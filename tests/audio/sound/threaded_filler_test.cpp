// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/sound_format.hpp"
#include "audio/sound/threaded_filler.hpp"
#include "sound_files.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

namespace threaded_filler_test {

using namespace tp;
using namespace tp::testing;

class ThreadedFillerTest : public QObject {
    Q_OBJECT
private slots:
    void it_is_ready_when_the_buffer_is_full() {
        const QTemporaryDir folder;
        const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "tone.wav";
        write_wav(file, tone(440.0, 3.0, sound_rate), sound_rate);
        ThreadedFiller filler;
        QSignalSpy ready(&filler, &StreamFiller::ready);
        const auto stream = std::make_shared<PlaybackStream>(PlaybackStream::What{file});
        filler.begin(7, stream);
        QTRY_COMPARE_WITH_TIMEOUT(ready.size(), 1, 60000);
        QCOMPARE(ready.last().at(0).value<quint64>(), 7u);
        QCOMPARE(stream->duration_s(), 3.0);
        QCOMPARE(stream->buffered(), 1.0);
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

} // namespace threaded_filler_test

TP_TEST(threaded_filler_test, ThreadedFillerTest, event_loop)
#include "threaded_filler_test.moc"
