// SPDX-License-Identifier: Apache-2.0
// The sound round a shutter: exactly that, and nothing where no shutter acts.
#include "audio/recordings/recording_file.hpp"
#include "audio/recordings/repair_folder.hpp"
#include "audio/sound/moment_recorder.hpp"
#include "audio/sound/moment_worker.hpp"
#include "audio/sound/sound_file.hpp"
#include "audio/sound/sound_format.hpp"
#include "fake_microphone.hpp"
#include "sound_files.hpp"
#include "test_program.hpp"

#include <QDate>
#include <QDateTime>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTime>
#include <QTimeZone>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace moment_test {

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;

namespace {

/// 26 November 2026, 14:03:22, two hours and a half east of Greenwich.
QDateTime a_time() { return {QDate(2026, 11, 26), QTime(14, 3, 22), QTimeZone(9000)}; }

/// A sound in which every sample tells where it is: the number of the sample since the beginning, as far as 16 bits go.
float sample_at(std::size_t number) {
    return static_cast<float>(static_cast<std::int16_t>(number * 7919)) / 32767.0F;
}

struct Bench {
    QTemporaryDir place;
    fs::path root = place.path().toStdString();
    fs::path folder = root / "a.jpg.tags";
    std::uint64_t free = 10'000'000'000;
    bool microphone_there = true;
    FakeMicrophone* microphone = nullptr;
    std::size_t heard = 0; ///< samples since the beginning
    MomentWorker moment{[this] {
                            auto made = std::make_unique<FakeMicrophone>();
                            microphone = made.get();
                            microphone->there = microphone_there;
                            return made;
                        },
                        [this](const fs::path&) { return std::optional(free); }};
    QSignalSpy kept{&moment, &MomentWorker::kept};
    QSignalSpy failed{&moment, &MomentWorker::failed};
    QSignalSpy hearing{&moment, &MomentWorker::hearing_changed};

    void hear(double seconds) {
        std::vector<float> samples(static_cast<std::size_t>(std::lround(seconds * sound_rate)));
        for (float& sample : samples)
            sample = sample_at(heard++);
        microphone->hear(samples);
    }
    FinishedRecording result(int number = 0) const {
        return kept.at(number).at(1).value<FinishedRecording>();
    }
    /// Whether a recording is exactly the samples from one place to another of all that was heard.
    bool is_exactly(const fs::path& file, std::size_t from, std::size_t to) const {
        auto sound = SoundFile::open(file);
        if (!sound)
            return false;
        const std::vector<float> samples = sound.value().read(60 * sound_rate);
        if (samples.size() != to - from)
            return false;
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (std::abs(samples[i] - sample_at(from + i)) > 1.0F / 16384.0F)
                return false;
        return true;
    }
    std::size_t files() const {
        std::size_t count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(root))
            count += entry.is_regular_file();
        return count;
    }
};

constexpr auto rate = static_cast<std::size_t>(sound_rate);

} // namespace

class MomentTest : public QObject {
    Q_OBJECT
private slots:
    void five_seconds_before_and_five_after() {
        Bench bench;
        bench.moment.listen();
        bench.hear(12.345);
        const std::size_t shutter = bench.heard;
        bench.moment.shutter(1);
        bench.hear(0.7); // until the photograph is on the disk
        QCOMPARE(bench.files(), std::size_t{0});
        bench.moment.keep(1, bench.folder, a_time());
        QCOMPARE(bench.files(), std::size_t{1}); // the part, from the first moment on
        bench.hear(6.0);
        QCOMPARE(bench.kept.size(), 1);
        QCOMPARE(bench.kept.at(0).at(0).toULongLong(), quint64{1});
        const FinishedRecording result = bench.result();
        QCOMPARE(result.duration_s, 10.0);
        QVERIFY(bench.is_exactly(result.file, shutter - 5 * rate, shutter + 5 * rate));
        QCOMPARE(result.sentence, QString("Recorded: 10 seconds."));
        const auto about = about_recording(result.file);
        QVERIFY(about && about->notes.label.kind == RecordingKind::ambient);
        QCOMPARE(about->notes.label.recorded, std::string("2026-11-26T14:03:17+02:30"));
        QCOMPARE(bench.files(), std::size_t{1});
        QVERIFY(bench.microphone->on());
    }

