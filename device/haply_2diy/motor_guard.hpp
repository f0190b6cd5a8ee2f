// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Takes the torque off a board when this program no longer can: the board's firmware has no watchdog.
/// Destroyed without dismiss() it does so too.
class MotorGuard {
public:
    virtual ~MotorGuard() = default;
    /// A sign of life, to be given before each command that pulls (`pulls`: the next must come within 50 ms)
    /// and after each that does not. False where nobody guards any more. Does not wait.
    virtual bool beat(bool pulls) noexcept = 0;
    /// The torque is off and the line is given back: there is nothing more to guard.
    virtual void dismiss() noexcept = 0;
};

} // namespace tp
