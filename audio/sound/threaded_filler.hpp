// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/stream_filler.hpp"

#include <QThread>

namespace tp {

class FillingWorker;

/// Fills on a thread of its own, because a disk may sleep for seconds.
class ThreadedFiller final : public StreamFiller {
    Q_OBJECT
public:
    explicit ThreadedFiller(QObject* parent = nullptr);
    /// Leaves a disk that hangs where it hangs rather than keep the program from ending.
    ~ThreadedFiller() override;

    void begin(quint64 run, std::shared_ptr<PlaybackStream> stream) override;
    void leave() override;

private:
    QThread* thread_;
    FillingWorker* worker_; ///< lives on thread_, whose end deletes it
};

} // namespace tp
