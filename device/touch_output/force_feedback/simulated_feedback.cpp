// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/force_feedback/simulated_feedback.hpp"

#include <algorithm>
#include <cerrno>

namespace tp {

void ModelMotor::step() {
    ++now_ms_;
    // A length of 0 is without an end, as the kernel has it.
    if (troubles.unplugged || (begun_.length_ms != 0 && now_ms_ - begun_ms_ >= begun_.length_ms))
        playing_ = false;
}

double ModelMotor::shakes() const {
    return playing_ && !troubles.unplugged ? std::max(begun_.strong, begun_.weak) / 65535.0 : 0.0;
}

SimulatedFeedbackNode::~SimulatedFeedbackNode() {
    if (!stored_)
        return;
    motor_.playing_ = false;
    ++motor_.free_;
}

int SimulatedFeedbackNode::upload(const FeedbackEffect& effect) noexcept {
    for (unsigned ms = 0; ms < motor_.troubles.upload_takes_ms; ++ms)
        motor_.step();
    if (motor_.troubles.unplugged)
        return ENODEV;
    if (motor_.troubles.refuses)
        return EIO;
    if (plays_waves(motor_.kind_) && effect.period_ms == 0)
        return EINVAL;
    if (!stored_) {
        if (motor_.free_ == 0)
            return ENOSPC;
        --motor_.free_;
    }
    stored_ = effect;
    ++motor_.uploads_;
    return 0;
}

int SimulatedFeedbackNode::play(bool on) noexcept {
    if (motor_.troubles.unplugged)
        return ENODEV;
    if (motor_.troubles.refuses)
        return EIO;
    motor_.playing_ = on && stored_;
    if (motor_.playing_) {
        motor_.begun_ = *stored_;
        motor_.begun_ms_ = motor_.now_ms_;
        ++motor_.beginnings_;
    }
    return 0;
}

} // namespace tp
