// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/force_feedback/feedback_kind.hpp"

namespace tp {

namespace {

bool pushes(const FeedbackBits& bits) {
    for (std::size_t bit = feedback_bit::constant; bit <= feedback_bit::ramp; ++bit)
        if (bits[bit])
            return true;
    return false;
}

/// Just what input_ff_create_memless sets for a driver that only rumbles.
bool pretends_waves(const FeedbackBits& bits) {
    using namespace feedback_bit;
    FeedbackBits memless;
    for (const std::size_t bit : {rumble, periodic, square, triangle, sine, gain})
        memless.set(bit);
    return bits == memless;
}

} // namespace

FeedbackKind feedback_kind(const FeedbackBits& bits, bool game_pad) {
    using namespace feedback_bit;
    if (pushes(bits))
        return FeedbackKind::none;
    if (bits[periodic] && !pretends_waves(bits))
        return bits[sine] ? FeedbackKind::sine : bits[square] ? FeedbackKind::square : FeedbackKind::none;
    if (!bits[rumble])
        return FeedbackKind::none;
    return game_pad ? FeedbackKind::two_motors : FeedbackKind::motor;
}

} // namespace tp
