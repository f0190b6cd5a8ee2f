// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/speech/speech_queue.hpp"
#include "audio/speech/system_speech.hpp"
#include "audio/speech/voice.hpp"

namespace tp {

/// The voice that people hear: the queue before the system's speech engine. Nothing is started until
/// something is said.
class SpokenVoice final : public Voice {
    Q_OBJECT
public:
    explicit SpokenVoice(QObject* parent = nullptr);

    State state() const override { return state_; }
    void say(const QString& text, Priority priority) override;
    bool busy() const override { return !queue_.idle(); }
    void stop() override;
    void set_rate(double rate) override { speech_.set_rate(rate); }
    void set_language(const QString& language) override { speech_.set_language(language); }
    void set_name_languages(const SpokenNames& names) override { speech_.set_name_languages(names); }
    void set_recording_plays(bool plays) override { queue_.set_recording_plays(plays); }

private:
    void became(State state);
    void look_whether_silent();

    State state_ = State::asleep;
    SystemSpeech speech_;
    SpeechQueue queue_;
};

} // namespace tp
