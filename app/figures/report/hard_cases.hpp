// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/haptic_scene.hpp"

#include <string>
#include <vector>

namespace tp {

/// A scene and places of the finger where a law that is not careful goes wrong.
struct HardPlace {
    std::string name;
    FlatScene scene;
    std::vector<Vec2> fingers; ///< mm
};

/// The places by name: on a line, on a vertex, at a crossing, between contours, degenerate and huge geometry,
/// what is not a number, the edges of the band.
std::vector<HardPlace> hard_places();

/// How a law, or the whole servo with it, came through a case.
struct HardVerdict {
    std::string name;
    std::string law;     ///< "exact" or "published"
    std::string verdict; ///< "right", "wrong" (finite and bounded, but not the force asked for) or "unsafe"
    double max_force_n = 0.0;
    std::string note; ///< what was seen
};

/// Every hard place, and the events in time (a late tick, a scene swapped in mid-touch, a device that jumps),
/// for both laws.
std::vector<HardVerdict> judge_hard_cases();

} // namespace tp
