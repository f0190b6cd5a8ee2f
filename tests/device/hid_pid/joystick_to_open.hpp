// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "joystick_bench.hpp"

#include <QTest>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace tp::testing {

/// A stick that is opened when a test wants it.
struct JoystickToOpen {
    ModelJoystick model;
    SimulatedJoystickLink link{model};
    PidJoystick device;

    explicit JoystickToOpen(const JoystickWire& wire = open_controller(), const JoystickScale& scale = {},
                            LatestWriter::Thread thread = LatestWriter::Thread::caller)
        : model(wire),
          device(
              [this]() -> Result<std::unique_ptr<PidTransport>> {
                  return std::unique_ptr<PidTransport>(std::make_unique<BorrowedJoystickLink>(link));
              },
              {"a stick", "0001"}, scale, thread) {}
};

/// An open controller whose effects have no direction, but axes that they are of.
inline JoystickWire with_axes_alone() {
    static const std::vector<std::uint8_t> descriptor = [] {
        const JoystickWire wire = open_controller();
        std::vector<std::uint8_t> bytes(wire.descriptor.begin(), wire.descriptor.end());
        const std::array<std::uint8_t, 4> direction{0x09, 0x57, 0xA1, 0x02};
        const auto at = std::search(bytes.begin(), bytes.end(), direction.begin(), direction.end());
        at[1] = 0x58;
        return bytes;
    }();
    JoystickWire wire = open_controller();
    wire.descriptor = descriptor;
    return wire;
}

/// The rows of a test that is asked of each kind of stick: `wire_of` is the row's.
inline void each_stick() {
    QTest::addColumn<int>("stick");
    QTest::newRow("open controller") << 0;
    QTest::newRow("plain controller") << 1;
    QTest::newRow("sidewinder") << 2;
    QTest::newRow("axes without directions") << 3;
}
inline JoystickWire wire_of(int stick) {
    return stick == 0   ? open_controller()
           : stick == 1 ? plain_controller()
           : stick == 2 ? sidewinder()
                        : with_axes_alone();
}

} // namespace tp::testing
