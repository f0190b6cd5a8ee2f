// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/vec.hpp"
#include "device/hid_pid/joystick_scale.hpp"

#include <cstddef>
#include <optional>

namespace tp {

/// The way through measuring a force stick, of which nobody knows how strong it is and which way it pulls: first the
/// grip stands free, is drawn a little to the right and then away from the person, more strongly each time until it
/// moves, and back, to see that it was understood; then a person holds it with a scale.
///
/// It only says what it wants (`assumed`, `pull`); who drives the stick lets it pull through the servo's safety chain. In `right`
/// and `away` it wants by turns nothing, until the grip has been still, and a pull, until the grip has moved.
///
/// |          | went out and came back | a Failure | weighed  | too light to be weighed | nobody weighs |
/// |----------|------------------------|-----------|----------|-------------------------|---------------|
/// | right    | away                   | failed    |          |                         |               |
/// | away     | weigh                  | failed    |          |                         |               |
/// | weigh    |                        |           | measured | weigh, more strongly    | failed        |
/// | measured |                        |           |          |                         |               |
/// | failed   |                        |           |          |                         |               |
class JoystickTrial {
public:
    enum class Step {
        right,    ///< it is learned which way the first axis pulls, and from which strength on the grip moves
        away,     ///< the same of the second
        weigh,    ///< it pulls away from the person, who holds it with a scale
        measured, ///< `assumed` is what the stick is
        failed    ///< `failure` says why
    };
    enum class Failure {
        none,
        not_still,    ///< the grip moved while nothing pulled
        not_moved,    ///< not by the strongest pull either
        other_axis,   ///< it moved across
        changes_mind, ///< back it did not move as it had moved out
        not_weighed   ///< in `weigh_s`
    };

    static constexpr double pull_n = 1.0;   ///< what is asked for, as if the stick were as strong as assumed
    static constexpr double moved_mm = 3.0; ///< a movement
    static constexpr double patience_s = 1.2; ///< for a movement, the chain's ramp included
    static constexpr double still_s = 0.6;    ///< without any pull before each one
    static constexpr double still_mm = 0.5;   ///< how far the grip may drift meanwhile
    static constexpr double restless_s = 8.0; ///< until it counts as not still
    static constexpr double weigh_s =
        180.0; ///< that a pull waits to be weighed; nobody may be there any more
    static constexpr double least_grams =
        80.0; ///< that a kitchen or luggage scale tells to about a twentieth
    static constexpr double standard_gravity = 9.80665; ///< m/s², BIPM, The International System of Units

    Step step() const { return step_; }
    Failure failure() const { return failure_; }
    /// What the stick is to be taken for now; when it is measured, what it is.
    const JoystickScale& assumed() const { return assumed_; }
    /// Unit vector of the pull that is wanted now, device frame; 0: none.
    Vec2 pull() const { return pull_; }

    /// The grip is at `place` (mm, device frame) at `now` s; asked again and again. True where what is wanted has changed.
    bool sample(Vec2 place, double now);
    /// The scale shows `grams` while `asked_n` newtons are asked for. True where that measured the stick, false where it
    /// is to be weighed again with a stronger pull; an error where that cannot be.
    Result<bool> weighed(double grams, double asked_n);

private:
    void rest();
    bool fail(Failure why);
    bool moved(Vec2 by);
    bool pull_more_strongly();
    Vec2 axis() const { return step_ == Step::right ? Vec2(1.0, 0.0) : Vec2(0.0, 1.0); }

    Step step_ = Step::right;
    Failure failure_ = Failure::none;
    JoystickScale assumed_;
    std::size_t strength_ = 0;
    Vec2 pull_{0.0};
    bool back_ = false;                   ///< it is seen whether the way back is as understood
    Vec2 from_{0.0};                      ///< where the grip rests, or rested when the pull began
    std::optional<double> since_;         ///< s, of the stillness, the pull or the weighing
    std::optional<double> resting_since_; ///< s, of the rest, still or not
};

} // namespace tp
