// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/haptic_scene.hpp"
#include "core/servo/servo_loop.hpp"

#include <QString>

#include <algorithm>
#include <cstring>

namespace tp::testing {

/// 80 mm across, `y` above the middle.
inline Contour line_at(Vec2 centre, double y) {
    return contour_through("line", {{centre.x - 40.0, centre.y + y}, {centre.x + 40.0, centre.y + y}}, false);
}

/// Holds every tick of a bench to what a person may feel; the words of the first breach.
///
/// A bench has a `loop`, a `clock`, what the device `can`, the force that is `felt()` at its handle, and
/// `felt_change(dt)`, the most by which that may change in a tick of this length, N.
template <typename Bench>
class Judge {
public:
    Judge(Bench& bench, double slack)
        : bench_(bench), slack_(slack), sent_(bench.loop->snapshot().force()), felt_(bench.felt()),
          gain_(bench.loop->snapshot().gain) {}

    QString complaint;
    bool let_go = false; ///< the person switched the force off

    void judge(double dt = 0.001) {
        const ServoSnapshot view = bench_.loop->snapshot();
        const Vec2 sent = view.force();
        const Vec2 felt = bench_.felt();
        const double most = bench_.can.max_force;
        say(length(sent) > most + 1e-9, "the servo sends more than the device's limit", length(sent));
        const bool down = length(sent) <= length(sent_) + 1e-12;
        // Off may be at once, as when a person lets the force in anew before it was gone.
        const bool may_drop = view.fault != Fault::none || !view.engaged || view.gain == 0.0;
        say(!(down && may_drop) && length(sent - sent_) > 40.0 * std::min(dt, 0.003) + 1e-9,
            "the servo's force changes too fast", length(sent - sent_) / dt);
        say(length(felt) > most + slack_, "the handle feels more than the device's limit", length(felt));
        say(length(felt) > 2.0 * slack_ && !bench_.may_be_felt(felt_, felt, dt, slack_),
            "the handle's force changes too fast", length(felt - felt_) / dt);
        const bool rising = view.gain > gain_ || view.gain >= 1.0;
        say(view.ticks > 1 && !rising && !let_go && std::strlen(sentence(view.fault)) == 0,
            "the force goes and nobody says why", view.gain);
        sent_ = sent;
        felt_ = felt;
        gain_ = view.gain;
    }

private:
    void say(bool breach, const char* what, double figure) {
        if (breach && complaint.isEmpty())
            complaint =
                QStringLiteral("%1: %2 at %3 s").arg(QLatin1String(what)).arg(figure).arg(bench_.clock.now());
    }

    Bench& bench_;
    double slack_;
    Vec2 sent_;
    Vec2 felt_;
    double gain_;
};

} // namespace tp::testing
