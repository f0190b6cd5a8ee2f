// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/guide/vibration.hpp"

#include <vector>

namespace tp::testing {

/// A motor that remembers what it was asked for.
class RecordingVibration final : public Vibration {
public:
    std::vector<double> pulses; ///< their strengths
    int stops = 0;

    bool there() const override { return true; }
    void pulse(double strength, int) override { pulses.push_back(strength); }
    void stop() override { ++stops; }
};

} // namespace tp::testing
