// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/earcon_player.hpp"

namespace tp {

EarconPlayer::EarconPlayer(SoundOutput& output, QObject* parent) : QObject(parent), output_(output) {
    const auto over = [this](quint64 run) {
        if (run == run_)
            stream_.reset();
    };
    connect(&output_, &SoundOutput::drained, this, over);
    connect(&output_, &SoundOutput::gone, this, over);
    connect(&output_, &SoundOutput::moved, this, over);
}

void EarconPlayer::play(Earcon earcon) {
    if (!on_ || (stream_ != nullptr && stream_->add(earcon)))
        return;
    stream_ = std::make_shared<EarconStream>();
    stream_->add(earcon);
    output_.start(++run_, stream_);
}

} // namespace tp
