// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

namespace tp {

/// What a stick makes of the numbers it is sent. They are a share of a greatest force that no stick tells,
/// and which way a positive one pulls differs between devices.
struct JoystickScale {
    /// N at the grip for the whole share. The strongest direct-drive bases give 12 N·m, 60 N on a lever of
    /// 0.2 m: until it was measured a stick counts as one of those, so that a weaker one pulls less than it
    /// is asked to.
    double newtons_at_full = 60.0;
    /// Of each axis: 1 where a positive share pulls to the right, or away from the person. PID 1.0 names the
    /// direction that the force comes from.
    Vec2 sign{-1.0, -1.0};
    bool measured = false; ///< by a person; its newtons are newtons
};

} // namespace tp
