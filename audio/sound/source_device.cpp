// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/source_device.hpp"

#include "audio/sound/sound_format.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace tp {

namespace {
constexpr qint64 always_available = 1 << 20; // bytes
} // namespace

SourceDevice::SourceDevice(std::shared_ptr<SoundSource> source, const QAudioFormat& format)
    : source_(std::move(source)), format_(format) {
    open(QIODevice::ReadOnly | QIODevice::Unbuffered);
}

qint64 SourceDevice::bytesAvailable() const { return always_available; }

qint64 SourceDevice::readData(char* data, qint64 most) {
    const qint64 frames = most / format_.bytesPerFrame();
    samples_.resize(static_cast<std::size_t>(frames) * played_channels);
    const std::size_t got = ended_ ? 0 : source_->pull(samples_);
    ended_ = got < samples_.size();
    std::fill(samples_.begin() + static_cast<std::ptrdiff_t>(got), samples_.end(), 0.0F);
    const auto sound = static_cast<std::int64_t>(got) / played_channels;
    sound_frames_ += sound;
    silent_frames_ += frames - sound;

    if (format_.sampleFormat() == QAudioFormat::Float) {
        std::memcpy(data, samples_.data(), samples_.size() * sizeof(float));
    } else {
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const auto sample =
                static_cast<std::int16_t>(std::lround(std::clamp(samples_[i], -1.0F, 1.0F) * 32767.0F));
            std::memcpy(data + i * sizeof sample, &sample, sizeof sample);
        }
    }
    return frames * format_.bytesPerFrame();
}

} // namespace tp
