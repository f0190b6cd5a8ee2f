// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/calibration.hpp"
#include "core/geometry/vec.hpp"
#include "core/servo/servo_loop.hpp"

#include <optional>
#include <vector>

namespace tp {

/// For a loop that only reads: nothing pulls, so a computer that is late for a moment takes nothing away.
ServoSettings settings_for_reading(ServoSettings settings);

/// A person's way through the marks of a calibration: the four corners of an area, one after the other, each held for a
/// moment with the finger in the device. Every place at which the finger is slow enough for both frames to be of one
/// moment makes a pair, on the way between marks too.
class CalibrationSteps {
public:
    enum Mark { top_left, top_right, bottom_right, bottom_left, all_touched };

    static constexpr double hold_s = 0.7;        ///< how long a mark is held
    static constexpr double rest_mm = 2.0;       ///< how far a finger that is held may drift meanwhile
    static constexpr double slow_mm_s = 30.0;    ///< at 20 ms between touch and device that is 0.6 mm
    static constexpr double between_s = 0.05;    ///< pairs
    static constexpr double corner_share = 0.15; ///< of the area's size that a mark lies off its middle, at least

    /// Where the person touches, screen frame (mm, y up).
    explicit CalibrationSteps(const Rect& area) : area_(area) {}

    Mark mark() const { return mark_; }
    /// The finger is at `touched` (screen frame) on the screen and at `device` (device frame) in the device at `now` s;
    /// asked again and again, also while it rests. True where the mark has been reached with it.
    bool sample(Vec2 touched, Vec2 device, double now);
    /// The finger has left the screen.
    void lift();
    const std::vector<FramePair>& pairs() const { return pairs_; }
    /// The map that the pairs agree on and how far it misses, at the marks or all in all, whichever is more; any
    /// miss is answered. A map that three corners agree on and the fourth does not misses that one.
    Result<Calibration> calibration() const;

private:
    struct Sample {
        FramePair pair;
        double time = 0.0;
    };
    bool is_at_mark(Vec2 touched) const;

    Rect area_;
    Mark mark_ = top_left;
    std::vector<FramePair> pairs_;
    std::vector<FramePair> reached_; ///< the finger on each mark
    std::optional<Sample> last_;   ///< since the finger came
    std::optional<Sample> rested_; ///< where and since when it rests
    double paired_at_ = -1e9;      ///< s
};

} // namespace tp
