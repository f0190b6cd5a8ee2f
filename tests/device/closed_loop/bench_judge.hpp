// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device_under_test.hpp"
#include "force_judge.hpp"

namespace tp::testing {

/// Holds each tick of a bench to what a person may feel.
class BenchJudge : public ForceJudge {
public:
    BenchJudge(const DeviceUnderTest& device, LoopBench& bench, double slack)
        : ForceJudge(
              *bench.loop, bench.can, [&bench] { return bench.felt(); }, slack) {
        if (device.may_follow)
            may_follow = [&device, &bench](Vec2 before, Vec2 now, double dt) {
                return device.may_follow(bench, before, now, dt);
            };
    }
};

} // namespace tp::testing
