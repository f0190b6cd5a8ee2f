// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../usb/wire_bench.hpp"
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

/// The only pad that is found, behind its real transport.
struct FoundPadBench : testing::WireBench<ForcePad> {
    FoundPadBench(const std::vector<FoundPad>& found,
                  Result<std::unique_ptr<ReportTransport>> (*open)(const FoundPad&),
                  std::function<long()> answered_now)
        : WireBench(std::move(answered_now)) {
        if (found.size() == 1)
            begin(std::make_unique<ForcePad>([open, pad = found.front()] { return open(pad); }));
        else
            error = "found " + std::to_string(found.size());
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
