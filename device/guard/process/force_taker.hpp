// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

/// The process that takes the force off a device when the program beside it no longer can.
namespace tp::guard {

/// How the force is taken off one kind of device.
class ForceTaker {
public:
    virtual ~ForceTaker() = default;
    /// The program pulls and stands still: takes the force away. False where the program cannot go on with
    /// the device afterwards.
    virtual bool let_go() = 0;
    /// The program is gone; `may_pull` where it left a force on the device, as far as one knows.
    virtual void leave(bool may_pull) = 0;
};

using Bytes = std::vector<std::uint8_t>;

/// A Haply board on a serial line, set up as that frame says. Nothing where it is no set-up.
std::unique_ptr<ForceTaker> board_taker(const Bytes& set_up);

/// A device whose node takes one report with each write: `no_force` takes the force away, `at_the_end`
/// follows where the program is gone.
std::unique_ptr<ForceTaker> report_taker(std::vector<Bytes> no_force, std::vector<Bytes> at_the_end);

/// A device on the USB whose interface the descriptor has claimed: a packet to this bulk endpoint takes the
/// force away. Nothing on a system without usbfs.
std::unique_ptr<ForceTaker> packet_taker(std::uint8_t endpoint, Bytes no_force);

} // namespace tp::guard
