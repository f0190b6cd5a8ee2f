// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/calibration.hpp"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>

namespace tp {

namespace {

using Pairs = std::vector<FramePair>;

constexpr double farthest_mm = 1e5;      ///< no device and no screen is larger
constexpr double always_within_mm = 0.5; ///< of the map: as good as a touchscreen gets
constexpr double narrowest = 0.03;       ///< spread across the longest direction over the one along it
constexpr std::size_t most_triples = 500; ///< with 20 % of bad pairs each of them has one with chance 0.488^500

bool is_place(Vec2 p) { return std::abs(p.x) < farthest_mm && std::abs(p.y) < farthest_mm; }

/// Sums about the means; scaled by the number of points.
struct Moments {
    Vec2 device_mean{0.0};
    Vec2 surface_mean{0.0};
    glm::dmat2 cross{0.0};   ///< s dᵀ
    glm::dmat2 device{0.0};  ///< d dᵀ
    glm::dmat2 surface{0.0}; ///< s sᵀ

    explicit Moments(const Pairs& pairs) {
        const auto count = static_cast<double>(pairs.size());
        for (const FramePair& pair : pairs) {
            device_mean += pair.device / count;
            surface_mean += pair.surface / count;
        }
        for (const FramePair& pair : pairs) {
            const Vec2 d = pair.device - device_mean;
            const Vec2 s = pair.surface - surface_mean;
            cross += glm::outerProduct(s, d) / count;
            device += glm::outerProduct(d, d) / count;
            surface += glm::outerProduct(s, s) / count;
        }
    }
};

/// Standard deviations along and across the longest direction, from a covariance.
struct Spread {
    double along = 0.0;
    double across = 0.0;
    Vec2 normal{0.0}; ///< the direction across

    explicit Spread(const glm::dmat2& covariance) {
        const double mean = 0.5 * (covariance[0][0] + covariance[1][1]);
        const double half = 0.5 * (covariance[0][0] - covariance[1][1]);
        const double radius = std::hypot(half, covariance[0][1]);
        along = std::sqrt(mean + radius);
        across = std::sqrt(std::max(0.0, mean - radius));
        const double angle = 0.5 * std::atan2(covariance[0][1], half);
        normal = {-std::sin(angle), std::cos(angle)};
    }
    bool is_line() const { return !(across > narrowest * along); }
};

/// Whether the device's places lie on one line, were it not for a fifth of them: a map would lean on those alone, and
/// one bad pair could turn it over.
bool on_one_line(const Pairs& pairs) {
    const Moments all(pairs);
    if (Spread(all.device).is_line() || Spread(all.surface).is_line())
        return true;
    const Vec2 normal = Spread(all.device).normal;
    Pairs nearest = pairs;
    std::ranges::sort(nearest, {}, [&](const FramePair& pair) {
        return std::abs(glm::dot(pair.device - all.device_mean, normal));
    });
    nearest.resize(nearest.size() - nearest.size() / 5);
    return Spread(Moments(nearest).device).is_line();
}

/// Least squares; pairs on one line must not come here.
Affine fitted(const Pairs& pairs) {
    const Moments sums(pairs);
    const glm::dmat2 linear = sums.cross * glm::inverse(sums.device);
    return {linear, sums.surface_mean - linear * sums.device_mean};
}

std::optional<Affine> through(const FramePair& a, const FramePair& b, const FramePair& c) {
    const glm::dmat2 device(b.device - a.device, c.device - a.device);
    const double size = length(device[0]) * length(device[1]);
    if (!(std::abs(glm::determinant(device)) > 1e-3 * size))
        return std::nullopt;
    const glm::dmat2 linear = glm::dmat2(b.surface - a.surface, c.surface - a.surface) * glm::inverse(device);
    return Affine{linear, a.surface - linear * a.device};
}

double miss_of(const Affine& map, const FramePair& pair) { return length(map(pair.device) - pair.surface); }

/// Calls `look` with three different indices again and again: all choices, or where there are many some of them, the
/// same ones in each run.
template <typename Look>
void each_triple(std::size_t count, Look look) {
    const double all = static_cast<double>(count) * static_cast<double>(count - 1) * static_cast<double>(count - 2) / 6.0;
    if (all <= static_cast<double>(most_triples)) {
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = i + 1; j < count; ++j)
                for (std::size_t k = j + 1; k < count; ++k)
                    look(i, j, k);
        return;
    }
    std::uint64_t random = 88172645463325252u;
    const auto below = [&random, count] {
        random ^= random << 13u; // xorshift (Marsaglia 2003)
        random ^= random >> 7u;
        random ^= random << 17u;
        return static_cast<std::size_t>((random >> 16u) % count);
    };
    for (std::size_t n = 0; n < most_triples;) {
        const std::size_t i = below();
        const std::size_t j = below();
        const std::size_t k = below();
        if (i == j || j == k || i == k)
            continue;
        look(i, j, k);
        ++n;
    }
}

/// The map through three pairs that the better part of all lies nearest to, and that part's largest miss, mm.
struct Agreed {
    Affine map;
    double median = std::numeric_limits<double>::infinity();
};
Agreed agreed(const Pairs& pairs) {
    Agreed best;
    const std::size_t part = std::min(pairs.size(), (pairs.size() + 4) / 2) - 1; // (n + p + 1) / 2 of them, p = 3
    std::vector<double> misses(pairs.size());
    each_triple(pairs.size(), [&](std::size_t i, std::size_t j, std::size_t k) {
        const std::optional<Affine> map = through(pairs[i], pairs[j], pairs[k]);
        if (!map)
            return;
        std::ranges::transform(pairs, misses.begin(), [&](const FramePair& pair) { return miss_of(*map, pair); });
        std::ranges::nth_element(misses, misses.begin() + static_cast<std::ptrdiff_t>(part));
        if (misses[part] < best.median)
            best = {*map, misses[part]};
    });
    return best;
}

std::string tenths(double mm) {
    const std::string text = std::to_string(std::round(10.0 * mm) / 10.0);
    return text.substr(0, text.find('.') + 2);
}

} // namespace

