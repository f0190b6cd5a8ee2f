// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/guide/sonar_stream.hpp"
#include "audio/sound/sound_format.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace tp::testing {

/// What a stream sounds like, channel by channel.
struct HeardSound {
    std::vector<float> left, right;

    /// Pulls so many seconds in blocks of 10 ms.
    void listen(SonarStream& stream, double seconds) {
        std::vector<float> block(played_channels * sound_rate / 100);
        for (auto blocks = static_cast<int>(100.0 * seconds + 0.5); blocks > 0; --blocks) {
            const std::size_t got = stream.pull(block) / played_channels;
            for (std::size_t i = 0; i < got; ++i) {
                left.push_back(block[i * played_channels]);
                right.push_back(block[i * played_channels + 1]);
            }
        }
    }
    static double peak(const std::vector<float>& samples, std::size_t from = 0) {
        double most = 0.0;
        for (std::size_t i = from; i < samples.size(); ++i)
            most = std::max(most, static_cast<double>(std::abs(samples[i])));
        return most;
    }
    /// Frames at which sound begins after at least 4 ms of silence.
    static std::vector<std::size_t> onsets(const std::vector<float>& samples) {
        std::vector<std::size_t> begins;
        std::size_t quiet = sound_rate;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (std::abs(samples[i]) > 1e-5F) {
                if (quiet > sound_rate / 250)
                    begins.push_back(i);
                quiet = 0;
            } else {
                ++quiet;
            }
        }
        return begins;
    }
    /// Hertz between two frames, from the first and the last rising zero crossing there.
    static double hertz(const std::vector<float>& samples, std::size_t from, std::size_t to) {
        double first = 0.0;
        double last = 0.0;
        int periods = -1;
        for (std::size_t i = from + 1; i < to && i < samples.size(); ++i)
            if (samples[i - 1] < 0.0F && samples[i] >= 0.0F) {
                last = static_cast<double>(i) - samples[i] / (samples[i] - samples[i - 1]);
                first = periods < 0 ? last : first;
                ++periods;
            }
        return periods > 0 ? periods * sound_rate / (last - first) : 0.0;
    }
    /// Energy at `hz` between two frames (Goertzel).
    static double energy_at(double hz, const std::vector<float>& samples, std::size_t from, std::size_t to) {
        const double w = 2.0 * std::numbers::pi * hz / sound_rate;
        double s1 = 0.0;
        double s2 = 0.0;
        for (std::size_t i = from; i < to && i < samples.size(); ++i) {
            const double s0 = samples[i] + 2.0 * std::cos(w) * s1 - s2;
            s2 = s1;
            s1 = s0;
        }
        return s1 * s1 + s2 * s2 - 2.0 * std::cos(w) * s1 * s2;
    }
};

} // namespace tp::testing
