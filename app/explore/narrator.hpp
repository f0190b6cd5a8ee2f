// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/controls/announcer.hpp"
#include "audio/speech/voice.hpp"

namespace tp {

/// Who tells the user: the program's own voice, or the user's screen reader where that voice is off or there
/// is no engine for it. Never both, because they would talk at once.
class Narrator final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive the narrator.
    Narrator(Voice& voice, Announcer& announcer, bool voice_on);

    void tell(const QString& sentence, Priority priority);
    void stop() { voice_.stop(); }

    bool voice_on() const { return voice_on_; }
    void set_voice_on(bool on);
    /// What keeps the voice from being heard, in a sentence; empty: nothing.
    QString voice_problem() const;

signals:
    void changed();

private:
    void voice_changed();

    Voice& voice_;
    Announcer& announcer_;
    bool voice_on_;
    QString unheard_; ///< the last sentence given to a voice that was not there yet
};

} // namespace tp
