// SPDX-License-Identifier: Apache-2.0
#include "core/statistics/studentized_range.hpp"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>

namespace tp {
namespace {

double normal_density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi); }
double normal_below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// That the range of `means` standard normal numbers is above `w`: the largest lies at z, not all the others within `w` below it.
/// Written as what is left out, so that no two nearly equal numbers are subtracted.
double range_above(double w, int means) {
    constexpr double reach = 12.0, step = 0.1; // beyond it the density is below 1e-31
    const double others = means - 1;
    double sum = 0.0;
    for (double z = -reach; z <= reach; z += step) {
        const double below = normal_below(z);
        const double share = normal_below(z - w) / below; // of those below z, farther away than w
        const double one_is = share >= 1.0 ? 1.0 : -std::expm1(others * std::log1p(-share));
        sum += normal_density(z) * std::pow(below, others) * one_is;
    }
    return means * step * sum;
}

/// What Stirling's formula leaves of ln Γ(x), for x > 0.
double stirling_rest(double x) {
    if (x < 10.0)
        return boost::math::lgamma(x) -
               ((x - 0.5) * std::log(x) - x + 0.5 * std::log(2.0 * std::numbers::pi));
    const double square = x * x;
    return (1.0 / 12.0 - (1.0 / 360.0 - 1.0 / (1260.0 * square)) / square) / x;
}

} // namespace

double studentized_range_above(double q, int means, double df) {
    if (q <= 0.0)
        return 1.0;
    // Over t = ln s, where s is the estimated standard error by the true one: a chi variable by √df. Its density there is
    // exp(peak - x (e^2t - 1 - 2t)), in which nothing large is subtracted for many degrees of freedom.
    const double x = 0.5 * df;
    const double peak = std::log(2.0) + 0.5 * std::log(x / (2.0 * std::numbers::pi)) - stirling_rest(x);
    const double spread = 1.0 / std::sqrt(2.0 * df); // of ln s, for large df
    const double step = std::min(0.1, 0.2 * spread);
    // Below `least` s has no share that counts; above `most` its density, under the normal one there, is below 1e-30 of it.
    const double least = -40.0 * std::max(1.0 / df, spread), most = 12.0 * spread;
    double sum = 0.0;
    for (double t = least; t <= most; t += step) {
        const double density = std::exp(peak - x * (std::expm1(2.0 * t) - 2.0 * t));
        sum += density * range_above(q * std::exp(t), means);
    }
    return std::min(1.0, step * sum);
}

} // namespace tp
