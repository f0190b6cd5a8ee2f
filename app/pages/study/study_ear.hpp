// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/guide/sonified_guide.hpp"
#include "core/geometry/vec.hpp"
#include "core/servo/snapshot.hpp"

namespace tp {

/// The tone that stands for touch where the finger is only drawn and nobody feels its force: it says where the nearest line lies,
/// as on the Explore page. A device's finger is left in silence.
class StudyEar {
public:
    /// The guide must outlive it.
    explicit StudyEar(SonifiedGuide& guide) : guide_(guide) {}

    void hear(const ServoSnapshot& seen, Vec2 finger) {
        if (seen.contour < 0)
            return guide_.silence();
        guide_.sound(sonar_cue(seen.distance, seen.nearest_x - finger.x, seen.nearest_y - finger.y));
    }
    void silence() { guide_.silence(); }

private:
    SonifiedGuide& guide_;
};

} // namespace tp
