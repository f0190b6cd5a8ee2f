// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

namespace tp {

/// How a camera lies in the hand of the person who aims it.
///
/// The back camera looks where the person looks: a face at the right of the picture is at the person's right, and the
/// camera that is moved left moves the face to the right. The front camera looks at the person: what it sees at
/// the right is at the person's left. A mirrored picture turns either round once more.
struct HeldCamera {
    bool front = false;
    bool mirrored = false; ///< the frames are: left and right are swapped in them

    bool swaps_sides() const { return front != mirrored; }
    /// The same way, from the picture (x right, y down, any unit) to the person's own hand (x right, y up): where
    /// the hand shall go so that what is off by that much comes to its place.
    Vec2 hand_way(Vec2 picture_way) const {
        return {swaps_sides() ? -picture_way.x : picture_way.x, -picture_way.y};
    }
    /// A turn clockwise as the picture shows it, as a turn clockwise of the camera as its holder sees it, that
    /// takes it away; any unit.
    double hand_turn(double clockwise) const { return swaps_sides() ? -clockwise : clockwise; }
};

} // namespace tp
