// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/advice_pace.hpp"
#include "core/aiming/adviser.hpp"
#include "core/aiming/aim_tone.hpp"
#include "core/aiming/face_tracks.hpp"
#include "core/aiming/self_timer.hpp"

#include <cstdint>
#include <optional>

namespace tp {

/// What to do about one frame.
struct AimAnswer {
    AimInstruction now;                ///< what is true, said or not
    std::optional<AimInstruction> say; ///< to be said now; then `Aiming::sentence_ended` is owed
    AimTone tone;
    bool good = false; ///< the frame is as it was wished
    bool take = false; ///< the shutter, where it acts by itself
};

/// From frames to words, tone and shutter. Knows no clock but the frames' own; deterministic; one thread.
class Aiming {
public:
    explicit Aiming(Aim aim, HeldCamera camera = {}) : adviser_(aim, camera), camera_(camera) {}

    AimAnswer see(const AimFrame& frame);
    /// The sentence that was to be said is over, or was broken off, at `now_s` of the frames' clock.
    void sentence_ended(double now_s) { pace_.sentence_ended(now_s); }
    /// The next instruction is said anew.
    void aim_at(Aim aim);
    /// How many people belong to everybody, where the person says so; 0: whoever is seen.
    void expect(int people) { adviser_.expect(people); }
    void hold(HeldCamera camera);
    /// The tone is made to sound; words then say first what it does not.
    void with_tone(bool tone) { adviser_.with_tone(tone); }
    /// The next picture may follow at once.
    void arm() { timer_.arm(); }

    const FaceTracks& tracks() const { return tracks_; }

private:
    FaceTracks tracks_;
    Adviser adviser_;
    AdvicePace pace_;
    SelfTimer timer_;
    HeldCamera camera_;
    AimAnswer last_;
    std::uint32_t breaks_ = 0;
};

} // namespace tp
