// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/narration/narrator.hpp"
#include "audio/sound/earcon_player.hpp"

#include <QString>

namespace tp {

/// How the care page says what it did: an earcon where something happened, then the words. Both must outlive it.
class CareTeller {
public:
    CareTeller(Narrator& narrator, EarconPlayer& earcons) : narrator_(narrator), earcons_(earcons) {}

    /// Something that is to be heard to its end.
    void tell(const QString& sentence) { narrator_.tell(sentence, Priority::message); }
    /// An answer to what a hand does now; the next one replaces it.
    void answer(const QString& sentence) { narrator_.tell(sentence, Priority::touch); }
    void sound(Earcon earcon) { earcons_.play(earcon); }
    void did(Earcon earcon, const QString& sentence) {
        sound(earcon);
        tell(sentence);
    }
    /// What was asked for was not done.
    void problem(const QString& sentence) { did(Earcon::error, sentence); }
    void silence() { narrator_.stop(); }

private:
    Narrator& narrator_;
    EarconPlayer& earcons_;
};

} // namespace tp
