// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/spoken_voice.hpp"

namespace tp {

SpokenVoice::SpokenVoice(QObject* parent) : Voice(parent), queue_(speech_) {
    connect(&speech_, &SystemSpeech::found, this, [this] { became(State::ready); });
    connect(&speech_, &SystemSpeech::trying, this, [this] { queue_.open(true); }); // it speaks as soon as it is there
    connect(&speech_, &SystemSpeech::lost, this, [this] {
        queue_.open(false);
        became(State::starting);
    });
    connect(&speech_, &SystemSpeech::none_left, this, [this] { became(State::missing); });
    connect(&speech_, &SystemSpeech::finished, this, [this](quint64 id) {
        queue_.finished(id);
        look_whether_silent();
    });
}

void SpokenVoice::say(const QString& text, Priority priority) {
    if (state_ == State::missing)
        return;
    if (state_ == State::asleep) {
        became(State::starting);
        speech_.start();
    }
    queue_.say(text, priority);
}

void SpokenVoice::stop() {
    const bool was_busy = busy();
    queue_.stop();
    if (was_busy)
        look_whether_silent();
}

void SpokenVoice::look_whether_silent() {
    if (queue_.idle())
        emit fell_silent();
}

void SpokenVoice::became(State state) {
    if (state == state_)
        return;
    state_ = state;
    if (state == State::missing)
        queue_.clear();
    emit state_changed();
}

} // namespace tp
