// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/guide/sonar_stream.hpp"
#include "audio/sound/sound_output.hpp"

#include <QObject>

#include <memory>

namespace tp {

/// Guidance by sound: what sounds is the newest cue, until silence is asked for. Without a loudspeaker
/// nothing is heard and nothing goes wrong; when there is one again, or after the next silence, it is tried again. Lives on the page's thread and never
/// blocks it.
class SonifiedGuide final : public QObject {
    Q_OBJECT
public:
    /// The output must outlive this, which has it to itself.
    explicit SonifiedGuide(SoundOutput& output, QObject* parent = nullptr);

    void sound(const SonarCue& cue);
    /// Silence now, within 6 ms of sound.
    void silence();
    bool sounds() const { return sounds_; }

private:
    SoundOutput& output_;
    std::shared_ptr<SonarStream> stream_; ///< null: the loudspeaker is not ours
    quint64 run_ = 0;
    bool sounds_ = false;
    bool missing_ = false; ///< there was no loudspeaker when one was asked for
};

} // namespace tp
