// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace tp::testing {

/// A tone of so many Hz, amplitude ±1.
inline std::vector<float> tone(double hz, double seconds, int rate, double amplitude = 0.5) {
    std::vector<float> samples(static_cast<std::size_t>(std::llround(seconds * rate)));
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = static_cast<float>(
            amplitude * std::sin(2.0 * std::numbers::pi * hz * static_cast<double>(i) / rate));
    return samples;
}

/// A WAV file of 16 bit, one channel.
inline void write_wav(const std::filesystem::path& file, const std::vector<float>& samples, int rate) {
    std::string bytes = "RIFF";
    const auto number = [&bytes](std::size_t value, int count) {
        for (int i = 0; i < count; ++i)
            bytes += static_cast<char>((value >> (8 * i)) & 0xFFU);
    };
    number(36 + 2 * samples.size(), 4);
    bytes += "WAVEfmt ";
    number(16, 4);
    number(1, 2);
    number(1, 2);
    number(static_cast<std::size_t>(rate), 4);
    number(static_cast<std::size_t>(rate) * 2, 4);
    number(2, 2);
    number(16, 2);
    bytes += "data";
    number(2 * samples.size(), 4);
    for (const float sample : samples)
        number(static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(sample * 32767.0F))), 2);
    std::ofstream(file, std::ios::binary) << bytes;
}

/// The frequency of a steady tone, from its rising zero crossings.
inline double frequency_of(const std::vector<float>& samples, int rate) {
    double first = -1.0;
    double last = -1.0;
    int count = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        if (samples[i - 1] >= 0.0F || samples[i] < 0.0F)
            continue;
        const double at = static_cast<double>(i) - samples[i] / (samples[i] - samples[i - 1]);
        if (count++ == 0)
            first = at;
        last = at;
    }
    return count < 2 ? 0.0 : (count - 1) * rate / (last - first);
}

} // namespace tp::testing
