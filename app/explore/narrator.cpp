// SPDX-License-Identifier: Apache-2.0
#include "app/explore/narrator.hpp"

#include <utility>

namespace tp {

Narrator::Narrator(Voice& voice, Announcer& announcer, bool voice_on)
    : voice_(voice), announcer_(announcer), voice_on_(voice_on) {
    connect(&voice_, &Voice::state_changed, this, &Narrator::voice_changed);
}

void Narrator::tell(const QString& sentence, Priority priority) {
    if (sentence.isEmpty())
        return;
    if (!voice_on_ || voice_.state() == Voice::State::missing) {
        announcer_.announce(sentence);
        return;
    }
    voice_.say(sentence, priority);
    if (voice_.state() != Voice::State::ready)
        unheard_ = sentence;
}

void Narrator::set_voice_on(bool on) {
    if (on == voice_on_)
        return;
    voice_on_ = on;
    if (!on)
        voice_.stop();
    emit changed();
    tell(on ? "Voice on." : "Voice off.", Priority::touch);
}

QString Narrator::voice_problem() const {
    return voice_on_ && voice_.state() == Voice::State::missing
               ? QString("No speech engine was found on this computer, so nothing is spoken here. A screen "
                         "reader is told instead.")
               : QString();
}

void Narrator::voice_changed() {
    if (voice_.state() == Voice::State::missing && !unheard_.isEmpty())
        announcer_.announce(std::exchange(unheard_, {}));
    if (voice_.state() == Voice::State::ready)
        unheard_.clear();
    emit changed();
}

} // namespace tp
