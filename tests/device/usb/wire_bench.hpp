// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/servo_loop.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>

namespace tp::testing {

/// A servo on a device behind its real transport, in simulated time: one tick for each message that went there and
/// back. CTest ends a test that waits for ever.
template <typename Device>
struct WireBench {
    std::function<long()> answered; ///< messages that were answered, or taken back by the computer
    VirtualClock clock;
    std::unique_ptr<Device> device;
    std::unique_ptr<ServoLoop> loop;
    std::string error; ///< why there is no loop

    explicit WireBench(std::function<long()> answered_now) : answered(std::move(answered_now)) {}

    /// Opens it, and lets it pull towards a line along the middle.
    void begin(std::unique_ptr<Device> made) {
        device = std::move(made);
        const Result<Capabilities> can = device->open();
        if (!can.ok()) {
            error = can.error();
            return;
        }
        loop = std::make_unique<ServoLoop>(*device, *can, clock, ServoSettings{});
        auto scene = make_haptic_scene(
            Scene{200.0, 150.0, {contour_through("line", {{-50.0, 0.0}, {50.0, 0.0}}, false)}});
        loop->render(std::move(scene).value());
        loop->engage();
    }
    void tick(bool wait_for_answer = true) {
        const long before = answered();
        clock.sleep_until(clock.now() + 0.001);
        loop->tick();
        while (wait_for_answer && answered() == before)
            std::this_thread::yield();
    }
    /// Lets go on without waiting for answers until something holds.
    template <typename Condition>
    void until(Condition holds) {
        while (!holds()) {
            tick(false);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
};

} // namespace tp::testing
