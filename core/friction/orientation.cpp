// SPDX-License-Identifier: Apache-2.0
#include "core/friction/orientation.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace tp {

namespace {

/// Shewchuk's bound on the rounding of the determinant, as a share of the sum of its two products: (3 + 16ε)ε, ε = 2⁻⁵³.
constexpr double rounding_share = 3.3306690738754716e-16;

/// A number as the sum of two doubles that do not overlap.
struct Exactly {
    double high, low;
};

Exactly difference(double a, double b) {
    const double high = a - b;
    const double b_as_seen = a - high;
    const double a_as_seen = high + b_as_seen;
    return {high, (a - a_as_seen) + (b_as_seen - b)};
}

/// The first and the last half of its digits (Dekker 1971).
Exactly halves(double value) {
    constexpr double beyond_half = 134217729.0; // 2²⁷ + 1
    const double spread = beyond_half * value;
    const double high = spread - (spread - value);
    return {high, value - high};
}

/// Dekker's product; without std::fma, which MinGW's library rounds twice.
Exactly product(double a, double b) {
    const double high = a * b;
    const Exactly one = halves(a), other = halves(b);
    const double crossed = (one.high * other.high - high) + one.high * other.low + one.low * other.high;
    return {high, crossed + one.low * other.low};
}

/// A sum of doubles without rounding, smallest first (Shewchuk's GROW-EXPANSION).
class ExactSum {
public:
    void add(double value) {
        for (std::size_t i = 0; i < count_; ++i) {
            const double high = value + parts_[i];
            const double value_as_seen = high - parts_[i];
            const double part_as_seen = high - value_as_seen;
            parts_[i] = (parts_[i] - part_as_seen) + (value - value_as_seen);
            value = high;
        }
        parts_[count_++] = value;
    }
    /// Adds `sign` · a · b.
    void add_product(double sign, Exactly a, Exactly b) {
        for (const double x : {a.low, a.high})
            for (const double y : {b.low, b.high}) {
                const Exactly both = product(sign * x, y);
                add(both.low);
                add(both.high);
            }
    }
    /// Of the largest part that is not zero.
    int sign() const {
        for (std::size_t i = count_; i-- > 0;)
            if (parts_[i] != 0.0)
                return parts_[i] > 0.0 ? 1 : -1;
        return 0;
    }

private:
    std::array<double, 16> parts_{};
    std::size_t count_ = 0;
};

[[gnu::noinline]] int exact_orientation(Vec2 a, Vec2 b, Vec2 p) {
    ExactSum sum;
    sum.add_product(1.0, difference(a.x, p.x), difference(b.y, p.y));
    sum.add_product(-1.0, difference(a.y, p.y), difference(b.x, p.x));
    return sum.sign();
}

} // namespace

int orientation(Vec2 a, Vec2 b, Vec2 p) noexcept {
    const double left = (a.x - p.x) * (b.y - p.y);
    const double right = (a.y - p.y) * (b.x - p.x);
    const double determinant = left - right;
    const double doubt = rounding_share * (std::abs(left) + std::abs(right));
    if (determinant > doubt)
        return 1;
    if (determinant < -doubt)
        return -1;
    return exact_orientation(a, b, p);
}

} // namespace tp
