// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/adviser.hpp"
#include "frames.hpp"

#include <cstddef>
#include <limits>

namespace tp::testing {

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// An adviser with its tracks, shown one frame after the other.
struct Watched {
    explicit Watched(Aim aim = Aim::middle, HeldCamera camera = {}) : adviser(aim, camera) {}
    AimInstruction see(AimFrame frame) {
        frame.time_s = now += 0.1;
        tracks.see(frame);
        return adviser.advise(tracks.faces(), frame);
    }
    AimInstruction see(const AimFace& face) { return see(frame_of(0.0, {face})); }
    /// Until smoothing has settled.
    AimInstruction stare(const AimFrame& frame) {
        AimInstruction last;
        for (int i = 0; i < 15; ++i)
            last = see(frame);
        return last;
    }
    AimInstruction stare(const AimFace& face) { return stare(frame_of(0.0, {face})); }
    double size(AimFault fault) const { return adviser.faults()[static_cast<std::size_t>(fault)]; }
    void forget() {
        adviser.forget();
        tracks.forget();
    }

    FaceTracks tracks;
    Adviser adviser;
    double now = 0.0;
};

} // namespace tp::testing
