// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/clock.hpp"
#include "core/servo/force_device.hpp"

#include <atomic>
#include <cstdint>

namespace tp {

/// A device that passes everything on to another, with a knob for each thing that goes wrong with real ones. The knobs
/// may be turned from any thread while the servo ticks.
class FaultyDevice final : public ForceDevice {
public:
    /// Both must outlive it. `clock` is the servo's.
    FaultyDevice(ForceDevice& device, Clock& clock) : device_(device), clock_(clock) {}

    std::atomic<double> drop{0.0}; ///< share of readings that do not come, the same ones in each run
    std::atomic<bool> silent{false};
    std::atomic<bool> refuses{false};
    std::atomic<bool> its_motors_off{false};
    std::atomic<bool> unplugged{false};
    /// The next write takes that many seconds.
    void hang_once(double seconds) noexcept { hang_.store(seconds); }

    Result<Capabilities> open() override { return device_.open(); }
    std::optional<DeviceState> read(double now) noexcept override;
    bool write(const SafeForce& force) noexcept override;
    void halt() noexcept override { device_.halt(); }
    void stop() noexcept override { device_.stop(); }
    bool lost() const noexcept override { return unplugged || device_.lost(); }
    bool motors_off() const noexcept override { return its_motors_off || device_.motors_off(); }

private:
    bool dropped() noexcept;

    ForceDevice& device_;
    Clock& clock_;
    std::atomic<double> hang_{0.0};  ///< s
    std::uint64_t random_ = 88172645463325252U; ///< only the servo's thread
};

} // namespace tp
