// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/loudspeaker_worker.hpp"

#include "audio/sound/sound_format.hpp"

#include <QAudioDevice>
#include <QCoreApplication>
#include <QMediaDevices>

#include <algorithm>
#include <utility>

namespace tp {

namespace {

constexpr int look_ms = 40;
constexpr int look_for_another_ms = 1000;
constexpr int looks_a_second = 1000 / look_ms;
constexpr int looks_until_stalled = 3 * looks_a_second;
constexpr int looks_until_tried_again =
    5 * looks_a_second; ///< the one that was lost, though it never seemed away
constexpr int short_buffer_ms =
    100; ///< asked for; Qt 6.4 on PulseAudio takes 70 of it, and stands still with 50. Its own
         ///< choice is 200
constexpr std::int64_t most_silence = 2 * sound_rate; ///< behind the end, where the sink's clock stands still

QAudioFormat played_format(const QAudioDevice& device) {
    QAudioFormat format;
    format.setSampleRate(sound_rate);
    format.setChannelCount(played_channels);
    format.setSampleFormat(QAudioFormat::Float);
    if (!device.isFormatSupported(format))
        format.setSampleFormat(QAudioFormat::Int16);
    return format;
}

} // namespace

LoudspeakerWorker::LoudspeakerWorker() : look_(this) {
    connect(&look_, &QTimer::timeout, this, &LoudspeakerWorker::look);
}

LoudspeakerWorker::~LoudspeakerWorker() {
    if (sink_ != nullptr)
        sink_->reset();
    QCoreApplication::removePostedEvents(this); // the sink's destructor would carry them out
}

void LoudspeakerWorker::start(quint64 run, std::shared_ptr<SoundSource> source) {
    stop();
    run_ = run;
    lost_ = false;
    heard_ = 0;
    looks_ = looks_alike_ = 0;
    look_.start(look_ms);
    const QAudioDevice loudspeaker = QMediaDevices::defaultAudioOutput();
    id_ = loudspeaker.id();
    const QAudioFormat format = played_format(loudspeaker);
    if (loudspeaker.isNull() || !loudspeaker.isFormatSupported(format)) {
        lose();
        return;
    }
    const bool prompt = source->answers_a_finger();
    sink_ = std::make_unique<QAudioSink>(loudspeaker, format);
    device_ = new SourceDevice(std::move(source), format);
    device_->setParent(sink_.get());
    if (prompt && keeps_up_)
        sink_->setBufferSize(format.bytesForDuration(1000LL * short_buffer_ms));
    sink_->start(device_);
    if (sink_->state() == QAudio::StoppedState)
        lose();
}

void LoudspeakerWorker::stop() {
    if (sink_ != nullptr) {
        sink_->reset(); // stop() would let what is in the buffer be heard
        // Not deleted in here: Qt 6.4's destructor handles the thread's events, the next start() among them.
        sink_.release()->deleteLater();
        device_ = nullptr;
    }
    if (!lost_)
        look_.stop();
}

void LoudspeakerWorker::lose() {
    lost_ = true;
    waited_looks_ = 0;
    stop();
    look_.start(look_for_another_ms);
    emit gone(run_);
}

void LoudspeakerWorker::look() {
    if (sink_ != nullptr)
        look_at_sound();
    if (lost_ || ++looks_ >= looks_a_second) {
        looks_ = 0;
        look_at_devices();
    }
}

void LoudspeakerWorker::look_at_sound() {
    if (sink_->state() == QAudio::StoppedState) {
        lose();
        return;
    }
    const std::int64_t played = sink_->processedUSecs() * sound_rate / 1'000'000;
    const std::int64_t heard = std::min(played, device_->sound_frames());
    if (heard > heard_) {
        looks_alike_ = 0;
        heard_ = heard;
        device_->source().heard(heard);
        emit progress(run_);
    } else if (!device_->ended() && ++looks_alike_ >= looks_until_stalled) {
        keeps_up_ = false; // or it is gone; the next sound has the system's own buffer
        lose();
        return;
    }
    // Some back ends count what they were given as played: then the silence must have pushed it out first.
    const std::int64_t buffer = sink_->bufferSize() / sink_->format().bytesPerFrame();
    const bool all_heard = heard_ == device_->sound_frames() && device_->silent_frames() >= buffer;
    if (device_->ended() && (all_heard || device_->silent_frames() >= most_silence)) {
        device_->source().heard(device_->sound_frames());
        stop();
        emit drained(run_);
    }
}

/// Qt 6.4 does not tell of PulseAudio's devices that come and go (QMediaDevices' signals stay away), but
/// lists them.
void LoudspeakerWorker::look_at_devices() {
    const QAudioDevice loudspeaker = QMediaDevices::defaultAudioOutput();
    const bool other = loudspeaker.id() != id_;
    if (sink_ != nullptr) {
        if (loudspeaker.isNull()) {
            lose();
        } else if (other) {
            stop();
            emit moved(run_);
        }
    } else if (lost_) {
        waited_looks_ += looks_a_second;
        if (loudspeaker.isNull())
            id_.clear(); // the same one is news when it is back
        else if (other || waited_looks_ >= looks_until_tried_again) {
            lost_ = false;
            look_.stop();
            emit came();
        }
    }
}

} // namespace tp
