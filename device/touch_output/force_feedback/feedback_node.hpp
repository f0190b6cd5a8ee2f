// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/force_feedback/feedback_effect.hpp"

namespace tp {

/// A device that plays effects, opened for one program that has one place in its table of effects. Whoever closes it, or dies,
/// ends what plays. Its writer calls it; `there` any thread.
class FeedbackNode {
public:
    virtual ~FeedbackNode() = default;
    virtual FeedbackKind kind() const = 0;
    /// Puts an effect into the place, the first one with a place of its own. 0, or the errno. May block for as long as the
    /// driver likes.
    virtual int upload(const FeedbackEffect& effect) noexcept = 0;
    /// Plays what is in the place from its beginning, or ends it. 0, or the errno.
    virtual int play(bool on) noexcept = 0;
    /// It has not been unplugged. Does not wait.
    virtual bool there() const noexcept = 0;
};

} // namespace tp
