// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/clock.hpp"
#include "core/servo/force_device.hpp"
#include "core/servo/servo_loop.hpp"

#include <memory>

namespace tp {

/// A device that is open, and the loop that serves it on threads of its own once it is started. Where it ends, on any
/// thread, the force is gone first; a device that hangs may make that wait for a second.
class DeviceDrive {
public:
    /// Ticks at the device's own rate, whatever `settings` say. `clock` must outlive it; null: the machine's own.
    DeviceDrive(std::unique_ptr<ForceDevice> device, const Capabilities& can, ServoSettings settings,
                Clock* clock = nullptr);

    ServoLoop& loop() { return loop_; }
    const ServoLoop& loop() const { return loop_; }
    ForceDevice& device() { return *device_; }
    const ForceDevice& device() const { return *device_; }

private:
    SteadyClock own_clock_;
    std::unique_ptr<ForceDevice> device_;
    ServoLoop loop_; ///< after what it uses
};

/// Device frame → surface frame for a device without a calibration, such as one that stands beside the screen: true to
/// scale, the middle of what it reaches on the middle of the surface.
Affine middle_on_middle(const Capabilities& can);

/// Polygon of the places that it reaches, surface frame, mm.
std::vector<Vec2> reach_of(const Capabilities& can, const Affine& device_to_surface);

} // namespace tp
