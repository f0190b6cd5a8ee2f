// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/recording/touch_recording.hpp"

#include <cstddef>

namespace tp {

/// A recorded session as a device: each read gives the next tick's reading, whatever the clock says. After
/// the last tick it is lost.
class ReplayDevice final : public ForceDevice {
public:
    /// The recording must outlive it.
    explicit ReplayDevice(const TouchRecording& recording) : recording_(recording) {}

    Result<Capabilities> open() override;
    std::optional<DeviceState> read(double now) noexcept override;
    bool write(const SafeForce& force) noexcept override;
    void halt() noexcept override {}
    void stop() noexcept override {}
    bool lost() const noexcept override;
    bool motors_off() const noexcept override;

    /// Ticks replayed, and N by which a force differed most from the recorded one.
    std::size_t ticks() const { return next_; }
    double greatest_difference() const { return greatest_difference_; }

private:
    const RecordedTick* current() const noexcept;

    const TouchRecording& recording_;
    std::size_t next_ = 0; ///< tick that the next read gives
    double greatest_difference_ = 0.0;
};

/// Ticks a loop on this device through the whole recording at its own times. A loop with the settings, scenes
/// and engagement of the recorded session sends the same forces, to the last bit.
void replay(const TouchRecording& recording, ServoLoop& loop, VirtualClock& clock);

} // namespace tp
