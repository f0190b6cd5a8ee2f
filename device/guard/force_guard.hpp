// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tp {

/// Takes the force off a device that has no watchdog when this program no longer can. Destroyed without
/// dismiss() it does so too.
class ForceGuard {
public:
    /// What it answers to a sign of life.
    enum class Word : std::uint8_t {
        here,       ///< it watches
        stepped_in, ///< it has taken the force away since the last sign, or does not listen: no force now
        gone,       ///< nobody guards any more
    };
    virtual ~ForceGuard() = default;
    /// A sign of life, to be given before and after each message that pulls (`pulls`: the next must come
    /// within 50 ms) and after each that does not. Does not wait.
    virtual Word beat(bool pulls) noexcept = 0;
    /// The force is off and the device is given back: there is nothing more to guard.
    virtual void dismiss() noexcept = 0;
};

} // namespace tp
