// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/guard/force_guard.hpp"
#include "device/system_handle.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tp {

/// Where touchphoto-force-guard lies: beside the program that runs, or where such helpers are installed.
std::string force_guard_program();

/// Starts that program as a process of its own, which holds the opened device open too, and waits until it
/// watches: it takes the force away when this process ends in whatever way (SIGKILL too) or goes on
/// pulling without a sign of life for 50 ms. The words say how, as device/guard/process/main.cpp has them.
/// An error where it cannot be started, or where this system gives no handle of the device.
Result<std::unique_ptr<ForceGuard>> start_force_guard(const std::string& program, SystemHandle opened,
                                                      const std::vector<std::string>& words);

/// Bytes as one of those words.
std::string guard_word(std::span<const std::uint8_t> bytes);

} // namespace tp
