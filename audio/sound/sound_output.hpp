// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/sound_source.hpp"

#include <QObject>

#include <memory>

namespace tp {

/// A loudspeaker, one sound at a time. `run` names a sound, so that a late word about one that was stopped is
/// not taken for the next one's. Calls come from the thread that the object lives on, and its signals reach
/// there; none blocks.
class SoundOutput : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Replaces what is being played.
    virtual void start(quint64 run, std::shared_ptr<SoundSource> source) = 0;
    /// Silence now; what was not heard yet is dropped.
    virtual void stop() = 0;

signals:
    /// The source's heard() was told something new.
    void progress(quint64 run);
    /// All of the sound has been heard; the run is over.
    void drained(quint64 run);
    /// There is no loudspeaker, or no longer; the run is over.
    void gone(quint64 run);
    /// The system has turned to another loudspeaker; the run is over and can be started again there.
    void moved(quint64 run);
    /// There is a loudspeaker again.
    void came();
};

} // namespace tp
