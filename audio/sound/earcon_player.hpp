// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/earcon_stream.hpp"
#include "audio/sound/sound_output.hpp"

#include <QObject>

#include <memory>

namespace tp {

/// Plays earcons at once, over whatever else sounds. Without a loudspeaker they are dropped: one that comes
/// late says something wrong. Lives on the page's thread and never blocks it.
class EarconPlayer final : public QObject {
    Q_OBJECT
public:
    /// The output must outlive this, which has it to itself: a recording needs another.
    explicit EarconPlayer(SoundOutput& output, QObject* parent = nullptr);

    void play(Earcon earcon);
    void set_on(bool on) { on_ = on; }

private:
    SoundOutput& output_;
    std::shared_ptr<EarconStream> stream_; ///< null: nothing is being played
    quint64 run_ = 0;
    bool on_ = true;
};

} // namespace tp
