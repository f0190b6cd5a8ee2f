// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/speech/voice.hpp"

#include <QStringList>

#include <vector>

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
    void clear() {
        said_.clear();
        names_when_said_.clear();
    }
    void set_state(State state);
    /// What is said takes its time from now on, until this is set to false.
    void set_busy(bool busy);
    bool recording_plays() const { return recording_plays_; }

    State state() const override { return state_; }
    bool busy() const override { return busy_; }
    void say(const QString& text, Priority priority) override;
    void stop() override { ++stops_; }
    void set_rate(double rate) override { rate_ = rate; }
    void set_language(const QString& language) override { language_ = language; }
    void set_name_languages(const SpokenNames& names) override { names_ = names; }
    double rate() const { return rate_; }
    const QString& language() const { return language_; }
    const SpokenNames& name_languages() const { return names_; }
    /// The names as they were known when each sentence of said() came.
    const std::vector<SpokenNames>& names_when_said() const { return names_when_said_; }
    void set_recording_plays(bool plays) override { recording_plays_ = plays; }

private:
    State state_ = State::ready;
    QStringList said_;
    Priority last_priority_ = Priority::touch;
    int stops_ = 0;
    double rate_ = 0.0;
    QString language_;
    SpokenNames names_;
    std::vector<SpokenNames> names_when_said_;
    bool busy_ = false;
    bool recording_plays_ = false;
};

} // namespace tp
