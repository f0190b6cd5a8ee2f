// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/aim_tone.hpp"

#include <optional>

namespace tp {

inline constexpr double farthest_pulse = 0.3; ///< strength, 0 … 1, where the face is far off its place
inline constexpr double nearest_pulse = 0.7;  ///< beside it
inline constexpr double well_pulse = 1.0;     ///< all is well

/// What is felt of the tone of aiming, where the machine in the hand has a motor: a pulse with each of its beats, the nearer
/// the faster and the stronger. Where all is well it is one firm pulse and then stillness, because a motor would blur the
/// picture. In the frames' time.
class AimPulses {
public:
    /// The strength of the pulse that is due now; none where none is.
    std::optional<double> due(const AimTone& tone, double now_s);
    /// Nothing was felt yet.
    void forget() { *this = {}; }

private:
    std::optional<double> last_s_;
    bool well_ = false;
};

} // namespace tp
