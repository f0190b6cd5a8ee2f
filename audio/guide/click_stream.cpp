// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/click_stream.hpp"

#include "audio/sound/sound_format.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tp {

ClickStream::ClickStream(std::shared_ptr<ClickList> list, std::function<double()> now)
    : list_(std::move(list)), now_(std::move(now)) {}

double ClickStream::Sounding::sample(std::int64_t frame) const {
    constexpr double turn = 2.0 * std::numbers::pi;
    const auto at = static_cast<double>(frame - begin);
    const double window = 0.5 - 0.5 * std::cos(turn * at / static_cast<double>(frames));
    return amplitude * window * std::sin(turn * hz * at / sound_rate);
}

/// The next click with its place, not before this frame.
std::optional<ClickStream::Sounding> ClickStream::next(double origin) {
    Click click;
    if (!list_->take(click))
        return std::nullopt;
    Sounding next;
    const double seconds = std::clamp(click.seconds, shortest_click_s, longest_click_s);
    next.frames = std::llround(seconds * sound_rate);
    next.begin =
        std::max<std::int64_t>(frame_, std::llround((click.time + click_ahead_s - origin) * sound_rate));
    next.amplitude = loudest_click * std::clamp(click.amplitude, 0.0, 1.0);
    next.hz = dull_click_hz * std::pow(sharp_click_hz / dull_click_hz, std::clamp(click.sharpness, 0.0, 1.0));
    return next;
}

std::size_t ClickStream::pull(std::span<float> samples) {
    const double begins = now_() - static_cast<double>(frame_) / sound_rate;
    origin_ = std::min(origin_.value_or(begins), begins);
    const std::size_t frames = samples.size() / played_channels;
    for (std::size_t i = 0; i < frames; ++i, ++frame_) {
        if (!coming_)
            coming_ = next(*origin_);
        if (coming_ && coming_->begin <= frame_)
            sounding_ = std::exchange(coming_, std::nullopt);
        if (list_->hushed())
            sounding_ = coming_ = std::nullopt;
        if (sounding_ && frame_ >= sounding_->begin + sounding_->frames)
            sounding_.reset();
        const auto sample = static_cast<float>(sounding_ ? sounding_->sample(frame_) : 0.0);
        for (std::size_t channel = 0; channel < played_channels; ++channel)
            samples[played_channels * i + channel] = sample;
    }
    return frames * played_channels;
}

} // namespace tp
