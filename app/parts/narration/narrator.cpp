// SPDX-License-Identifier: Apache-2.0
#include "app/parts/narration/narrator.hpp"

#include <utility>

namespace tp {

namespace {
constexpr int reader_ms_per_letter = 60; ///< a usual rate of speech, about 170 words a minute
}

Narrator::Narrator(Voice& voice, Announcer& announcer, By by)
    : voice_(voice), announcer_(announcer), by_(by) {
    connect(&voice_, &Voice::state_changed, this, &Narrator::voice_changed);
    connect(&voice_, &Voice::fell_silent, this, &Narrator::said_all);
    reader_.setSingleShot(true);
    connect(&reader_, &QTimer::timeout, this, &Narrator::said_all);
}

void Narrator::tell(const QString& sentence, Priority priority) {
    if (sentence.isEmpty())
        return;
    sentence_ = sentence;
    if (by_ == By::voice && voice_.state() != Voice::State::missing) {
        voice_.say(sentence, priority);
        if (voice_.state() != Voice::State::ready)
            unheard_ = sentence;
    } else if (by_ != By::nobody) {
        announcer_.announce(sentence);
    }
    emit told();
}

void Narrator::tell_then(const QString& sentence, std::function<void()> then) {
    then_ = nullptr; // what is said below is not what it waited for
    tell(sentence, Priority::message);
    then_ = std::move(then);
    if (!speaking())
        wait_as_for_a_reader();
}

void Narrator::wait_as_for_a_reader() {
    const bool said = by_ == By::screen_reader || (by_ == By::voice && voice_.state() == Voice::State::missing);
    reader_.start(said ? 500 + reader_ms_per_letter * static_cast<int>(sentence_.size()) : 0);
}

void Narrator::said_all() {
    reader_.stop();
    if (const auto then = std::exchange(then_, nullptr))
        then();
}

void Narrator::stop() {
    then_ = nullptr;
    reader_.stop();
    voice_.stop();
}

void Narrator::repeat() { tell(QString(sentence_), Priority::touch); }

void Narrator::set_by(By by) {
    if (by == by_)
        return;
    by_ = by;
    if (by != By::voice)
        voice_.stop();
    emit changed();
}

void Narrator::set_voice_on(bool on) {
    if (on == voice_on())
        return;
    set_by(on ? By::voice : By::screen_reader);
    tell(on ? tr("Voice on.") : tr("Voice off."), Priority::touch);
}

QString Narrator::voice_problem() const {
    return voice_on() && voice_.state() == Voice::State::missing
               ? tr("No speech engine was found on this computer, so TouchPhoto cannot speak. It tells a "
                    "screen reader instead.")
               : QString();
}

void Narrator::voice_changed() {
    if (voice_.state() == Voice::State::missing && !unheard_.isEmpty())
        announcer_.announce(std::exchange(unheard_, {}));
    if (voice_.state() == Voice::State::missing && then_)
        wait_as_for_a_reader();
    if (voice_.state() == Voice::State::ready)
        unheard_.clear();
    emit changed();
}

} // namespace tp
