// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/safety_chain.hpp"
#include "device_double.hpp"

/// A chain at 1 kHz in simulated time, with a law that pulls with one newton to the right.
struct ChainBench {
    tp::SafetyLimits limits;
    tp::SafetyChain chain{limits, tp::testing::DeviceDouble::capabilities(), 0.001};
    tp::SafetyInput input;

    ChainBench() {
        input.fresh = true;
        input.force = {1.0, 0.0};
        chain.engage(0.0);
    }
    tp::Vec2 tick(double dt = 0.001) {
        input.now += dt;
        return chain.pass(input).newtons();
    }
    tp::Vec2 run(double seconds) {
        tp::Vec2 force(0.0);
        for (double t = 0.0; t < seconds; t += 0.001)
            force = tick();
        return force;
    }
    /// Seconds of further ticks until the force is zero.
    double until_zero(double dt = 0.001) {
        for (double t = dt; t < 1.0; t += dt)
            if (tick(dt) == tp::Vec2(0.0))
                return t;
        return 1.0;
    }
};
