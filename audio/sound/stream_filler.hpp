// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/playback_stream.hpp"

#include <QObject>
#include <QString>

#include <memory>

namespace tp {

/// Keeps the stream that is played filled; one stream at a time. `run` names a stream as for SoundOutput.
/// Calls and signals are on the thread that the object lives on.
class StreamFiller : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Leaves the stream before it and opens and fills this one; `ready` or `unreadable` follows.
    virtual void begin(quint64 run, std::shared_ptr<PlaybackStream> stream) = 0;
    virtual void leave() = 0;

signals:
    /// It is open, and its buffer full.
    void ready(quint64 run);
    /// With the sentence that says why.
    void unreadable(quint64 run, const QString& sentence);
};

} // namespace tp
