// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/system_microphone.hpp"

#include "audio/sound/sound_format.hpp"

#include <QAudioDevice>
#include <QIODevice>
#include <QMediaDevices>

#include <cstring>
#include <utility>

namespace tp {

namespace {

constexpr int microphone_look_ms = 500;
constexpr int looks_until_mute = 6;      // 3 s
constexpr int looks_until_opened_again = 10; // 5 s: the one that was lost, though it never seemed away

QAudioFormat recorded_format(const QAudioDevice& device) {
    QAudioFormat format;
    format.setSampleRate(sound_rate);
    format.setChannelCount(1);
    format.setSampleFormat(QAudioFormat::Int16);
    if (!device.isFormatSupported(format))
        format.setChannelCount(2);
    return format;
}

} // namespace

SystemMicrophone::SystemMicrophone(QObject* parent) : SoundInput(parent), look_(this) {
    look_.setInterval(microphone_look_ms);
    connect(&look_, &QTimer::timeout, this, &SystemMicrophone::look);
}

SystemMicrophone::~SystemMicrophone() { stop(); }

void SystemMicrophone::start() {
    stop();
    look_.start();
    silent_looks_ = 0;
    const QAudioDevice microphone = QMediaDevices::defaultAudioInput();
    id_ = microphone.id();
    if (microphone.isNull()) {
        lose(Trouble::none_there);
        return;
    }
    const QAudioFormat format = recorded_format(microphone);
    if (!microphone.isFormatSupported(format)) {
        lose(Trouble::unfit);
        return;
    }
    source_ = std::make_unique<QAudioSource>(microphone, format);
    stream_ = source_->start();
    if (stream_ == nullptr || source_->state() == QAudio::StoppedState) {
        lose(Trouble::none_there);
        return;
    }
    connect(stream_, &QIODevice::readyRead, this, &SystemMicrophone::deliver);
}

void SystemMicrophone::stop() {
    lost_ = false;
    look_.stop();
    rest_.clear();
    if (source_ == nullptr)
        return;
    source_->stop();
    source_.release()->deleteLater(); // this may be one of its own signals
}

void SystemMicrophone::deliver() {
    if (source_ == nullptr || stream_ == nullptr)
        return;
    rest_ += stream_->readAll();
    const int channels = source_->format().channelCount();
    const qsizetype bytes_per_frame = channels * static_cast<qsizetype>(sizeof(std::int16_t));
    const qsizetype frames = rest_.size() / bytes_per_frame;
    if (frames == 0)
        return;
    silent_looks_ = 0;
    block_.resize(static_cast<std::size_t>(frames * channels));
    std::memcpy(block_.data(), rest_.constData(), block_.size() * sizeof(std::int16_t));
    rest_.remove(0, frames * bytes_per_frame);
    if (channels == 2)
        for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i)
            block_[i] = static_cast<std::int16_t>((block_[2 * i] + block_[2 * i + 1]) / 2);
    block_.resize(static_cast<std::size_t>(frames));
    emit block(block_);
}

/// Qt 6.4 does not tell of PulseAudio's devices that come and go (QMediaDevices' signals stay away), but
/// lists them.
void SystemMicrophone::look() {
    const QAudioDevice microphone = QMediaDevices::defaultAudioInput();
    if (source_ != nullptr) {
        if (microphone.isNull() || source_->state() == QAudio::StoppedState)
            lose(Trouble::none_there);
        else if (++silent_looks_ >= looks_until_mute)
            lose(Trouble::stalled);
        else if (microphone.id() != id_)
            start(); // the system has turned to another one
    } else if (lost_) {
        if (microphone.isNull()) {
            id_.clear(); // the same one is news when it is back
        } else if (microphone.id() != id_ || ++waited_looks_ >= looks_until_opened_again) {
            stop();
            emit came();
        }
    }
}

void SystemMicrophone::lose(Trouble trouble) {
    stop();
    lost_ = true;
    waited_looks_ = 0;
    look_.start();
    emit lost(trouble);
}

} // namespace tp
