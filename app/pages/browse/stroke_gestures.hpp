// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>

#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// What hands do on a photograph, named by what they mean.
enum class Gesture {
    tap,
    double_tap,
    swipe_left,
    swipe_right,
    swipe_up,
    swipe_down,
    two_finger_tap,
    two_finger_double_tap,
    two_finger_z, ///< right, left and right again
    three_finger_tap,
};

/// Tells gestures from the places of fingers. What a finger draws counts, not how fast: only the two taps of
/// a double tap must follow one another in time, and each has a key.
class StrokeGestures {
public:
    struct Sizes {
        double still_px = 24.0;      ///< a tap may wander so far
        double swipe_px = 60.0;      ///< a stroke is at least so long
        double near_px = 80.0;       ///< the second tap is so near to the first
        std::int64_t again_ms = 700; ///< and begins so soon after it
    };
    StrokeGestures() = default;
    explicit StrokeGestures(Sizes sizes) : sizes_(sizes) {}

    /// The fingers that are down now, in the order of their ids; empty: all are up, and a gesture may be
    /// complete. `now_ms` on any clock that does not go back.
    std::optional<Gesture> fingers(const std::vector<QPointF>& places, std::int64_t now_ms);
    /// The system took the touch away: it was none.
    void cancel();

private:
    std::optional<Gesture> complete();
    std::optional<Gesture> taps(Gesture once, Gesture twice);
    int strokes_across() const;

    Sizes sizes_;
    std::size_t most_ = 0;       ///< fingers of this touch at once
    std::vector<QPointF> from_;  ///< where they came down
    std::vector<QPointF> track_; ///< of the first finger
    bool wandered_ = false;
    std::int64_t began_ms_ = 0;
    struct Tap {
        Gesture once;
        QPointF at;
        std::int64_t ended_ms;
    };
    std::optional<Tap> last_tap_;
    std::int64_t now_ms_ = 0;
};

} // namespace tp
