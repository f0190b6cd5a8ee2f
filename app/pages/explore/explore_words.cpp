// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_words.hpp"

#include "app/pages/explore/clock_guide.hpp"

#include <algorithm>

namespace tp {

ExploreWords::ExploreWords(Narrator& narrator, EarconPlayer& earcons, Preferences& preferences,
                           const PageClock& now)
    : narrator_(narrator), earcons_(earcons), preferences_(preferences), now_(now) {
    connect(&narrator_, &Narrator::changed, this, &ExploreWords::voiceChanged);
}

void ExploreWords::setVoiceOn(bool on) {
    narrator_.set_voice_on(on);
    preferences_.change([&](Choices& choices) {
        choices.voice = on ? Choices::Voice::program : Choices::Voice::screen_reader;
    });
}

double ExploreWords::spoken_at(const QString& words) {
    const double then = now_() + speech_seconds(words, speech_rate(preferences_.choices().rate));
    busy_until_ = std::max(busy_until_, then);
    return then;
}

double ExploreWords::tell(const QString& sentence, Priority priority) {
    if (sentence_ != sentence) {
        sentence_ = sentence;
        emit sentenceChanged();
    }
    if (here_)
        narrator_.tell(sentence, priority);
    return spoken_at(sentence);
}

void ExploreWords::tell(Earcon earcon, const QString& sentence, Priority priority) {
    if (here_)
        earcons_.play(earcon);
    tell(sentence, priority);
}

void ExploreWords::murmur(const QString& words) {
    if (here_)
        narrator_.tell(words, Priority::touch);
    spoken_at(words);
}

void ExploreWords::tellProblem(const QString& sentence) { tell(Earcon::error, sentence, Priority::message); }

} // namespace tp
