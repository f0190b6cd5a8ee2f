// SPDX-License-Identifier: Apache-2.0
#include "faces/edges/line_snap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tp {
namespace {

constexpr int newton_steps = 3;

/// A point with a value that is not finite says nothing.
Evidence sound(Evidence evidence) {
    for (std::size_t i = 0; i < evidence.points; ++i) {
        const auto row = evidence.values.begin() + static_cast<std::ptrdiff_t>(i * evidence.offsets);
        const auto end = row + static_cast<std::ptrdiff_t>(evidence.offsets);
        if (!std::all_of(row, end, [](double v) { return std::isfinite(v); }))
            std::fill(row, end, 0.0);
    }
    return evidence;
}

/// The best offsets among those listed (Viterbi).
std::vector<std::size_t> best_offsets(const Evidence& evidence, double stray, double bend) {
    const std::size_t count = evidence.offsets;
    std::vector<double> jump(count), price(count), next(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double distance = static_cast<double>(k) * evidence.step;
        jump[k] = bend * distance * distance;
    }
    const auto own_price = [&](std::size_t i, std::size_t k) {
        return stray * evidence.offset(k) * evidence.offset(k) - evidence.at(i, k);
    };
    std::vector<std::size_t> came_from(evidence.points * count);
    for (std::size_t k = 0; k < count; ++k)
        price[k] = own_price(0, k);
    for (std::size_t i = 1; i < evidence.points; ++i) {
        for (std::size_t k = 0; k < count; ++k) {
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t from = 0; from < count; ++from) {
                const double cost = price[from] + jump[from < k ? k - from : from - k];
                if (cost < least) {
                    least = cost;
                    came_from[i * count + k] = from;
                }
            }
            next[k] = least + own_price(i, k);
        }
        price.swap(next);
    }
    std::vector<std::size_t> path(evidence.points);
    path.back() = static_cast<std::size_t>(std::min_element(price.begin(), price.end()) - price.begin());
    for (std::size_t i = evidence.points; i-- > 1;)
        path[i - 1] = came_from[i * count + path[i]];
    return path;
}

/// Slope and (negative) curvature of the evidence at offset `d` of point `i`, from the parabola through the
/// three listed offsets round it.
struct Parabola {
    double slope, curvature;
};
Parabola parabola_at(const Evidence& evidence, std::size_t i, double d) {
    const double index = d / evidence.step + 0.5 * static_cast<double>(evidence.offsets - 1);
    const auto k = static_cast<std::size_t>(
        std::clamp(std::round(index), 1.0, static_cast<double>(evidence.offsets - 2)));
    const double before = evidence.at(i, k - 1), here = evidence.at(i, k), after = evidence.at(i, k + 1);
    const double curvature = (before - 2.0 * here + after) / (evidence.step * evidence.step);
    const double slope = 0.5 * (after - before) / evidence.step + curvature * (d - evidence.offset(k));
    return {slope, std::min(curvature, 0.0)};
}

/// One Newton step of the whole line: a tridiagonal system (Thomas algorithm).
void improve(const Evidence& evidence, double stray, double bend, std::vector<double>& d) {
    const std::size_t count = d.size();
    std::vector<double> diagonal(count), right(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Parabola p = parabola_at(evidence, i, d[i]);
        double pull = p.slope - 2.0 * stray * d[i];
        double stiffness = 2.0 * stray - p.curvature;
        if (i > 0) {
            pull -= 2.0 * bend * (d[i] - d[i - 1]);
            stiffness += 2.0 * bend;
        }
        if (i + 1 < count) {
            pull -= 2.0 * bend * (d[i] - d[i + 1]);
            stiffness += 2.0 * bend;
        }
        diagonal[i] = std::max(stiffness, 1e-12);
        right[i] = pull;
    }
    const double beside = -2.0 * bend;
    for (std::size_t i = 1; i < count; ++i) {
        const double factor = beside / diagonal[i - 1];
        diagonal[i] -= factor * beside;
        right[i] -= factor * right[i - 1];
    }
    double change = 0.0;
    for (std::size_t i = count; i-- > 0;) {
        change = (right[i] - (i + 1 < count ? beside * change : 0.0)) / diagonal[i];
        d[i] += change;
    }
}

} // namespace

std::vector<double> snapped(const Evidence& given, double stray, double bend) {
    if (given.points == 0 || given.offsets < 3)
        return std::vector<double>(given.points, 0.0);
    const Evidence evidence = sound(given);
    std::vector<double> listed;
    for (std::size_t k : best_offsets(evidence, stray, bend))
        listed.push_back(evidence.offset(k));
    std::vector<double> displacement = listed;
    const double most = evidence.offset(evidence.offsets - 1);
    for (int step = 0; step < newton_steps; ++step) {
        improve(evidence, stray, bend, displacement);
        for (std::size_t i = 0; i < listed.size(); ++i) // a parabola says little beyond its three offsets
            displacement[i] = std::clamp(displacement[i], std::max(listed[i] - evidence.step, -most),
                                         std::min(listed[i] + evidence.step, most));
    }
    return displacement;
}

double clarity(const Evidence& given, const std::vector<double>& displacement) {
    if (given.points == 0 || given.offsets == 0)
        return 0.0;
    const Evidence evidence = sound(given);
    double sum = 0.0;
    for (std::size_t i = 0; i < evidence.points; ++i) {
        const double index =
            displacement[i] / evidence.step + 0.5 * static_cast<double>(evidence.offsets - 1);
        const auto k = static_cast<std::size_t>(
            std::clamp(std::round(index), 0.0, static_cast<double>(evidence.offsets - 1)));
        double mean = 0.0;
        for (std::size_t j = 0; j < evidence.offsets; ++j)
            mean += std::exp(evidence.at(i, j) - evidence.at(i, k));
        sum -= std::log(mean / static_cast<double>(evidence.offsets));
    }
    return sum / static_cast<double>(evidence.points);
}

} // namespace tp
