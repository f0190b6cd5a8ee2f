// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/devices/device_access.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "core/servo/clock.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/simulated/simulated_device.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <random>
#include <string>

namespace tp {

/// A number that nobody knows before, for a new study's orders.
inline std::uint64_t drawn_seed() { return std::random_device()() % 1'000'000'000U; }

/// What a program or a test gives to the study page.
struct StudySettings {
    std::filesystem::path folder; ///< each study lies in a folder of its name there; made at the first trial
    DeviceAccess devices;         ///< that move a real finger; without one the mouse is the hand
    ServoSettings device_servo;   ///< theirs
    ServoSettings servo = settings_for_a_drawn_finger();
    SimulatedPlant plant;
    std::string version;                                  ///< of the program, for the record
    std::function<std::uint64_t()> new_seed = drawn_seed; ///< of a study that begins
    VirtualClock* time = nullptr; ///< nothing ticks but by StudySession::advance; null: the machine's time
};

} // namespace tp
