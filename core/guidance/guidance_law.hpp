// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <cstdint>
#include <limits>

namespace tp {

/// What a law answers for one place of the finger.
struct Guidance {
    Vec2 force{0.0};                                           ///< N, always finite
    double distance = std::numeric_limits<double>::infinity(); ///< mm, to the contour as this law sees it
    Vec2 nearest{0.0};                                         ///< mm, the place pulled towards; see contour
    int contour = -1;                                          ///< index into the FlatScene, -1 for none
    double energy = std::numeric_limits<double>::quiet_NaN();  ///< mJ, potential; NaN for a law that has none
    std::uint32_t segment = 0; ///< of that contour's line, one that passes at `nearest`
    Vec2 towards{0.0};         ///< mm, from the finger to `nearest`; see Nearest
};

/// A way to turn the finger's place into a force. Stateless, so that any number of threads may ask; `at` is
/// called from the servo thread and therefore allocates nothing, locks nothing and throws nothing.
class GuidanceLaw {
public:
    virtual ~GuidanceLaw() = default;
    /// `finger` in mm, surface frame. A finger that is not finite gets no force.
    virtual Guidance at(Vec2 finger) const noexcept = 0;
    /// The same as `at` wherever the law pulls; elsewhere there may be no contour in the answer, since the
    /// distance where nothing pulls takes the longest to find. What the servo asks at every tick.
    virtual Guidance felt_at(Vec2 finger) const noexcept { return at(finger); }
    /// The force of `at` and nothing else, N: pictures and sums over a whole surface want no distance where
    /// nothing pulls, which takes the longest to find.
    virtual Vec2 force_at(Vec2 finger) const noexcept { return at(finger).force; }
};

} // namespace tp
