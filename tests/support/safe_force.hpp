// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/safety_chain.hpp"

namespace tp::testing {

/// A force of the safety chain, with its whole share: nothing else can make one. N; at most `max_force`.
inline SafeForce safe(Vec2 newtons, double max_force = SafetyLimits{}.max_force) {
    Capabilities can;
    can.max_force = 100.0;
    SafetyLimits limits;
    limits.max_force = max_force;
    limits.max_force_rate = 1e9;
    limits.engage_ramp = 0.001;
    SafetyChain chain(limits, can, 0.001);
    chain.engage(0.0);
    SafetyInput input;
    input.now = 0.001;
    input.fresh = true;
    input.force = newtons;
    return chain.pass(input);
}

} // namespace tp::testing
