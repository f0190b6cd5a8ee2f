// SPDX-License-Identifier: Apache-2.0
#include "app/pages/study/study_teller.hpp"

namespace tp {

void StudyTeller::say(const QString& sentence, Priority priority) {
    sentence_ = sentence;
    if (here_)
        narrator_.tell(sentence, priority);
    emit told();
}

void StudyTeller::tell(const QString& sentence) { say(sentence, Priority::touch); }
void StudyTeller::add(const QString& sentence) { say(sentence, Priority::message); }

void StudyTeller::sound(Earcon earcon) {
    if (here_)
        earcons_.play(earcon);
}

void StudyTeller::did(Earcon earcon, const QString& sentence) {
    sound(earcon);
    tell(sentence);
}

} // namespace tp
