// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/earcon_synth.hpp"

#include "audio/sound/sound_format.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace tp {

namespace {

constexpr double died_away = 4.605170186; // ln 100: −40 dB
constexpr int samples_in(int ms) { return ms * sound_rate / 1000; }

/// Of sample `i` out of `count`; zero at the first and the last.
double loudness(Envelope envelope, int i, int count) {
    const int edge = std::min(samples_in(edge_ms), count / 2);
    const int from_end = std::min(i, count - 1 - i);
    const double rounded = from_end >= edge ? 1.0 : 0.5 - 0.5 * std::cos(std::numbers::pi * from_end / edge);
    return envelope == Envelope::steady ? rounded : rounded * std::exp(-died_away * i / count);
}

void add(const Tone& tone, std::vector<float>& samples) {
    const int begin = samples_in(tone.begin_ms);
    const int count = samples_in(tone.duration_ms);
    double phase = 0.0;
    for (int i = 0; i < count; ++i) {
        const double along = static_cast<double>(i) / count;
        const double value = std::sin(phase) + tone.third_harmonic * std::sin(3.0 * phase);
        samples[static_cast<std::size_t>(begin + i)] +=
            static_cast<float>(value * loudness(tone.envelope, i, count));
        const double hz = tone.from_hz * std::pow(tone.to_hz / tone.from_hz, along);
        phase += 2.0 * std::numbers::pi * hz / sound_rate;
    }
}

} // namespace

std::vector<float> render_tones(std::span<const Tone> tones) {
    int end_ms = 0;
    for (const Tone& tone : tones)
        end_ms = std::max(end_ms, tone.begin_ms + tone.duration_ms);
    std::vector<float> samples(static_cast<std::size_t>(samples_in(end_ms)));
    for (const Tone& tone : tones)
        add(tone, samples);
    float peak = 0.0F;
    for (const float sample : samples)
        peak = std::max(peak, std::abs(sample));
    if (peak > 0.0F)
        for (float& sample : samples)
            sample *= static_cast<float>(earcon_peak) / peak;
    return samples;
}

} // namespace tp
