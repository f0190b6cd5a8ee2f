// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/sound_source.hpp"

#include <QAudioFormat>
#include <QIODevice>

#include <cstdint>
#include <memory>
#include <vector>

namespace tp {

/// A SoundSource as Qt's sink wants it: bytes without end. Behind the sound's end comes silence, because a
/// sink that is given nothing calls itself idle before the last of it was heard.
class SourceDevice final : public QIODevice {
    Q_OBJECT
public:
    /// `format` two channels, Float or Int16.
    SourceDevice(std::shared_ptr<SoundSource> source, const QAudioFormat& format);

    bool ended() const { return ended_; }
    std::int64_t sound_frames() const { return sound_frames_; }   ///< given so far
    std::int64_t silent_frames() const { return silent_frames_; } ///< given behind the end
    SoundSource& source() { return *source_; }

    bool isSequential() const override { return true; }
    qint64 bytesAvailable() const override;

private:
    qint64 readData(char* data, qint64 most) override;
    qint64 writeData(const char*, qint64) override { return -1; }

    std::shared_ptr<SoundSource> source_;
    QAudioFormat format_;
    std::vector<float> samples_;
    bool ended_ = false;
    std::int64_t sound_frames_ = 0;
    std::int64_t silent_frames_ = 0;
};

} // namespace tp
