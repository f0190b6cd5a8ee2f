// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/speech/spoken_names.hpp"

#include <QObject>
#include <QString>

namespace tp {

/// What may be talked over, and by what; in ascending order.
enum class Priority {
    touch,   ///< an answer to what the hand does now: a newer one replaces it
    message, ///< what a person must hear to the end: spoken in turn
    fault,   ///< safety: spoken at once, over everything but another fault, and never dropped
};

/// Speech, whoever speaks. One queue; lives on the page's thread and never blocks it.
class Voice : public QObject {
    Q_OBJECT
public:
    enum class State {
        asleep,   ///< nothing said yet, so no engine was looked for
        starting, ///< the engine is being looked for; what is said meanwhile waits
        ready,
        missing, ///< there is no engine here; what is said is not heard
    };
    using QObject::QObject;

    virtual State state() const = 0;
    /// Something is being spoken, or waits to be.
    virtual bool busy() const = 0;
    virtual void say(const QString& text, Priority priority) = 0;
    /// Silence now. Only what is left of faults is still spoken.
    virtual void stop() = 0;
    /// -1 slowest … 0 the engine's own … 1 fastest.
    virtual void set_rate(double rate) = 0;
    /// The voice of a language (BCP 47, such as "ko"), where the engine has one.
    virtual void set_language(const QString& language) = 0;
    /// Names that are read in their own language from the next sentence on, where the engine can.
    virtual void set_name_languages(const SpokenNames& names) = 0;
    /// While a recording plays nothing but a fault is spoken; the rest waits for its end.
    virtual void set_recording_plays(bool plays) = 0;

signals:
    void state_changed();
    /// Everything has been spoken or dropped.
    void fell_silent();
};

} // namespace tp