Result<Calibration> calibrate(const std::vector<FramePair>& pairs, double max_residual_mm) {
    const Error more{"Calibration needs at least three marks that do not lie on one line; touch more marks."};
    if (!std::ranges::all_of(pairs, [](const FramePair& one) { return is_place(one.device) && is_place(one.surface); }))
        return Error{"A calibration sample is not a valid place; touch the marks again."};
    if (pairs.size() < 3)
        return more;
    const Agreed start = agreed(pairs);
    if (!std::isfinite(start.median))
        return more;
    const double deviation = pairs.size() == 3 ? 0.0
                                               : 1.4826 * (1.0 + 5.0 / static_cast<double>(pairs.size() - 3)) * start.median;
    const double within = std::max(2.5 * deviation, always_within_mm);
    Calibration result{start.map, 0.0, 0};
    for (int round = 0; round < 10; ++round) {
        Pairs good;
        std::ranges::copy_if(pairs, std::back_inserter(good), [&](const FramePair& pair) {
            return miss_of(result.device_to_surface, pair) <= within;
        });
        if (good.size() < 3 || on_one_line(good))
            return more;
        const bool settled = good.size() == result.used;
        result.device_to_surface = fitted(good);
        result.used = good.size();
        double squares = 0.0;
        for (const FramePair& pair : good)
            squares += miss_of(result.device_to_surface, pair) * miss_of(result.device_to_surface, pair);
        result.residual_mm = std::sqrt(squares / static_cast<double>(good.size()));
        if (settled)
            break;
    }
    if (!(result.residual_mm <= max_residual_mm))
        return Error{"The calibration misses its marks by " + tenths(result.residual_mm) + " mm, more than the " +
                     tenths(max_residual_mm) + " mm allowed; touch them again."};
    if (5 * result.used < 4 * pairs.size())
        return Error{"Too many touches do not fit together. Touch the marks again with the finger in the device, and with "
                     "no other."};
    return result;
}

} // namespace tp
