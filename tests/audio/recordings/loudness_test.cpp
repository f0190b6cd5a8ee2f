// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/level.hpp"
#include "audio/recordings/loudness.hpp"
#include "sounds.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

namespace loudness_test {

using namespace tp;
using namespace tp::test;

namespace {

double amplitude(double dbfs) { return std::pow(10.0, dbfs / 20.0); }

std::vector<std::int16_t> narrowed(const std::vector<std::int32_t>& samples) {
    std::vector<std::int16_t> result;
    for (const std::int32_t sample : samples)
        result.push_back(static_cast<std::int16_t>(sample / 65'536));
    return result;
}

/// Both channels the same.
std::vector<std::int32_t> doubled(const std::vector<std::int32_t>& samples) {
    std::vector<std::int32_t> result;
    for (const std::int32_t sample : samples)
        result.insert(result.end(), 2, sample);
    return result;
}

Loudness loudness(const std::vector<std::int32_t>& samples, const SoundFormat& format = {}) {
    LoudnessMeter meter(format);
    meter.add(samples);
    return meter.loudness();
}

void append(std::vector<std::int32_t>& to, const std::vector<std::int32_t>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

} // namespace

class LoudnessTest : public QObject {
    Q_OBJECT

private slots:
    /// EBU Tech 3341, minimum requirements test signals 1 to 3, shorter.
    void signals_of_the_ebu() {
        for (const double dbfs : {-23.0, -33.0}) {
            const auto signal = doubled(tone(amplitude(dbfs), 10.0, 1000.0));
            const auto measured = loudness(signal, {48'000, 2}).integrated_lufs;
            QVERIFY2(measured && near(*measured, dbfs, 0.1), std::to_string(measured.value_or(0)).c_str());
        }
        std::vector<std::int32_t> gated = tone(amplitude(-36.0), 2.0, 1000.0);
        append(gated, tone(amplitude(-23.0), 12.0, 1000.0));
        append(gated, tone(amplitude(-36.0), 2.0, 1000.0));
        QVERIFY(near(*loudness(doubled(gated), {48'000, 2}).integrated_lufs, -23.0, 0.1));
    }

    void mono_counts_as_it_is_played() {
        const auto signal = tone(amplitude(-23.0), 5.0, 1000.0);
        QVERIFY(near(*loudness(signal).integrated_lufs,
                     *loudness(doubled(signal), {48'000, 2}).integrated_lufs, 1e-6));
    }

    /// EBU Tech 3341, test signal 15: a quarter of the rate, its peaks between the samples.
    void peaks_between_the_samples() {
        std::vector<std::int32_t> signal(48'000);
        for (std::size_t i = 0; i < signal.size(); ++i)
            signal[i] = static_cast<std::int32_t>(
                0.5 * 2147483647.0 *
                std::sin(std::numbers::pi / 2 * static_cast<double>(i) + std::numbers::pi / 4));
        const double peak = loudness(signal).true_peak_dbtp;
        QVERIFY2(peak > -6.4 && peak < -5.8, std::to_string(peak).c_str());
    }

    void gain_brings_to_the_target_and_never_clips() {
        QVERIFY(near(loudness(tone(amplitude(-30.0), 5.0)).gain_db(), 12.0, 0.2));
        QVERIFY(near(loudness(tone(amplitude(-6.0), 5.0)).gain_db(), -12.0, 0.2));
        std::vector<std::int32_t> click = tone(amplitude(-30.0), 5.0);
        click[1000] = 2147483647;
        const Loudness clicked = loudness(click);
        QVERIFY(clicked.gain_db() + clicked.true_peak_dbtp <= highest_true_peak_dbtp + 1e-9);
        QVERIFY(near(loudness(tone(amplitude(-65.0), 5.0)).gain_db(), largest_gain_db, 1e-9));
    }

    void what_has_no_loudness_has_no_gain() {
        for (const auto& signal : {std::vector<std::int32_t>(), std::vector<std::int32_t>(480'000),
                                   tone(0.5, 0.39), tone(amplitude(-80.0), 5.0)}) {
            QVERIFY(!loudness(signal).integrated_lufs);
            QCOMPARE(loudness(signal).gain_db(), 0.0);
        }
        QVERIFY(std::isinf(loudness({}).true_peak_dbtp));
    }

    void measured_as_it_comes_it_is_the_same() {
        const auto sound = noise(100'000);
        LoudnessMeter whole({});
        whole.add(widened(sound));
        LoudnessMeter pieces({});
        for (std::size_t at = 0; at < sound.size(); at += 777)
            pieces.add(std::span(sound).subspan(at, std::min<std::size_t>(777, sound.size() - at)));
        QCOMPARE(*pieces.loudness().integrated_lufs, *whole.loudness().integrated_lufs);
        QVERIFY(near(pieces.loudness().true_peak_dbtp, whole.loudness().true_peak_dbtp, 1e-6));
    }

    void of_a_file() {
        const QTemporaryDir dir;
        const std::filesystem::path file = dir.filePath("a.flac").toStdString();
        const auto signal = tone(amplitude(-23.0), 3.0);
        MemorySound sound(signal, {});
        QVERIFY(store_flac(sound, {}, file).ok());
        const auto measured = loudness_of(file);
        QVERIFY(measured.ok());
        QVERIFY(near(*measured->integrated_lufs, *loudness(signal).integrated_lufs, 0.01));
        QVERIFY(loudness_of(dir.filePath("missing").toStdString()).error().ends_with('.'));
    }

    void level_of_a_sine() {
        LevelMeter meter({});
        QVERIFY(std::isinf(meter.level().rms_dbfs));
        for (const double dbfs : {-0.01, -20.0, -55.0}) {
            meter.add(narrowed(tone(amplitude(dbfs), 0.1, 1000.0)));
            QVERIFY2(near(meter.level().rms_dbfs, dbfs, 0.1), std::to_string(meter.level().rms_dbfs).c_str());
            QVERIFY(near(meter.level().peak_dbfs, dbfs, 0.1));
        }
        meter.add(std::vector<std::int16_t>(4'800));
        QVERIFY(std::isinf(meter.level().rms_dbfs) && std::isinf(meter.level().peak_dbfs));
        meter.add(std::vector<std::int16_t>(4'800, -32'768));
        QCOMPARE(meter.level().peak_dbfs, 0.0);
        QVERIFY(std::isinf(meter.level().rms_dbfs));
    }

    void a_muted_microphone_is_told_after_a_second() {
        LevelMeter meter({});
        meter.add(std::vector<std::int16_t>(47'999));
        QVERIFY(!meter.hears_nothing());
        meter.add(std::vector<std::int16_t>(1));
        QVERIFY(meter.hears_nothing());
        meter.add(narrowed(tone(0.1, 0.05)));
        QVERIFY(!meter.hears_nothing());
        meter.add(std::vector<std::int16_t>(48'000, 5)); // stuck at one value
        QVERIFY(meter.hears_nothing());
    }

    void a_quiet_one_after_three() {
        LevelMeter meter({48'000, 2});
        const auto hiss = narrowed(doubled(tone(amplitude(-70.0), 2.95)));
        meter.add(hiss);
        QVERIFY(!meter.hears_nothing());
        meter.add(std::span(hiss).first(4'800));
        QVERIFY(meter.hears_nothing());
    }

    void a_quiet_room_is_heard() {
        LevelMeter meter({});
        meter.add(narrowed(tone(amplitude(-58.0), 10.0)));
        QVERIFY(!meter.hears_nothing());
    }

    void one_channel_is_enough() {
        auto left = narrowed(doubled(tone(0.1, 5.0)));
        for (std::size_t i = 1; i < left.size(); i += 2)
            left[i] = 0;
        LevelMeter meter({48'000, 2});
        meter.add(left);
        QVERIFY(!meter.hears_nothing());
        QVERIFY(near(meter.level().rms_dbfs, -20.0, 0.1));
    }

    void level_does_not_depend_on_how_it_is_cut() {
        const auto sound = noise(50'000);
        LevelMeter whole({48'000, 2});
        whole.add(sound);
        LevelMeter pieces({48'000, 2});
        for (std::size_t at = 0; at < sound.size(); at += 62)
            pieces.add(std::span(sound).subspan(at, std::min<std::size_t>(62, sound.size() - at)));
        QCOMPARE(pieces.level().rms_dbfs, whole.level().rms_dbfs);
        QCOMPARE(pieces.level().peak_dbfs, whole.level().peak_dbfs);
    }
};

} // namespace loudness_test

TP_TEST(loudness_test, LoudnessTest, event_loop)
#include "loudness_test.moc"
