// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/dwell.hpp"
#include "app/parts/devices/device_access.hpp"
#include "app/parts/devices/touch_access.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/photo/scene/extra_features.hpp"
#include "app/photo/scene/scene_builder.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/simulated/simulated_device.hpp"

#include <QString>

#include <functional>

namespace tp {

/// What a program or a test gives to the explore page.
struct ExploreSettings {
    /// The photograph of the album after that file (`forward`) or before it; of no file, or one that the album does not
    /// have, the oldest or the newest. Empty: there is none.
    using Beside = std::function<QString(const QString& file, bool forward)>;

    SurfaceSize surface;
    ExtraFeatures extras; ///< felt beside those that the person has chosen
    ServoSettings servo = settings_for_a_drawn_finger();
    SimulatedPlant plant;
    DeviceAccess devices;            ///< that move a real finger; without one the force is only drawn
    ServoSettings device_servo;      ///< theirs
    TouchAccess touch;               ///< outputs under a bare finger; without one nothing ticks
    double dwell_s = Dwell::usual_s; ///< how long a finger stays on a feature before it is told
    Beside beside;                   ///< empty: there is no album
    std::function<double()> now;     ///< seconds; empty: real time since the session was made
};

} // namespace tp
