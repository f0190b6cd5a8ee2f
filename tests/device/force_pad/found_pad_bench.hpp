// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/servo_loop.hpp"
#include "device/force_pad/force_pad.hpp"
#include "device/force_pad/found_pad.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tp {

/// A servo on the only pad that is found, in simulated time: one tick for each report that went there and
/// back.
struct FoundPadBench {
    std::function<long()> answered; ///< reports from the computer that were answered, or taken back by it
    VirtualClock clock;
    std::unique_ptr<ForcePad> device;
    std::unique_ptr<ServoLoop> loop;
    std::string error;

    FoundPadBench(const std::vector<FoundPad>& found,
                  Result<std::unique_ptr<ReportTransport>> (*open)(const FoundPad&),
                  std::function<long()> answered_now)
        : answered(std::move(answered_now)) {
        if (found.size() != 1) {
            error = "found " + std::to_string(found.size());
            return;
        }
        device = std::make_unique<ForcePad>([open, pad = found.front()] { return open(pad); });
        Result<Capabilities> can = device->open();
        if (!can.ok()) {
            error = can.error();
            return;
        }
        loop = std::make_unique<ServoLoop>(*device, can.value(), clock, ServoSettings{});
        auto scene = make_haptic_scene(
            Scene{200.0, 150.0, {contour_through("line", {{-80.0, 0.0}, {80.0, 0.0}}, false)}});
        loop->render(std::move(scene).value());
        loop->engage();
    }
    void tick(bool wait_for_answer) {
        const long before = answered();
        clock.sleep_until(clock.now() + 0.001);
        loop->tick();
        while (wait_for_answer && answered() == before) // CTest ends a test that waits for ever
            std::this_thread::yield();
    }
    /// Until a pad that has fallen silent is stale and its force let go; how many ticks that took since the last of its
    /// frames, which may have been on its way.
    int ticks_until_let_go() {
        int ticks = 0;
        for (ServoSnapshot seen; seen.fault != Fault::stale_input || seen.force() != Vec2(0.0); seen = loop->snapshot()) {
            const long before = answered();
            tick(false);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            ticks = answered() == before ? ticks + 1 : 0;
        }
        return ticks;
    }
};

} // namespace tp
