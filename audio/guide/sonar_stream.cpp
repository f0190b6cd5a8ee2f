// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/sonar_stream.hpp"

#include "audio/sound/sound_format.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tp {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int edge_frames = sound_rate * 6 / 1000; ///< shorter ones click
constexpr int beep_frames = static_cast<int>(beep_s * sound_rate);
constexpr double edge_step = 1.0 / edge_frames;
constexpr double follow = 1.0 / (0.015 * sound_rate); ///< of pitch and side of a steady tone, a frame
constexpr std::int64_t patience_frames = 5 * sound_rate;

double towards(double value, double wanted, double step) {
    return value < wanted ? std::min(wanted, value + step) : std::max(wanted, value - step);
}

/// At most 1 for a reed of 0 … 0.5: the third harmonic flattens the peak before it raises it.
double wave(double phase, double reed) {
    return (std::sin(phase) + reed * std::sin(3.0 * phase)) / (1.0 + 0.15 * reed);
}

/// Loudness of the ears for a side, of equal power. Never all on one: a person may hear with the other.
constexpr double widest = 0.7;
double left_of(double side) { return std::cos(0.25 * pi * (widest * side + 1.0)); }
double right_of(double side) { return std::sin(0.25 * pi * (widest * side + 1.0)); }

} // namespace

double SonarStream::beep_sample() {
    Beep& beep = *beep_;
    const int from_end = std::min(beep.at, beep_frames - 1 - beep.at);
    const double loud = from_end >= edge_frames ? 1.0 : 0.5 - 0.5 * std::cos(pi * from_end / edge_frames);
    const double sample = beep.cue.gain * loud * wave(beep.phase, beep.cue.reed);
    const double along = static_cast<double>(beep.at) / beep_frames;
    const double hz = beep.cue.from_hz * std::pow(beep.cue.to_hz / beep.cue.from_hz, along);
    beep.phase += 2.0 * pi * hz / sound_rate;
    ++beep.at;
    return sample;
}

double SonarStream::steady_sample(const SonarCue& cue, bool wanted) {
    if (wanted && steady_gain_ <= 0.0) { // a new tone begins where it should be
        steady_hz_ = cue.from_hz;
        side_ = cue.side;
        reed_ = cue.reed;
    } else if (wanted) {
        steady_hz_ += follow * (cue.from_hz - steady_hz_);
        side_ += follow * (cue.side - side_);
        reed_ += follow * (cue.reed - reed_);
    }
    steady_gain_ = towards(steady_gain_, wanted ? cue.gain : 0.0, beep_gain * edge_step);
    steady_phase_ = std::fmod(steady_phase_ + 2.0 * pi * steady_hz_ / sound_rate, 2.0 * pi);
    return steady_gain_ * wave(steady_phase_, reed_);
}

std::size_t SonarStream::pull(std::span<float> samples) {
    const std::optional<SonarCue> now = board_.read();
    const auto frames = static_cast<std::int64_t>(samples.size() / played_channels);
    silent_frames_ = now ? 0 : silent_frames_ + frames;
    if (silent_frames_ > patience_frames)
        ended_.store(true);
    if (ended())
        return 0;
    const SonarCue cue = now.value_or(SonarCue{});
    const bool beeps = now && !cue.steady();
    for (std::int64_t i = 0; i < frames; ++i) {
        open_ = towards(open_, now ? 1.0 : 0.0, edge_step);
        if (open_ <= 0.0)
            beep_.reset();
        if (beeps && !beep_ && static_cast<double>(since_beep_) >= cue.interval_s * sound_rate) {
            beep_ = Beep{cue, 0, 0.0};
            since_beep_ = 0;
        }
        ++since_beep_;
        double left = 0.0;
        double right = 0.0;
        if (beep_) {
            const double side = beep_->cue.side;
            const double sample = beep_sample();
            left += sample * left_of(side);
            right += sample * right_of(side);
            if (beep_->at >= beep_frames)
                beep_.reset();
        }
        const double steady = steady_sample(cue, now && cue.steady());
        left += steady * left_of(side_);
        right += steady * right_of(side_);
        const auto at = static_cast<std::size_t>(i * played_channels);
        samples[at] = static_cast<float>(open_ * left);
        samples[at + 1] = static_cast<float>(open_ * right);
    }
    return samples.size();
}

} // namespace tp
