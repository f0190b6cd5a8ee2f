// SPDX-License-Identifier: Apache-2.0
#include "core/touch/tick.hpp"

namespace tp {

namespace {

/// 0 for what is not a number.
double clamped(double value, double most) { return value > 0.0 ? (value < most ? value : most) : 0.0; }

} // namespace

Tick::Tick(double amplitude, double sharpness, double seconds)
    : amplitude_(clamped(amplitude, 1.0)), sharpness_(clamped(sharpness, 1.0)),
      seconds_(clamped(seconds, longest_s)) {}

} // namespace tp
