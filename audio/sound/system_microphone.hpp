// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/sound_input.hpp"

#include <QAudioSource>
#include <QPointer>
#include <QTimer>

#include <memory>
#include <vector>

namespace tp {

/// This system's microphone, the default one.
class SystemMicrophone final : public SoundInput {
    Q_OBJECT
public:
    explicit SystemMicrophone(QObject* parent = nullptr);
    ~SystemMicrophone() override;

    void start() override;
    void stop() override;

private:
    void deliver();
    void look();
    void lose(Trouble trouble);

    std::unique_ptr<QAudioSource> source_; ///< null: nothing is recorded
    QPointer<QIODevice> stream_;           ///< the source's
    QByteArray id_;                        ///< of the microphone that records, or was lost
    bool lost_ = false;                    ///< a microphone is waited for
    int waited_looks_ = 0;
    int silent_looks_ = 0; ///< without anything being delivered
    QTimer look_;
    QByteArray rest_; ///< bytes of a frame that is not yet whole
    std::vector<std::int16_t> block_;
};

} // namespace tp
