// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/servo_loop.hpp"
#include "device_double.hpp"

#include <memory>
#include <utility>

namespace tp::testing {

/// One straight line across the plane at height `y`, mm; with a tour, one along it.
inline std::unique_ptr<const HapticScene> line_scene(double y, bool tour = false) {
    Scene scene{200.0, 150.0, {contour_through("line", {{-80.0, y}, {80.0, y}}, false)}};
    auto made = make_haptic_scene(scene);
    std::unique_ptr<HapticScene> haptic = std::move(made).value();
    if (tour)
        haptic->tour = haptic->flat.lines.front();
    return haptic;
}

/// A servo loop that ticks where the test lets time pass.
struct LoopBench {
    DeviceDouble device;
    VirtualClock clock;
    ServoLoop loop{device, DeviceDouble::capabilities(), clock, ServoSettings{}};

    void run(double seconds) {
        const double end = clock.now() + seconds;
        while (clock.now() < end - 1e-9) {
            clock.sleep_until(clock.now() + 0.001);
            loop.tick();
        }
    }
};

} // namespace tp::testing