    void nothing_is_written_where_no_shutter_acts() {
        Bench bench;
        bench.moment.listen();
        bench.hear(20.0);
        bench.moment.rest();
        bench.moment.listen();
        bench.hear(3.0);
        QVERIFY(!fs::exists(bench.folder));
        QCOMPARE(bench.files(), std::size_t{0});
        QCOMPARE(bench.kept.size() + bench.failed.size(), 0);
    }

    void nor_where_what_it_took_is_not_kept() {
        Bench bench;
        bench.moment.listen();
        bench.hear(6.0);
        bench.moment.shutter(1);
        bench.hear(2.0);
        bench.moment.drop(1);
        bench.moment.shutter(2);
        bench.hear(9.0);
        bench.moment.keep(1, bench.folder, a_time()); // too late
        QCOMPARE(bench.files(), std::size_t{0});
        QCOMPARE(bench.kept.size() + bench.failed.size(), 0);
    }

    void it_may_be_kept_when_it_is_over() {
        Bench bench;
        bench.moment.listen();
        bench.hear(7.0);
        const std::size_t shutter = bench.heard;
        bench.moment.shutter(3);
        bench.hear(15.0);
        bench.moment.keep(3, bench.folder, a_time());
        QCOMPARE(bench.kept.size(), 1);
        QVERIFY(bench.is_exactly(bench.result().file, shutter - 5 * rate, shutter + 5 * rate));
    }

    void of_less_than_five_seconds_there_is_what_there_was() {
        Bench bench;
        bench.moment.listen();
        bench.hear(2.0);
        bench.moment.shutter(1);
        bench.moment.keep(1, bench.folder, a_time());
        bench.hear(5.0);
        QCOMPARE(bench.result().duration_s, 7.0);
        QVERIFY(bench.is_exactly(bench.result().file, 0, 7 * rate));
        QCOMPARE(about_recording(bench.result().file)->notes.label.recorded,
                 std::string("2026-11-26T14:03:20+02:30"));
    }

    void two_shutters_in_a_row_have_each_its_own() {
        Bench bench;
        bench.moment.listen();
        bench.hear(6.0);
        const std::size_t first = bench.heard;
        bench.moment.shutter(1);
        bench.moment.keep(1, bench.folder, a_time());
        bench.hear(2.0);
        const std::size_t second = bench.heard;
        bench.moment.shutter(2);
        bench.moment.keep(2, bench.folder, a_time().addSecs(2));
        bench.hear(8.0);
        QCOMPARE(bench.kept.size(), 2);
        QVERIFY(bench.is_exactly(bench.result(0).file, first - 5 * rate, first + 5 * rate));
        QVERIFY(bench.is_exactly(bench.result(1).file, second - 5 * rate, second + 5 * rate));
        QVERIFY(bench.result(0).file != bench.result(1).file);
    }

    void who_rests_keeps_what_there_is() {
        Bench bench;
        bench.moment.listen();
        bench.hear(6.0);
        bench.moment.shutter(1);
        bench.moment.keep(1, bench.folder, a_time());
        bench.hear(1.5);
        bench.moment.rest();
        QVERIFY(!bench.microphone->on());
        QCOMPARE(bench.result().duration_s, 6.5);
        bench.moment.listen(); // what was before is forgotten
        bench.moment.shutter(2);
        bench.moment.keep(2, bench.folder, a_time());
        QCOMPARE(bench.failed.size(), 1);
        QCOMPARE(bench.failed.at(0).at(1).toString(), QString("Nothing was recorded."));
    }

