// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/force_pad/firmware/pad_firmware.hpp"

#include <cmath>
#include <random>

namespace tp::pad {

/// The cables of a cable pad, in float or double.
template <typename Real>
CableFrame<Real> frame_of() {
    const CableFrame<float> made = cable_pad().cables;
    CableFrame<Real> frame;
    for (int i = 0; i < cable_count; ++i)
        frame.exits[i] = {Real(made.exits[i].x), Real(made.exits[i].y)};
    frame.least_tension = Real(0.3);
    frame.greatest_tension = Real(4.0);
    frame.rest_tension = Real(0.6);
    return frame;
}

struct Lengths {
    double mm[cable_count];
};

inline Lengths lengths_at(const CableFrame<double>& frame, Vec<double> place) {
    Lengths lengths;
    for (int i = 0; i < cable_count; ++i)
        lengths.mm[i] = std::hypot(frame.exits[i].x - place.x, frame.exits[i].y - place.y);
    return lengths;
}

inline double apart(Vec<double> a, Vec<double> b) { return std::hypot(a.x - b.x, a.y - b.y); }

inline Vec<double> random_place(std::mt19937& random, double half_x, double half_y) {
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    const double x = half_x * share(random);
    return {x, half_y * share(random)};
}

/// Three cables along the x axis from a knob in the middle, and a fourth off it by `tilt`, rad.
inline CableFrame<double> nearly_in_one_line(double tilt) {
    CableFrame<double> frame = frame_of<double>();
    const Vec<double> exits[cable_count] = {
        {-100, 0}, {100, 0}, {-120, 0}, {110 * std::cos(tilt), 110 * std::sin(tilt)}};
    for (int i = 0; i < cable_count; ++i)
        frame.exits[i] = exits[i];
    return frame;
}

} // namespace tp::pad
