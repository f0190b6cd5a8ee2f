// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdint.h>

/// The little mathematics that the kinematics need, for float and double alike: the microcontroller has
/// neither a floating-point unit nor need of a mathematics library.
namespace tp::pad {

template <typename Real>
struct Vec {
    Real x = 0;
    Real y = 0;
};

template <typename Real>
Vec<Real> operator+(Vec<Real> a, Vec<Real> b) {
    return {a.x + b.x, a.y + b.y};
}
template <typename Real>
Vec<Real> operator-(Vec<Real> a, Vec<Real> b) {
    return {a.x - b.x, a.y - b.y};
}
template <typename Real>
Vec<Real> operator*(Real s, Vec<Real> a) {
    return {s * a.x, s * a.y};
}
template <typename Real>
Real dot(Vec<Real> a, Vec<Real> b) {
    return a.x * b.x + a.y * b.y;
}
template <typename Real>
Real cross(Vec<Real> a, Vec<Real> b) {
    return a.x * b.y - a.y * b.x;
}

template <typename Real>
Real absolute(Real v) {
    return v < 0 ? -v : v;
}
template <typename Real>
Real smaller(Real a, Real b) {
    return b < a ? b : a;
}
template <typename Real>
Real larger(Real a, Real b) {
    return a < b ? b : a;
}
template <typename Real>
Real clamped(Real v, Real low, Real high) {
    return v < low ? low : (high < v ? high : v);
}

/// The bits of the first guess: half the exponent.
inline float guessed_root(float v) {
    return __builtin_bit_cast(float, (__builtin_bit_cast(uint32_t, v) >> 1) + 0x1FBD1DF5u);
}
inline double guessed_root(double v) {
    return __builtin_bit_cast(double, (__builtin_bit_cast(uint64_t, v) >> 1) + 0x1FF7A3BEA91D9B1Bu);
}

/// √v for a normal number, by Newton's method from a guess within 4 %: to two units in the last place. 0 for
/// what is not positive.
template <typename Real>
Real square_root(Real v) {
    if (!(v > 0))
        return 0;
    Real root = guessed_root(v);
    for (int i = 0; i < (sizeof(Real) == sizeof(float) ? 3 : 4); ++i)
        root = Real(0.5) * (root + v / root);
    return root;
}

template <typename Real>
Real length(Vec<Real> v) {
    return square_root(dot(v, v));
}

template <typename Real>
struct SineCosine {
    Real sine = 0;
    Real cosine = 1;
};

/// Of an angle in rad, |angle| < 1000: reduced by quarter turns to ±π/4, then the power series. Not a number of any
/// other angle.
template <typename Real>
SineCosine<Real> sine_cosine(Real angle) {
    if (!(angle > Real(-1000) && angle < Real(1000))) {
        const Real nothing = angle - angle; // 0, or not a number
        return {nothing / nothing, nothing / nothing};
    }
    constexpr double quarter = 1.57079632679489661923;
    constexpr Real high = Real(quarter);
    constexpr Real low = Real(quarter - double(high)); // what the first part lacks
    const Real turns = angle * Real(1.0 / quarter);
    const int count = int(turns + (turns < 0 ? Real(-0.5) : Real(0.5)));
    const Real r = (angle - Real(count) * high) - Real(count) * low;
    const Real square = r * r;
    constexpr int terms = sizeof(Real) == sizeof(float) ? 5 : 9;
    Real sine = 1;
    Real cosine = 1;
    for (int k = terms; k >= 1; --k) {
        sine = Real(1) - square / Real(2 * k * (2 * k + 1)) * sine;
        cosine = Real(1) - square / Real((2 * k - 1) * 2 * k) * cosine;
    }
    sine *= r;
    switch (count & 3) {
    case 0:
        return {sine, cosine};
    case 1:
        return {cosine, -sine};
    case 2:
        return {-sine, -cosine};
    default:
        return {-cosine, sine};
    }
}

} // namespace tp::pad
