// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/vec.hpp"
#include "core/servo/force_device.hpp"
#include "device/force_pad/protocol/frame.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tp {

/// What a pad tells of itself, as the port has it. The error says which of it cannot be.
Result<Capabilities> capabilities_of(const pad::CapabilitiesFrame& can, const std::string& serial_number,
                                     const std::vector<Vec2>& outline);

/// A force in the pad's thousandths of newtons: rounded towards zero, so that it never grows.
pad::ForceFrame force_frame(const SafeForce& force);

/// What a person is told of a pad with this status, and what to do; empty where its motors are on.
std::string pad_sentence(std::uint16_t status);

} // namespace tp
