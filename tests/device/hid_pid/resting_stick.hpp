// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/hid_pid/model_joystick.hpp"
#include "device/hid_pid/pid_transport.hpp"

#include <cstdint>
#include <vector>

namespace tp::testing {

/// An open controller whose grip rests in the middle; what it hears and says is the test's.
class RestingStick : public PidTransport {
public:
    std::vector<std::uint8_t> descriptor() override {
        const JoystickWire wire = open_controller();
        return {wire.descriptor.begin(), wire.descriptor.end()};
    }
    Got input_now(hid::Report& report) noexcept override {
        report = {};
        report.bytes[0] = 1;
        report.size = 13;
        return Got::report;
    }
};

} // namespace tp::testing