    void a_microphone_that_goes_ends_it_and_one_that_comes_goes_on() {
        Bench bench;
        bench.moment.listen();
        bench.hear(6.0);
        bench.moment.shutter(1);
        bench.moment.keep(1, bench.folder, a_time());
        bench.hear(1.0);
        bench.microphone->vanish();
        QCOMPARE(bench.result().duration_s, 6.0);
        bench.microphone->come();
        const std::size_t again = bench.heard;
        bench.hear(6.0);
        bench.moment.shutter(2);
        bench.moment.keep(2, bench.folder, a_time());
        bench.hear(5.0);
        QVERIFY(bench.is_exactly(bench.result(1).file, again + rate, again + 11 * rate));
        QCOMPARE(bench.hearing.size(), 3); // on, off, on
    }

    void without_a_microphone_it_says_that_nothing_was_recorded() {
        Bench bench;
        bench.microphone_there = false;
        bench.moment.listen();
        bench.moment.shutter(1);
        bench.moment.keep(1, bench.folder, a_time());
        QCOMPARE(bench.failed.size(), 1);
        QVERIFY(!fs::exists(bench.folder));
        QCOMPARE(bench.hearing.size(), 0);
    }

    void a_full_disk_is_said_before_anything_is_written() {
        Bench bench;
        bench.free = kept_free_bytes;
        bench.moment.listen();
        bench.hear(6.0);
        bench.moment.shutter(1);
        bench.moment.keep(1, bench.folder, a_time());
        QCOMPARE(bench.failed.size(), 1);
        QVERIFY(bench.failed.at(0).at(1).toString().endsWith('.'));
        QCOMPARE(bench.files(), std::size_t{0});
    }

    void a_program_that_ends_leaves_a_part_that_is_repaired() {
        QTemporaryDir place;
        const fs::path folder = fs::path(place.path().toStdString()) / "a.jpg.tags";
        {
            FakeMicrophone* microphone = nullptr;
            MomentWorker moment([&microphone] {
                auto made = std::make_unique<FakeMicrophone>();
                microphone = made.get();
                return made;
            });
            moment.listen();
            microphone->hear_nothing(6.0);
            moment.shutter(1);
            moment.keep(1, folder, a_time());
            microphone->hear_nothing(1.0);
        }
        const auto repaired = repair_folder(folder);
        QVERIFY(repaired);
        QCOMPARE(repaired->size(), std::size_t{1});
        QCOMPARE(about_recording(repaired->front().file)->seconds(), 6.0);
    }

    void moments_that_nobody_wants_are_not_collected() {
        Bench bench;
        bench.moment.listen();
        bench.hear(5.0);
        for (quint64 number = 1; number <= MomentWorker::most_open + 1; ++number)
            bench.moment.shutter(number);
        bench.hear(5.0);
        bench.moment.keep(1, bench.folder, a_time());
        QCOMPARE(bench.kept.size(), 0);
        bench.moment.keep(2, bench.folder, a_time());
        QCOMPARE(bench.kept.size(), 1);
    }

    void on_a_thread_of_its_own() {
        QTemporaryDir place;
        const fs::path folder = fs::path(place.path().toStdString()) / "a.jpg.tags";
        /// Hears ten seconds whenever it is started.
        class Chatter final : public SoundInput {
        public:
            void start() override {
                const std::vector<std::int16_t> samples(10 * sound_rate, 1000);
                emit block(samples);
            }
            void stop() override {}
        };
        MomentRecorder moment([] { return std::make_unique<Chatter>(); });
        QSignalSpy kept(&moment, &MomentRecorder::kept);
        moment.listen();
        const quint64 number = moment.shutter();
        moment.keep(number, folder, a_time());
        moment.rest();
        QTRY_COMPARE(kept.size(), 1);
        QCOMPARE(kept.at(0).at(0).toULongLong(), number);
        QCOMPARE(kept.at(0).at(1).value<FinishedRecording>().duration_s, 5.0);
        QTRY_VERIFY(!moment.hears());
    }
};

} // namespace moment_test

TP_TEST(moment_test, MomentTest, event_loop)
#include "moment_test.moc"
