// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/sound_peaks.hpp"
#include "sound_files.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace sound_peaks_test {

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;

class SoundPeaksTest : public QObject {
    Q_OBJECT
    QTemporaryDir dir_;
    fs::path file(const std::vector<float>& samples, int rate = 48'000) const {
        const fs::path place = fs::path(dir_.path().toStdString()) / "sound.wav";
        write_wav(place, samples, rate);
        return place;
    }

private slots:
    void a_loud_second_after_a_soft_one_is_seen_where_it_is() {
        std::vector<float> samples = tone(440.0, 1.0, 48'000, 0.1);
        const std::vector<float> loud = tone(440.0, 1.0, 48'000, 0.8);
        samples.insert(samples.end(), loud.begin(), loud.end());
        const auto peaks = sound_peaks(file(samples), 100);
        QVERIFY(peaks.ok());
        QCOMPARE(peaks->peaks.size(), std::size_t{100});
        QVERIFY(std::abs(peaks->duration_s - 2.0) < 1e-9);
        for (std::size_t i = 0; i < 49; ++i)
            QVERIFY(std::abs(peaks->peaks[i] - 0.1F) < 0.005F);
        for (std::size_t i = 51; i < 100; ++i)
            QVERIFY(std::abs(peaks->peaks[i] - 0.8F) < 0.01F);
    }

    void one_loud_sample_is_never_lost() {
        for (const std::size_t at : {std::size_t{0}, std::size_t{7'777}, std::size_t{12'344}}) {
            std::vector<float> samples(12'345, 0.0F);
            samples[at] = -1.0F;
            const auto peaks = sound_peaks(file(samples), 37);
            QVERIFY(peaks.ok());
            QCOMPARE(peaks->peaks.size(), std::size_t{37});
            QCOMPARE(std::count_if(peaks->peaks.begin(), peaks->peaks.end(), [](float p) { return p > 0.9F; }), 1);
            const auto loudest = std::max_element(peaks->peaks.begin(), peaks->peaks.end()) - peaks->peaks.begin();
            QVERIFY(std::abs(static_cast<double>(loudest) - 37.0 * static_cast<double>(at) / 12'345.0) <= 1.5);
        }
    }

    void a_very_short_sound_has_fewer_parts() {
        const auto peaks = sound_peaks(file({0.5F, -0.25F, 0.125F}), 400);
        QVERIFY(peaks.ok());
        QCOMPARE(peaks->peaks.size(), std::size_t{3});
        QVERIFY(std::abs(peaks->peaks[1] - 0.25F) < 1e-3F);
    }

    void what_is_no_sound_is_an_error() {
        const fs::path place = fs::path(dir_.path().toStdString()) / "no.wav";
        std::ofstream(place) << "not a sound";
        QVERIFY(!sound_peaks(place, 100).error().empty());
        QVERIFY(!sound_peaks("/nowhere/at/all.wav", 100).error().empty());
    }
};

} // namespace sound_peaks_test

TP_TEST(sound_peaks_test, SoundPeaksTest, nothing)
#include "sound_peaks_test.moc"
