// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/sonified_guide.hpp"

namespace tp {

namespace {
constexpr int bump_ms = 25;
constexpr double bump_strength = 0.6;
constexpr double line_strength = 1.0;
} // namespace

SonifiedGuide::SonifiedGuide(SoundOutput& output, Vibration& vibration, QObject* parent)
    : QObject(parent), output_(output), vibration_(vibration) {
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
    if (cue.steady() && !on_line_)
        pulse(line_strength);
    on_line_ = cue.steady();
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
    sounds_ = on_line_ = missing_ = false;
    if (stream_ != nullptr)
        stream_->board().clear();
    vibration_.stop();
}

void SonifiedGuide::bump() { pulse(bump_strength); }

void SonifiedGuide::pulse(double strength) { vibration_.pulse(strength, bump_ms); }

} // namespace tp
