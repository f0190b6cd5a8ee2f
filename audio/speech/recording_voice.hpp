// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/speech/voice.hpp"

#include <QStringList>

namespace tp {

/// Remembers what would have been spoken: for tests, and for pictures of a page.
class RecordingVoice final : public Voice {
    Q_OBJECT
public:
    using Voice::Voice;

    /// Everything since the last clear(), in order.
    const QStringList& said() const { return said_; }
    Priority last_priority() const { return last_priority_; }
    int stops() const { return stops_; }
    void clear() { said_.clear(); }
    void set_state(State state);

    State state() const override { return state_; }
    void say(const QString& text, Priority priority) override;
    void stop() override { ++stops_; }
    void set_rate(double rate) override { rate_ = rate; }
    void set_language(const QString& language) override { language_ = language; }
    double rate() const { return rate_; }
    const QString& language() const { return language_; }
    void set_recording_plays(bool) override {}

private:
    State state_ = State::ready;
    QStringList said_;
    Priority last_priority_ = Priority::touch;
    int stops_ = 0;
    double rate_ = 0.0;
    QString language_;
};

} // namespace tp
