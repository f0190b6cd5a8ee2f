// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/speech_queue.hpp"

#include <utility>

namespace tp {

void SpeechQueue::say(const QString& text, Priority priority) {
    if (text.isEmpty())
        return;
    Utterance utterance{++last_id_, priority, text};
    switch (priority) {
    case Priority::touch:
        touch_ = std::move(utterance);
        break;
    case Priority::message:
        messages_.push_back(std::move(utterance));
        break;
    case Priority::fault:
        faults_.push_back(std::move(utterance));
        break;
    }
    const bool touch_over_touch = priority == Priority::touch && current_ && current_->priority == priority;
    if (current_ && may_start(priority) && (priority > current_->priority || touch_over_touch))
        interrupt();
    next();
}

bool SpeechQueue::may_start(Priority priority) const {
    return open_ && (priority == Priority::fault || !recording_plays_);
}

/// Makes way. What was a message is owed to the listener and comes back.
void SpeechQueue::interrupt() {
    if (current_->priority == Priority::message)
        messages_.push_front(std::move(*current_));
    current_.reset();
    engine_.cancel();
}

/// The engine that had it has gone.
void SpeechQueue::put_back() {
    if (!current_)
        return;
    if (current_->priority == Priority::fault)
        faults_.push_front(std::move(*current_));
    else if (current_->priority == Priority::message)
        messages_.push_front(std::move(*current_));
    else if (!touch_)
        touch_ = std::move(*current_);
    current_.reset();
}

void SpeechQueue::next() {
    if (current_)
        return;
    if (!faults_.empty() && may_start(Priority::fault)) {
        current_ = std::move(faults_.front());
        faults_.pop_front();
    } else if (!messages_.empty() && may_start(Priority::message)) {
        current_ = std::move(messages_.front());
        messages_.pop_front();
    } else if (touch_ && may_start(Priority::touch)) {
        current_ = std::move(*touch_);
        touch_.reset();
    } else {
        return;
    }
    engine_.speak(current_->id, current_->text);
}

void SpeechQueue::finished(quint64 id) {
    if (!current_ || current_->id != id)
        return;
    current_.reset();
    next();
}

void SpeechQueue::stop() {
    messages_.clear();
    touch_.reset();
    if (current_ && current_->priority != Priority::fault) {
        current_.reset();
        engine_.cancel();
        next();
    }
}

void SpeechQueue::open(bool open) {
    open_ = open;
    if (!open)
        put_back();
    next();
}

void SpeechQueue::set_recording_plays(bool plays) {
    recording_plays_ = plays;
    if (plays && current_ && current_->priority != Priority::fault)
        interrupt();
    next();
}

void SpeechQueue::clear() {
    faults_.clear();
    messages_.clear();
    touch_.reset();
    current_.reset();
}

} // namespace tp
