// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/polyline.hpp"
#include "core/servo/servo_loop.hpp"

#include <QString>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <utility>

namespace tp::testing {

/// Holds every tick of a loop with a device model behind it to what a person may feel; the words of the first
/// breach.
class ForceJudge {
public:
    /// `felt` is the force on the model's handle, N, in truth; `slack` N that it may be off what was sent.
    ForceJudge(const ServoLoop& loop, const Capabilities& can, std::function<Vec2()> felt, double slack)
        : loop_(loop), most_(can.max_force), felt_now_(std::move(felt)), slack_(slack),
          sent_(loop.snapshot().force()), finger_(loop.snapshot().finger()), felt_(felt_now_()),
          gain_(loop.snapshot().gain) {}

    QString complaint;
    bool wanted = true; ///< the person has the force switched on
    /// Whether one force at the handle may follow another after so many seconds, N; for a device that does not limit
    /// that itself. Empty: 0.1 N in each millisecond, and the slack.
    std::function<bool(Vec2 before, Vec2 now, double dt)> may_follow;

    /// After each tick, `dt` s after the one before.
    void judge(double dt = 0.001) {
        const ServoSnapshot view = loop_.snapshot();
        const Vec2 sent = view.force();
        const Vec2 felt = felt_now_();
        say(length(sent) > most_ + 1e-9, "the servo sends more than the device's limit", length(sent));
        // It may lose any share of itself at once, as when a person lets the force in anew before it was gone.
        const bool may_drop = view.fault != Fault::none || !view.engaged || view.gain == 0.0;
        const Vec2 from = may_drop ? nearest_on_segment(Vec2(0.0), sent_, sent) : sent_;
        // What a spring of K = 0.2 N/mm changes over the finger's own way is no jump.
        const double spring = stiffness * length(view.finger() - finger_);
        say(length(sent - from) > 40.0 * std::min(dt, 0.003) + (may_drop ? 0.0 : spring) + 1e-9,
            "the servo's force changes too fast", length(sent - sent_) / dt);
        finger_ = view.finger();
        say(length(felt) > most_ + slack_, "the handle feels more than the device's limit", length(felt));
        // One frame may carry the whole of a late tick; the device's own limit holds for each of its
        // milliseconds.
        const double steps = std::max(1.0, std::round(dt / 0.001));
        const bool follows = may_follow ? may_follow(felt_, felt, dt) : length(felt - felt_) <= 0.1 * steps + slack_;
        say(length(felt) > 2.0 * slack_ && !follows, "the handle's force changes too fast", length(felt - felt_) / dt);
        const bool rising = view.gain > gain_ || view.gain >= 1.0;
        // The tick that lets it in again begins the ramp at nothing.
        const bool to_be_there = wanted && was_wanted_;
        // Before its first reading nothing is let in; without one for 20 ms there is a fault.
        none_yet_s_ = gain_ == 0.0 && view.gain == 0.0 ? none_yet_s_ + dt : 0.0;
        const bool waits = none_yet_s_ > 0.0 && none_yet_s_ < 0.022;
        say(view.ticks > 1 && !rising && !waits && to_be_there && std::strlen(sentence(view.fault)) == 0,
            "the force goes and nobody says why", view.gain);
        sent_ = sent;
        felt_ = felt;
        gain_ = view.gain;
        was_wanted_ = wanted;
    }

private:
    void say(bool breach, const char* what, double figure) {
        if (breach && complaint.isEmpty())
            complaint = QStringLiteral("%1: %2 at %3 s")
                            .arg(QLatin1String(what))
                            .arg(figure)
                            .arg(loop_.snapshot().time);
    }

    const ServoLoop& loop_;
    double most_;
    std::function<Vec2()> felt_now_;
    double slack_;
    static constexpr double stiffness = 0.2; ///< N/mm, of the default profile, without a calibration
    Vec2 sent_;
    Vec2 finger_; ///< mm
    Vec2 felt_;
    double gain_;
    double none_yet_s_ = 0.0;
    bool was_wanted_ = true;
};

} // namespace tp::testing
