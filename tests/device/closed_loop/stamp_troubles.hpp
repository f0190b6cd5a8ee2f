// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"
#include "troubled_stamps.hpp"

namespace tp::testing {

/// Passes everything on to a back end and back, with a trouble of the device's clock where a test wants one.
class StampTroubles final : public ForceDevice {
public:
    explicit StampTroubles(ForceDevice& device) : device_(device) {}

    /// From the next reading on; null: none any more.
    void begin(const StampTrouble* trouble) {
        trouble_ = trouble;
        count_ = 0;
    }

    Result<Capabilities> open() override { return device_.open(); }
    std::optional<DeviceState> read(double now) noexcept override {
        std::optional<DeviceState> state = device_.read(now);
        if (state && trouble_ == nullptr)
            last_ = state->time;
        else if (state)
            state->time = trouble_->stamped(state->time, last_, count_++);
        return state;
    }
    bool write(const SafeForce& force) noexcept override { return device_.write(force); }
    void halt() noexcept override { device_.halt(); }
    void stop() noexcept override { device_.stop(); }
    bool lost() const noexcept override { return device_.lost(); }
    bool motors_off() const noexcept override { return device_.motors_off(); }
    std::string complaint() const override { return device_.complaint(); }

private:
    ForceDevice& device_;
    const StampTrouble* trouble_ = nullptr;
    double last_ = 0.0; ///< s, the last untroubled stamp
    int count_ = 0;
};

} // namespace tp::testing
