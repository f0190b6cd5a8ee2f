// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"

#include <functional>
#include <utility>

namespace tp {

/// A device that a hand moves as it likes, whatever pulls: its place is a function of time, mm over s.
class DrivenDevice final : public ForceDevice {
public:
    DrivenDevice(Capabilities can, std::function<Vec2(double)> place)
        : can_(std::move(can)), place_(std::move(place)) {}

    Result<Capabilities> open() override { return can_; }
    std::optional<DeviceState> read(double now) noexcept override { return DeviceState{now, place_(now), 0}; }
    bool write(const SafeForce& force) noexcept override {
        written_ = force.newtons();
        return true;
    }
    void halt() noexcept override { written_ = Vec2(0.0); }
    void stop() noexcept override { written_ = Vec2(0.0); }

    /// N
    Vec2 written() const { return written_; }

private:
    Capabilities can_;
    std::function<Vec2(double)> place_;
    Vec2 written_{0.0};
};

} // namespace tp
