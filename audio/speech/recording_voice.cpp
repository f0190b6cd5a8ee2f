// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/recording_voice.hpp"

namespace tp {

void RecordingVoice::set_state(State state) {
    state_ = state;
    emit state_changed();
}

void RecordingVoice::set_busy(bool busy) {
    busy_ = busy;
    if (!busy)
        emit fell_silent();
}

void RecordingVoice::say(const QString& text, Priority priority) {
    said_ << text;
    names_when_said_.push_back(names_);
    last_priority_ = priority;
}

} // namespace tp
