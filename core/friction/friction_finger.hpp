// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/friction/friction_law.hpp"
#include "core/guidance/guidance_law.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace tp {

/// What happened between a finger and a line.
enum class LineEventKind {
    crossed,  ///< the finger's way went across it
    followed, ///< the finger has gone along it for a while
    left,     ///< a line that was followed is no longer under the finger
    corner    ///< a sharp turn of a line is under the finger
};

struct LineEvent {
    LineEventKind kind;
    int contour{};           ///< index into the FlatScene
    std::uint32_t segment{}; ///< of that contour's line; of a crossing the one that is crossed
    Vec2 place{};            ///< mm; of a crossing and a corner on the line, else the finger's
    double speed{};          ///< of the finger, mm/s
    double angle{};          ///< between the finger's way and the line, rad, 0 … π/2; of a crossing only
    bool to_left{};          ///< of the line as it was drawn; of a crossing only
    double share{}; ///< FrictionLaw::share_at of this speed: nothing of it is felt where the finger rests
};

/// What a bare finger should feel now.
struct Friction {
    double level = 0.0; ///< 0 … 1; 0 where the finger rests
    std::span<const LineEvent>
        events;               ///< crossings in their order, then the others; valid until the next step
    std::size_t left_out = 0; ///< crossings for which there was no room, see StepCrossings
};

/// One finger before the resistive law: remembers where it was, and so knows what it crossed, follows and left. One thread;
/// allocates nothing, locks nothing, throws nothing.
class FrictionFinger {
public:
    static constexpr double along_mm = 1.0;     ///< so near to a line a finger may be following it
    static constexpr double away_mm = 2.0;      ///< farther away a line that was followed is left
    static constexpr double along_way_mm = 4.0; ///< so far a finger goes near a line before it follows it
    static constexpr double along_share = 0.9;  ///< of that way at least so much is along the line

    /// `law` must outlive it.
    explicit FrictionFinger(const FrictionLaw& law) : law_(&law) {}

    /// The finger is at `place` (mm) and moves at `velocity` (mm/s); `exact` is what ExactLaw answered for this place, over
    /// the same scene. A place that is not finite is that of a lifted finger.
    Friction step(Vec2 place, Vec2 velocity, const Guidance& exact) noexcept;
    /// The finger is off the surface: what it passes until it is set down again is not crossed.
    void lift() noexcept;

    bool following() const { return following_; }

private:
    /// Of the finger, and of the line nearest to it; see Guidance.
    struct Sample {
        Vec2 place{};
        double distance{};
        Vec2 nearest{};
        int contour{};
        std::uint32_t segment{};
    };
    /// How far a finger went near the same line, mm.
    struct WayNear {
        double all{};
        double lately{}; ///< the same, older way forgotten
        double along{};  ///< … as far as it was along the line
    };
    struct Movement {
        Vec2 place{};
        double way;   ///< mm since the sample before
        double speed; ///< mm/s
        double share; ///< FrictionLaw::share_at of it
    };
    bool may_cross(Vec2 place, double distance) const noexcept;
    void cross_lines(const Movement& now) noexcept;
    void follow(const Movement& now, const Guidance& exact) noexcept;
    void look_for_corner(const Movement& now, const Guidance& exact) noexcept;
    bool told_already(const LineCrossing& crossing, double share) noexcept;
    void forget_left(Vec2 place) noexcept;
    void tell(const LineEvent& event) noexcept { events_[told_++] = event; }

    const FrictionLaw* law_;
    bool down_ = false;
    Sample before_{};
    bool in_texture_ = false;

    WayNear near_{};
    bool following_ = false;
    bool at_corner_ = false;
    Vec2 corner_{}; ///< mm, the one told last

    struct Crossed {
        int contour{};
        Vec2 place{};
    };
    std::array<Crossed, 4> lately_{}; ///< crossings told of, from which the finger has not been far yet
    std::size_t lately_count_ = 0;

    StepCrossings crossings_;
    std::array<LineEvent, StepCrossings::room + 2> events_{};
    std::size_t told_ = 0;
};

} // namespace tp
