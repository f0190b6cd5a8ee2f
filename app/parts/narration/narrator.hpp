// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/controls/announcer.hpp"
#include "audio/speech/voice.hpp"

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>

namespace tp {

/// Who tells the user: the program's own voice, or the user's screen reader where the person asked for that or
/// there is no engine for the voice. Never both, because they would talk at once. One for all pages.
class Narrator final : public QObject {
    Q_OBJECT
    Q_PROPERTY(QString sentence READ sentence NOTIFY told)
    Q_PROPERTY(bool voiceOn READ voice_on NOTIFY changed)
    Q_PROPERTY(QString voiceProblem READ voice_problem NOTIFY changed)
public:
    enum class By {
        voice,         ///< the program speaks
        screen_reader, ///< the user's screen reader is told
        nobody,        ///< the words are only shown
    };

    /// Both must outlive the narrator.
    Narrator(Voice& voice, Announcer& announcer, By by = By::voice);

    void tell(const QString& sentence, Priority priority);
    /// Tells, and calls `then` once that has been said: after about as long as it takes where a screen reader says it,
    /// which tells nobody. Of several the last is called; `stop` drops it.
    void tell_then(const QString& sentence, std::function<void()> then);
    /// Silence now; faults are still spoken.
    void stop();
    /// The voice is to be heard, or something that it will say waits.
    bool speaking() const { return by_ == By::voice && voice_.busy(); }
    /// While a recording plays the voice says nothing but faults; the rest waits for its end.
    void set_recording_plays(bool plays) { voice_.set_recording_plays(plays); }
    /// Says the last sentence again.
    Q_INVOKABLE void repeat();
    /// What was told last, for the page to show.
    const QString& sentence() const { return sentence_; }

    By by() const { return by_; }
    /// Changes who tells, without a word about it.
    void set_by(By by);
    bool voice_on() const { return by_ == By::voice; }
    /// The voice, or else the screen reader; says which.
    void set_voice_on(bool on);
    /// What keeps the voice from being heard, in a sentence; empty: nothing.
    QString voice_problem() const;

signals:
    void changed();
    /// Something was told; `sentence` says what.
    void told();

private:
    void voice_changed();
    void said_all();
    void wait_as_for_a_reader();

    Voice& voice_;
    Announcer& announcer_;
    By by_;
    QString sentence_;
    std::function<void()> then_;
    QTimer reader_; ///< about as long as a screen reader takes
    QString unheard_; ///< the last sentence given to a voice that was not there yet
};

} // namespace tp
