// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/sonified_guide.hpp"

namespace tp {

SonifiedGuide::SonifiedGuide(SoundOutput& output, QObject* parent) : QObject(parent), output_(output) {
    const auto over = [this](quint64 run) {
        if (run == run_)
            stream_.reset();
    };
    connect(&output_, &SoundOutput::drained, this, over);
    connect(&output_, &SoundOutput::moved, this, over);
    connect(&output_, &SoundOutput::gone, this, [this, over](quint64 run) {
        missing_ = missing_ || run == run_;
        over(run);
    });
    connect(&output_, &SoundOutput::came, this, [this] { missing_ = false; });
}

void SonifiedGuide::sound(const SonarCue& cue) {
    sounds_ = true;
    if (stream_ != nullptr && !stream_->ended()) {
        stream_->board().write(cue);
        return;
    }
    if (missing_)
        return;
    stream_ = std::make_shared<SonarStream>();
    stream_->board().write(cue);
    output_.start(++run_, stream_);
}

void SonifiedGuide::silence() {
    if (!sounds_)
        return;
    sounds_ = missing_ = false;
    if (stream_ != nullptr)
        stream_->board().clear();
}

} // namespace tp
