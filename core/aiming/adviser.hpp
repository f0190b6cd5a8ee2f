// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/advice.hpp"
#include "core/aiming/aim.hpp"
#include "core/aiming/aim_frame.hpp"
#include "core/aiming/held_camera.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace tp {

inline constexpr double begins_at = 1.0;     ///< a fault of that many times its limit is one
inline constexpr double ends_at = 0.75;      ///< one that was there is over below that
inline constexpr double takes_turn = 1.4;    ///< the advice changes to a fault so many times as bad
inline constexpr double level_deg = 7.0;     ///< a tilt beyond it is seen
inline constexpr double darkest_face = 0.22; ///< mean brightness of a face below which little is seen of it
inline constexpr double against_light =
    0.3; ///< so much darker than its surroundings a face is against the light
inline constexpr double sharp_enough = 0.35; ///< of `AimFrame::sharpness`
inline constexpr double still_enough = 0.12; ///< picture widths a second: at 1/30 s of exposure 5 px of 1280
inline constexpr double metres_per_size =
    0.3; ///< how far away an adult's face of size 1 is: 0.2 m high, a field of 62°
inline constexpr double upright_deg =
    8.0; ///< people's heads are about as high as the camera: so far up or down it may look
inline constexpr double sweep_s = 2.5; ///< nobody known of: so long one way, then the other

/// What is wrong with a frame, one kind a place in an array; a number is how many times its limit, 0 nothing.
enum class AimFault : std::size_t { across, height, size, tilt, light, blur, eyes };
inline constexpr std::size_t aim_fault_count = 7;
using AimFaultSizes = std::array<double, aim_fault_count>;

/// From the faces of a frame to the one instruction that helps most. A fault begins above its limit and ends well below
/// it, and the advice stays with one fault until that is over or another is much worse.
class Adviser {
public:
    Adviser(Aim aim, HeldCamera camera) : framer_(aim), camera_(camera) {}
    void aim_at(Aim aim) { framer_.aim_at(aim); }
    /// How many people belong to everybody, where the person says so; 0: whoever is seen.
    void expect(int people) { framer_.expect(people); }
    void hold(HeldCamera camera) { camera_ = camera; }
    /// A tone says where the camera is to go, beside the words.
    void with_tone(bool tone) { tone_ = tone; }
    /// As if nothing had been seen yet.
    void forget();

    /// `faces` those of the frame that count, the largest first.
    AimInstruction advise(const std::vector<TrackedFace>& faces, const AimFrame& frame);

    /// Of the last frame: how the subject lies, nothing where nobody was seen.
    const std::optional<Framing>& framing() const { return framing_; }
    const AimFaultSizes& faults() const { return sizes_; }
    bool there(AimFault fault) const { return there_[static_cast<std::size_t>(fault)]; }
    /// How bad it is with what the advice is about, times its limit; 0 where it is about nothing that was measured.
    double badness() const { return present_ ? sizes_[static_cast<std::size_t>(*present_)] : 0.0; }
    /// Nothing is wrong with the last frame.
    bool good() const;

private:
    AimInstruction search(const AimFrame& frame);
    void measure(const std::vector<TrackedFace>& faces, const AimFrame& frame);
    AimInstruction words_for(AimFault fault) const;
    double urgency(AimFault fault) const;
    Advice way_to(Vec2 picture_way, bool across, Advice first) const;

    Framer framer_;
    HeldCamera camera_;
    std::optional<Framing> framing_;
    AimFaultSizes sizes_{};
    std::array<bool, aim_fault_count> there_{};
    std::optional<AimFault> present_;       ///< what the advice is about
    std::optional<double> searching_since_; ///< s
    std::optional<Vec2> left_by_;           ///< the way by which the last subject was lost, in the picture
    double tilt_deg_ = 0.0;                 ///< clockwise in the picture
    bool too_large_ = false;                ///< the last subject was
    bool tone_ = false;
    bool backlit_ = false;
};

} // namespace tp
