// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace tp {

/// What the servo read and wrote in one tick.
struct TickSample {
    double time = 0.0; ///< s, servo's clock
    Vec2 place{0.0};   ///< mm
    Vec2 force{0.0};   ///< N
};

/// A device that passes everything on to another and lets a page see every tick. The servo's thread puts ticks into a
/// ring and waits for nothing; another thread takes them out. A page that does not come for 16 s misses what does not
/// fit.
class TickTap final : public ForceDevice {
public:
    /// The device must outlive it.
    explicit TickTap(ForceDevice& device) : device_(device) {}

    Result<Capabilities> open() override { return device_.open(); }
    std::optional<DeviceState> read(double now) noexcept override;
    bool write(const SafeForce& force) noexcept override;
    void halt() noexcept override { device_.halt(); }
    void stop() noexcept override { device_.stop(); }
    bool lost() const noexcept override { return device_.lost(); }
    bool motors_off() const noexcept override { return device_.motors_off(); }

    /// What came since the last call, the oldest first. One thread at a time.
    std::vector<TickSample> take();

private:
    static constexpr std::uint64_t ring_size = 16384; ///< ticks: 16 s at 1 kHz

    ForceDevice& device_;
    std::array<TickSample, ring_size> ring_{};
    std::atomic<std::uint64_t> made_{0};
    std::atomic<std::uint64_t> taken_{0};
    std::atomic<std::thread::id> servo_{}; ///< what the watchdog writes from its own thread is no tick
    TickSample tick_;                      ///< only the servo's thread
    bool ticking_ = false;                 ///< a read came, its write not yet; only the servo's thread
};

} // namespace tp
