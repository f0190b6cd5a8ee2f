// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"

#include <atomic>
#include <functional>
#include <utility>
#include <vector>

namespace tp::testing {

/// A device that a test moves by hand, with a knob for everything that goes wrong.
class DeviceDouble final : public ForceDevice {
public:
    std::function<Vec2(double)> place = [](double) { return Vec2(0.0); };
    std::function<double(double)> stamp = [](double now) { return now; };
    bool silent = false;    ///< no readings
    bool unplugged = false; ///< lost
    bool refuses_writes = false;

    std::vector<std::pair<double, Vec2>> written; ///< time of the last reading asked for, N
    int stops = 0;
    std::atomic<int> halts{0};

    static Capabilities capabilities() {
        Capabilities can;
        can.name = "double";
        can.workspace = {{-100, -75}, {100, -75}, {100, 75}, {-100, 75}};
        can.max_force = 3.0;
        return can;
    }

    Result<Capabilities> open() override { return capabilities(); }
    std::optional<DeviceState> read(double now) noexcept override {
        now_ = now;
        if (silent || unplugged)
            return std::nullopt;
        return DeviceState{stamp(now), place(now), 0};
    }
    bool write(const SafeForce& force) noexcept override {
        written.emplace_back(now_, force.newtons());
        return !refuses_writes && !unplugged;
    }
    void halt() noexcept override { ++halts; }
    void stop() noexcept override { ++stops; }
    bool lost() const noexcept override { return unplugged; }

    Vec2 last_force() const { return written.empty() ? Vec2(0.0) : written.back().second; }

private:
    double now_ = 0.0;
};

} // namespace tp::testing
