// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/click_sound.hpp"

#include <utility>

namespace tp {

ClickSound::ClickSound(SoundOutput& output, std::function<double()> now, QObject* parent)
    : QObject(parent), output_(output), now_(std::move(now)) {
    connect(&output_, &SoundOutput::moved, this, [this](quint64 run) {
        if (run == run_)
            play();
    });
    connect(&output_, &SoundOutput::came, this, &ClickSound::play);
}

void ClickSound::play() {
    if (wanted_)
        output_.start(++run_, std::make_shared<ClickStream>(list_, now_));
}

void ClickSound::begin() {
    if (std::exchange(wanted_, true))
        return;
    list_->hush();
    play();
}

void ClickSound::end() {
    if (!std::exchange(wanted_, false))
        return;
    list_->hush();
    output_.stop();
}

} // namespace tp
