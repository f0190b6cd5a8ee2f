// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/aim_frame.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tp {

inline constexpr double least_face_confidence = 0.5; ///< below it a face is not looked at
inline constexpr double face_stays_s = 0.5;          ///< a face that is not found for so long is gone
inline constexpr int sightings_to_count = 2;         ///< a face counts from its second frame on
inline constexpr double smoothing_s = 0.08;          ///< time constant of a box's low-pass
inline constexpr double longest_gap_s = 1.0;  ///< after a longer break, or a clock set back, all begins anew
inline constexpr std::size_t most_faces = 64; ///< the largest ones are followed

/// The side of a square as large as the box.
inline double size_of(const Rect& box) { return std::sqrt(box.width() * box.height()); }

/// One face over several frames.
struct TrackedFace {
    std::uint32_t id = 0;             ///< its own as long as it is followed
    Rect box;                         ///< smoothed, shares of the picture
    Vec2 speed{0.0};                  ///< of its middle, shares of the picture a second
    std::optional<double> tilt_deg;   ///< of the line through the eyes, clockwise in the picture; smoothed
    std::string name;                 ///< the last one that was known
    std::optional<double> brightness; ///< 0 … 1
    bool eyes_shut = false;           ///< in the last frame
    int sightings = 0;
    double seen_s = 0.0; ///< when it was found last
};

/// The names of those that are known, each once, in the order in which they came into view.
std::vector<std::string> names_of(const std::vector<TrackedFace>& faces);

/// Tells the same face in one frame after the other, whatever order they come in; a face that flickers stays.
class FaceTracks {
public:
    /// A frame without a finite time, or with an aspect that is none, changes nothing.
    void see(const AimFrame& frame);
    void forget();

    /// The faces that count, the largest first.
    const std::vector<TrackedFace>& faces() const { return counted_; }
    /// How often all began anew because the clock jumped.
    std::uint32_t breaks() const { return breaks_; }

private:
    std::vector<TrackedFace> all_;
    std::vector<TrackedFace> counted_;
    std::optional<double> last_s_;
    std::uint32_t next_id_ = 1;
    std::uint32_t breaks_ = 0;
};

} // namespace tp
