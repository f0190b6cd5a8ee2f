// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/sound_format.hpp"
#include "audio/sound/stretcher.hpp"
#include "sound_files.hpp"
#include "test_program.hpp"

#include <QTest>

namespace stretcher_test {

using namespace tp;
using namespace tp::testing;

namespace {

std::vector<float> stretched(const std::vector<float>& samples, int rate, int channels, double speed) {
    Stretcher stretcher(rate, channels, speed);
    std::vector<float> result;
    const auto take = [&] {
        const auto out = stretcher.take();
        result.insert(result.end(), out.begin(), out.end());
    };
    for (std::size_t i = 0; i < samples.size(); i += 4096) {
        stretcher.put(std::span(samples).subspan(i, std::min<std::size_t>(4096, samples.size() - i)));
        take();
    }
    stretcher.end();
    take();
    return result;
}

} // namespace

class StretcherTest : public QObject {
    Q_OBJECT
private slots:
    void length_and_pitch_data() {
        QTest::addColumn<int>("rate");
        QTest::addColumn<double>("speed");
        for (const int rate : {8000, 44100, 48000, 96000})
            for (const double speed : {0.5, 0.75, 1.0, 1.5, 2.0})
                QTest::addRow("%d Hz at %.2f", rate, speed) << rate << speed;
    }

    void length_and_pitch() {
        QFETCH(int, rate);
        QFETCH(double, speed);
        std::vector<float> out = stretched(tone(440.0, 3.0, rate), rate, 1, speed);
        const double expected = 3.0 * sound_rate / speed;
        QVERIFY2(std::abs(static_cast<double>(out.size()) - expected) <= 1.0,
                 qPrintable(QString::number(out.size())));
        out.erase(out.begin(), out.begin() + sound_rate / 4);
        out.resize(out.size() - sound_rate / 4);
        const double hz = frequency_of(out, sound_rate);
        QVERIFY2(std::abs(hz - 440.0) < 4.4, qPrintable(QString::number(hz)));
    }

    void at_speed_one_the_samples_pass_unchanged() {
        const std::vector<float> samples = tone(700.0, 0.5, sound_rate);
        QCOMPARE(stretched(samples, sound_rate, 1, 1.0), samples);
    }

    void left_stays_left() {
        std::vector<float> samples;
        for (const float sample : tone(440.0, 1.0, sound_rate))
            samples.insert(samples.end(), {sample, 0.0F});
        const std::vector<float> out = stretched(samples, sound_rate, 2, 1.5);
        for (std::size_t i = 0; i + 1 < out.size(); i += 2)
            QCOMPARE(out[i + 1], 0.0F);
    }

    void nothing_in_nothing_out() { QVERIFY(stretched({}, 44100, 1, 0.5).empty()); }
};

} // namespace stretcher_test

TP_TEST(stretcher_test, StretcherTest, event_loop)
#include "stretcher_test.moc"
