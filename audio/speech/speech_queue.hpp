// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/speech/speech_engine.hpp"
#include "audio/speech/voice.hpp"

#include <deque>
#include <optional>

namespace tp {

/// What is spoken next: the rules of `Priority`, without a voice and without time.
///
/// A fault interrupts all but faults; a message it interrupted is spoken again from its start. A message
/// interrupts touch and follows other messages. Touch interrupts touch and follows the rest; of touch only
/// the newest waits.
class SpeechQueue {
public:
    /// The engine must outlive the queue. Nothing is spoken before `open(true)`.
    explicit SpeechQueue(SpeechEngine& engine) : engine_(engine) {}

    void say(const QString& text, Priority priority);
    /// Drops all but faults.
    void stop();
    /// The utterance has been spoken to its end; others than the current one are ignored.
    void finished(quint64 id);
    /// Whether the engine takes texts. What one that no longer does was given last is spoken by the next.
    void open(bool open);
    void set_recording_plays(bool plays);
    /// Nothing is being spoken, and nothing waits.
    bool idle() const { return !current_ && !touch_ && messages_.empty() && faults_.empty(); }
    /// Forgets everything, faults too: there is no engine that could speak them.
    void clear();

private:
    struct Utterance {
        quint64 id = 0;
        Priority priority = Priority::touch;
        QString text;
    };
    bool may_start(Priority priority) const;
    void interrupt();
    void put_back();
    void next();

    SpeechEngine& engine_;
    std::deque<Utterance> faults_;
    std::deque<Utterance> messages_;
    std::optional<Utterance> touch_;
    std::optional<Utterance> current_;
    quint64 last_id_ = 0;
    bool open_ = false;
    bool recording_plays_ = false;
};

} // namespace tp
