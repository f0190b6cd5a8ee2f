// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/narration/narrator.hpp"
#include "audio/sound/earcon_player.hpp"

#include <QString>

namespace tp {

/// How the parts of the browse page tell: an earcon, and then the words.
class BrowseTeller {
public:
    /// Both must outlive this.
    BrowseTeller(Narrator& narrator, EarconPlayer& earcons) : narrator_(narrator), earcons_(earcons) {}

    void tell(const QString& sentence, Priority priority = Priority::touch) {
        narrator_.tell(sentence, priority);
    }
    void tell(Earcon earcon, const QString& sentence) {
        sound(earcon);
        tell(sentence);
    }
    void sound(Earcon earcon) { earcons_.play(earcon); }
    /// What was asked for cannot be done; why.
    void refuse(const QString& sentence) { tell(Earcon::error, sentence); }
    Narrator& narrator() { return narrator_; }

private:
    Narrator& narrator_;
    EarconPlayer& earcons_;
};

} // namespace tp
