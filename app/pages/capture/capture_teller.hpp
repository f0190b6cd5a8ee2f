// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/narration/narrator.hpp"
#include "audio/sound/earcon_player.hpp"

#include <QObject>
#include <QString>

#include <functional>

namespace tp {

/// How the capture page speaks, and whether it is speaking: advice is never said over anything. Both must outlive it.
class CaptureTeller final : public QObject {
    Q_OBJECT
public:
    CaptureTeller(Narrator& narrator, EarconPlayer& earcons) : narrator_(narrator), earcons_(earcons) {}

    /// Something that is to be heard to its end. `then` is called when it was, or was broken off.
    void tell(const QString& sentence, std::function<void()> then = {});
    /// An answer to what a hand does now; the next one replaces it.
    void answer(const QString& sentence) { narrator_.tell(sentence, Priority::touch); }
    void sound(Earcon earcon) { earcons_.play(earcon); }
    void did(Earcon earcon, const QString& sentence);
    /// What was asked for was not done.
    void problem(const QString& sentence) { did(Earcon::error, sentence); }

    bool speaking() const { return telling_ || narrator_.speaking(); }
    /// Silence now.
    void silence();

signals:
    /// All that was told has been said.
    void fell_silent();

private:
    void said();

    Narrator& narrator_;
    EarconPlayer& earcons_;
    bool telling_ = false;
    std::function<void()> then_; ///< of the newest sentence
};

} // namespace tp
