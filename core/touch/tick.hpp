// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// One short push of an actuator against the fingertip, or of a motor in the machine that is held. Whatever it was made of, it
/// lies within these bounds, so that no back end need look.
class Tick {
public:
    static constexpr double longest_s = 0.05; ///< a tick ends by itself, whatever becomes of the program

    /// No tick at all.
    Tick() = default;
    /// `amplitude` 0 … 1, of the strongest the actuator has; `sharpness` 0 (a soft bump) … 1 (a click); `seconds` 0 … longest_s.
    /// What lies outside is clamped; what is not a number is 0.
    Tick(double amplitude, double sharpness, double seconds);

    double amplitude() const { return amplitude_; }
    double sharpness() const { return sharpness_; }
    double seconds() const { return seconds_; }
    /// There is nothing to be felt of it.
    bool empty() const { return !(amplitude_ > 0.0 && seconds_ > 0.0); }
    /// The same with `share` (0 … 1) of its amplitude.
    Tick scaled(double share) const { return {amplitude_ * share, sharpness_, seconds_}; }

    bool operator==(const Tick&) const = default;

private:
    double amplitude_ = 0.0;
    double sharpness_ = 0.0;
    double seconds_ = 0.0;
};

} // namespace tp
