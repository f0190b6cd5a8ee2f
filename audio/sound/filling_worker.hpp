// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/playback_stream.hpp"

#include <QObject>
#include <QTimer>

#include <memory>

namespace tp {

/// ThreadedFiller's other end: every call on the thread that it was moved to.
class FillingWorker final : public QObject {
    Q_OBJECT
public:
    FillingWorker();

    void begin(quint64 run, std::shared_ptr<PlaybackStream> stream);
    void leave();

signals:
    void ready(quint64 run);
    void unreadable(quint64 run, const QString& sentence);

private:
    void refill();

    std::shared_ptr<PlaybackStream> stream_;
    QTimer refill_;
};

} // namespace tp
