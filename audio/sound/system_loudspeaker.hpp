// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/sound_output.hpp"

#include <QThread>

namespace tp {

class LoudspeakerWorker;

/// This system's loudspeaker, the default one, on a thread of its own, so that a page that is busy is not
/// heard.
class SystemLoudspeaker final : public SoundOutput {
    Q_OBJECT
public:
    explicit SystemLoudspeaker(QObject* parent = nullptr);
    /// Leaves a sound server that hangs where it hangs rather than keep the program from ending.
    ~SystemLoudspeaker() override;

    void start(quint64 run, std::shared_ptr<SoundSource> source) override;
    void stop() override;

private:
    QThread* thread_;
    LoudspeakerWorker* worker_; ///< lives on thread_, whose end deletes it
};

} // namespace tp
