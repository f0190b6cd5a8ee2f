// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Why the force was taken away. Ordered by gravity: a graver one replaces a lighter one.
enum class Fault {
    none,
    not_a_number,      ///< position or force not finite: no force in this tick
    outside_workspace, ///< the device reports a place it cannot reach: ramp to zero
    over_speed,        ///< faster than any hand moves on purpose: ramp to zero
    motors_off,        ///< the device has switched its motors off itself: ramp to zero
    stale_input,       ///< no newer reading for 20 ms: ramp to zero
    late_ticks,        ///< the loop was more than three periods late: ramp to zero
    stalled,           ///< the loop stood still for more than 50 ms: the device is disabled
    device_lost,       ///< the device does not answer or was unplugged: disabled
};

/// What a person is told, in a sentence. Empty for `none`.
const char* sentence(Fault fault);

/// The device stays off until it is engaged again by a person.
inline bool disables(Fault fault) { return fault >= Fault::stalled; }

} // namespace tp
