// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/sound_source.hpp"
#include "audio/sound/source_device.hpp"

#include <QAudioSink>
#include <QObject>
#include <QTimer>

#include <memory>

namespace tp {

/// SystemLoudspeaker's other end: every call on the thread that it was moved to. Signals as SoundOutput's.
class LoudspeakerWorker final : public QObject {
    Q_OBJECT
public:
    LoudspeakerWorker();
    ~LoudspeakerWorker() override;

    void start(quint64 run, std::shared_ptr<SoundSource> source);
    void stop();

signals:
    void progress(quint64 run);
    void drained(quint64 run);
    void gone(quint64 run);
    void moved(quint64 run);
    void came();

private:
    void look();
    void look_at_sound();
    void look_at_devices();
    void lose();

    quint64 run_ = 0;
    std::unique_ptr<QAudioSink> sink_; ///< null: nothing plays
    SourceDevice* device_ = nullptr;   ///< the sink's child, for the sink may read it as long as it lives
    QByteArray id_;                    ///< of the loudspeaker that plays, or was lost
    std::int64_t heard_ = 0;           ///< frames
    QTimer look_;
    int looks_ = 0;       ///< since the last look at the devices
    int looks_alike_ = 0; ///< since something new was heard
    bool keeps_up_ = true; ///< with a short buffer, as far as is known
    bool lost_ = false;   ///< a loudspeaker is waited for
    int waited_looks_ = 0;
};

} // namespace tp
