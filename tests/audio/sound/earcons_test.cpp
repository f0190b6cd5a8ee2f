// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/earcon_synth.hpp"
#include "audio/sound/earcons.hpp"
#include "audio/sound/sound_format.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <vector>

namespace earcons_test {

using namespace tp;

namespace {

using Samples = std::span<const float>;

/// Energy of the sound at `hz` (Goertzel).
double energy_at(double hz, Samples samples) {
    const double twice_cosine = 2.0 * std::cos(2.0 * std::numbers::pi * hz / sound_rate);
    double s1 = 0.0;
    double s2 = 0.0;
    for (const float x : samples) {
        const double s0 = x + twice_cosine * s1 - s2;
        s2 = s1;
        s1 = s0;
    }
    return s1 * s1 + s2 * s2 - twice_cosine * s1 * s2;
}

/// How much of each third of an octave from 300 to 3000 Hz there is in each 20 ms, as a vector of length 1:
/// what an ear could tell two sounds apart by.
std::vector<double> fingerprint(Samples samples) {
    constexpr int window = sound_rate / 50;
    std::vector<double> result;
    double square = 0.0;
    for (int begin = 0; begin < 15 * window; begin += window)
        for (double hz = 300.0; hz < 3100.0; hz *= std::cbrt(2.0)) {
            double energy = 0.0;
            if (static_cast<std::size_t>(begin) < samples.size())
                energy = energy_at(
                    hz, samples.subspan(
                            static_cast<std::size_t>(begin),
                            std::min<std::size_t>(window, samples.size() - static_cast<std::size_t>(begin))));
            result.push_back(
                std::sqrt(std::sqrt(std::max(0.0, energy)))); // loudness grows slower than amplitude
            square += result.back() * result.back();
        }
    for (double& value : result)
        value /= std::sqrt(square);
    return result;
}

double likeness(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

} // namespace

class EarconsTest : public QObject {
    Q_OBJECT
private slots:
    void each_data() {
        QTest::addColumn<Earcon>("earcon");
        for (const Earcon earcon : every_earcon)
            QTest::newRow(std::string(name_of(earcon)).c_str()) << earcon;
    }

    void each() {
        QFETCH(Earcon, earcon);
        const Samples samples = samples_of(earcon);
        QVERIFY(samples.size() >= sound_rate * 20 / 1000);
        QVERIFY(samples.size() <= sound_rate * 300 / 1000);
        QCOMPARE(samples.front(), 0.0F);
        QVERIFY(std::abs(samples.back()) < 1e-6F);
        const float peak = std::ranges::max(samples, {}, [](float x) { return std::abs(x); });
        QVERIFY(std::abs(std::abs(peak) - earcon_peak) < 1e-6);
        // a click would be steeper than a full tone of 3000 Hz at the peak
        const double steepest = earcon_peak * 2.0 * std::numbers::pi * 3000.0 / sound_rate;
        for (std::size_t i = 1; i < samples.size(); ++i)
            QVERIFY(std::abs(samples[i] - samples[i - 1]) <= steepest);
    }

    void most_of_each_is_where_older_ears_hear_data() { each_data(); }
    void most_of_each_is_where_older_ears_hear() {
        QFETCH(Earcon, earcon);
        double inside = 0.0;
        double all = 0.0;
        for (double hz = 20.0; hz < 20000.0; hz += 20.0) {
            const double energy = energy_at(hz, samples_of(earcon));
            all += energy;
            if (hz >= 290.0 && hz <= 3000.0)
                inside += energy;
        }
        QVERIFY2(inside > 0.95 * all, qPrintable(QString::number(inside / all)));
    }

    void no_two_sound_alike() {
        std::map<Earcon, std::vector<double>> prints;
        for (const Earcon earcon : every_earcon)
            prints[earcon] = fingerprint(samples_of(earcon));
        for (const Earcon one : every_earcon)
            for (const Earcon other : every_earcon)
                if (one < other) {
                    const double like = likeness(prints[one], prints[other]);
                    qDebug("%s, %s: %.2f", name_of(one).data(), name_of(other).data(), like);
                    QVERIFY2(like < 0.8, qPrintable(QString("%1 and %2: %3")
                                                        .arg(QString::fromUtf8(name_of(one).data()),
                                                             QString::fromUtf8(name_of(other).data()))
                                                        .arg(like)));
                }
    }

    void nothing_is_rendered_from_nothing() { QVERIFY(render_tones({}).empty()); }
};

} // namespace earcons_test

TP_TEST(earcons_test, EarconsTest, event_loop)
#include "earcons_test.moc"
