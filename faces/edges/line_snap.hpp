// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace tp {

/// For each point along a line, how likely the sought line passes at each offset across it: natural
/// logarithms, up to a constant per point. Offsets are equally spaced and centred on the point.
struct Evidence {
    std::size_t points = 0;
    std::size_t offsets = 0;    ///< odd; the middle one is offset 0
    double step = 1.0;          ///< between offsets, in the caller's unit; > 0
    std::vector<double> values; ///< points × offsets

    double at(std::size_t point, std::size_t offset) const { return values[point * offsets + offset]; }
    double offset(std::size_t index) const {
        return (static_cast<double>(index) - 0.5 * static_cast<double>(offsets - 1)) * step;
    }
};

/// The displacement d of a line, one value per point in the unit of `evidence`, that maximises
///   Σ evidence(i, d_i) − stray Σ d_i² − bend Σ (d_{i+1} − d_i)²
/// (a snake by dynamic programming: Amini, Weymouth, Jain 1990, made continuous by a Newton step on the
/// parabolas through the best offsets). Without evidence it is 0 everywhere; values that are not finite count
/// as no evidence at that point. Time: points × offsets².
std::vector<double> snapped(const Evidence& evidence, double stray, double bend);

/// How clearly the evidence speaks for the displacement: the mean over the points of its logarithm there less
/// that of its mean over all offsets. 0 where there is none.
double clarity(const Evidence& evidence, const std::vector<double>& displacement);

} // namespace tp
