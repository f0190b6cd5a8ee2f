// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/haply_2diy/motor_guard.hpp"
#include "device/haply_2diy/protocol/board_frames.hpp"

#include <memory>
#include <string>

namespace tp {

/// Where touchphoto-torque-guard lies: beside the program that runs.
std::string torque_guard_program();

/// Starts that program as a process of its own, which holds the line open too, and waits until it watches: it
/// writes no torque to the line when this process ends in whatever way (SIGKILL too) or goes on pulling
/// without a sign of life for 50 ms. An error where it cannot be started.
Result<std::unique_ptr<MotorGuard>> start_torque_guard(const std::string& program, int line_descriptor,
                                                       const haply::SetUp& set_up);

} // namespace tp
