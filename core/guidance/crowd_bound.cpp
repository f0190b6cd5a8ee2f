// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/crowd_bound.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace tp {

namespace {

constexpr std::uint32_t samples = 32;       ///< segments that a hub is tried on
constexpr std::uint32_t most_fitted = 1024; ///< segments that it is fitted to
/// A hub serves well where what it sees differs by less than this share of the distance or length.
constexpr double even_share = 0.03;

/// Solves a x = b for a symmetric positive matrix of two rows; none where it is close to singular.
std::optional<Vec2> solved(double xx, double xy, double yy, Vec2 b) {
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-12 * xx * yy))
        return std::nullopt;
    return Vec2(yy * b.x - xy * b.y, xx * b.y - xy * b.x) / determinant;
}

std::uint32_t sample(std::uint32_t first, std::uint32_t end, std::uint32_t k, std::uint32_t of = samples) {
    return first + static_cast<std::uint32_t>(std::uint64_t(end - first) * k / of);
}

Vec2 middle_of(const IndexedSegment& s) { return 0.5 * s.a + 0.5 * s.b; }

/// The centre of the circle through the middles (Kåsa's fit).
std::optional<Vec2> centre_of(const SegmentSet& set, std::uint32_t first, std::uint32_t end) {
    const std::uint32_t count = std::min(end - first, most_fitted);
    const auto middle = [&](std::uint32_t k) {
        return middle_of(set.segments[sample(first, end, k, count)]);
    };
    Vec2 mean(0.0);
    for (std::uint32_t k = 0; k < count; ++k)
        mean += middle(k);
    mean /= double(count);
    double xx = 0.0, xy = 0.0, yy = 0.0;
    Vec2 right(0.0);
    for (std::uint32_t k = 0; k < count; ++k) {
        const Vec2 d = middle(k) - mean;
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
        right += 0.5 * glm::dot(d, d) * d;
    }
    const Vec2 along = set.segments[first].b - set.segments[first].a;
    if (!(xx + yy > 1e-12 * glm::dot(along, along)))
        return std::nullopt; // all in one place
    const auto centre = solved(xx, xy, yy, right);
    if (!centre || !(glm::dot(*centre, *centre) < 1e12 * (xx + yy) / double(count)))
        return std::nullopt;
    return mean + *centre;
}

Vec2 unit_normal(const IndexedSegment& s) {
    const Vec2 along = s.b - s.a;
    const double length = std::sqrt(glm::dot(along, along));
    return length > 0.0 ? Vec2(-along.y, along.x) / length : Vec2(0.0);
}

/// The place nearest to all lines.
Vec2 crossing_of(const SegmentSet& set, std::uint32_t first, std::uint32_t end) {
    const Vec2 base = middle_of(set.segments[first]);
    double xx = 0.0, xy = 0.0, yy = 0.0;
    Vec2 right(0.0), middles(0.0);
    for (std::uint32_t k = 0; k < samples; ++k) {
        const IndexedSegment& s = set.segments[sample(first, end, k)];
        const Vec2 n = unit_normal(s);
        const Vec2 middle = middle_of(s) - base;
        xx += n.x * n.x;
        xy += n.x * n.y;
        yy += n.y * n.y;
        right += glm::dot(n, middle) * n;
        middles += middle / double(samples);
    }
    if (const auto crossing = solved(xx, xy, yy, right))
        return base + *crossing;
    return base + middles;
}

/// Gathers vectors into the cone that holds them: first their sum, then how far they are from it.
class ConeOf {
public:
    void add(Vec2 unit) { sum_ += unit; }
    void close() {
        const double length = std::sqrt(glm::dot(sum_, sum_));
        narrow_ = length > 0.0;
        if (narrow_)
            cone_.middle = sum_ / length;
    }
    void widen(Vec2 unit) {
        narrow_ = narrow_ && glm::dot(unit, cone_.middle) > 0.0;
        sine_ = std::max(sine_, std::abs(cross(cone_.middle, unit)));
    }
    void widen(const CrowdBound::Cone& other) {
        const double across = std::abs(cross(cone_.middle, other.middle));
        const double along = glm::dot(cone_.middle, other.middle);
        // The sum of both angles stays below a right one.
        narrow_ = narrow_ && other.cosine > 0.0 && along * other.cosine > across * other.sine;
        sine_ = std::max(sine_, across * other.cosine + along * other.sine);
    }
    CrowdBound::Cone cone() const {
        CrowdBound::Cone cone = cone_;
        if (narrow_) {
            cone.sine = std::min(1.0, sine_ * (1.0 + 1e-12) + 1e-15);
            cone.cosine = std::sqrt(1.0 - cone.sine * cone.sine);
        }
        return cone;
    }

private:
    Vec2 sum_{0.0};
    CrowdBound::Cone cone_;
    double sine_ = 0.0;
    bool narrow_ = false;
};

/// Where a segment is from a hub.
struct Seen {
    double distance;
    Vec2 unit; ///< towards it; zero where the hub lies on it
};
Seen seen(const IndexedSegment& s, Vec2 hub) {
    const Foot<double> foot(s, hub);
    const Vec2 towards = foot.parameter < 1.0 ? (s.a - hub) + foot.parameter * (s.b - s.a) : s.b - hub;
    const double distance = std::sqrt(glm::dot(towards, towards));
    return {distance, distance > 0.0 ? towards / distance : Vec2(0.0)};
}

void see_from_afar(CrowdBound& bound, const SegmentSet& set, std::uint32_t first, std::uint32_t end) {
    ConeOf cone;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = first; i < end; ++i) {
        const Seen it = seen(set.segments[i], bound.away_hub);
        cone.add(it.unit);
        least = std::min(least, it.distance);
    }
    cone.close();
    for (std::uint32_t i = first; i < end; ++i)
        cone.widen(seen(set.segments[i], bound.away_hub).unit);
    bound.away_cone = cone.cone();
    bound.away_least = least;
}

void see_through(CrowdBound& bound, const SegmentSet& set, std::uint32_t first, std::uint32_t end) {
    const Vec2 axis = unit_normal(set.segments[first + (end - first) / 2]);
    const auto turned = [&](Vec2 n) { return glm::dot(n, axis) < 0.0 ? -n : n; };
    ConeOf cone;
    double most = 0.0;
    for (std::uint32_t i = first; i < end; ++i) {
        const Vec2 n = unit_normal(set.segments[i]);
        cone.add(turned(n));
        most = std::max(most, std::abs(glm::dot(n, middle_of(set.segments[i]) - bound.through_hub)));
    }
    cone.close();
    for (std::uint32_t i = first; i < end; ++i)
        cone.widen(turned(unit_normal(set.segments[i])));
    bound.through_cone = cone.cone();
    bound.through_most = most;
}

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = 0.0;
    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// Whether the samples are about equally far from the hub.
bool evenly_away(const SegmentSet& set, std::uint32_t first, std::uint32_t end, Vec2 hub) {
    Range distances;
    for (std::uint32_t k = 0; k < samples; ++k)
        distances.add(seen(set.segments[sample(first, end, k)], hub).distance);
    return distances.high - distances.low < even_share * distances.low;
}

/// Whether the samples' lines pass the hub, seen from a segment's length.
bool all_through(const SegmentSet& set, std::uint32_t first, std::uint32_t end, Vec2 hub) {
    for (std::uint32_t k = 0; k < samples; ++k) {
        const IndexedSegment& s = set.segments[sample(first, end, k)];
        const Vec2 along = s.b - s.a;
        if (!(std::abs(cross(along, hub - s.a)) < even_share * glm::dot(along, along)))
            return false;
    }
    return true;
}

} // namespace

double CrowdBound::Cone::most(Vec2 d) const noexcept {
    const double along = glm::dot(middle, d);
    const double across = std::abs(cross(middle, d));
    if (along * sine >= across * cosine && (along > 0.0 || cosine < 0.0))
        return std::sqrt(along * along + across * across);
    return along * cosine + across * sine;
}

double CrowdBound::at_least(Vec2 p) const noexcept {
    double bound = -std::numeric_limits<double>::infinity();
    if (sees_through) {
        const Vec2 d = p - through_hub;
        bound = std::abs(glm::dot(through_cone.middle, d)) * through_cone.cosine -
                std::abs(cross(through_cone.middle, d)) * through_cone.sine - through_most;
    }
    if (sees_away && away_least > bound)
        bound = std::max(bound, away_least - away_cone.most(p - away_hub));
    return bound;
}

CrowdBound with_hubs(const SegmentSet& set, std::uint32_t first, std::uint32_t end, const CrowdBound* parent,
                     bool worth_all) {
    CrowdBound bound;
    bound.sees_away =
        parent != nullptr && parent->sees_away && evenly_away(set, first, end, parent->away_hub);
    bound.sees_through =
        parent != nullptr && parent->sees_through && all_through(set, first, end, parent->through_hub);
    if (bound.sees_away)
        bound.away_hub = parent->away_hub;
    if (bound.sees_through)
        bound.through_hub = parent->through_hub;
    if (bound.sees_away || bound.sees_through)
        return bound;
    if (const auto centre = centre_of(set, first, end);
        centre && (worth_all || evenly_away(set, first, end, *centre))) {
        bound.sees_away = true;
        bound.away_hub = *centre;
    }
    if (const Vec2 crossing = crossing_of(set, first, end);
        worth_all || all_through(set, first, end, crossing)) {
        bound.sees_through = true;
        bound.through_hub = crossing;
    }
    return bound;
}

void measure(CrowdBound& bound, const SegmentSet& set, std::uint32_t first, std::uint32_t end) {
    if (bound.sees_away)
        see_from_afar(bound, set, first, end);
    if (bound.sees_through)
        see_through(bound, set, first, end);
}

bool gather(CrowdBound& bound, std::span<const CrowdBound> parts) {
    for (const CrowdBound& part : parts)
        if ((bound.sees_away && !(part.sees_away && part.away_hub == bound.away_hub)) ||
            (bound.sees_through && !(part.sees_through && part.through_hub == bound.through_hub)))
            return false;
    if (bound.sees_away) {
        bound.away_least = std::numeric_limits<double>::infinity();
        ConeOf cone;
        for (const CrowdBound& part : parts) {
            bound.away_least = std::min(bound.away_least, part.away_least);
            cone.add(part.away_cone.middle);
        }
        cone.close();
        for (const CrowdBound& part : parts)
            cone.widen(part.away_cone);
        bound.away_cone = cone.cone();
    }
    if (bound.sees_through) {
        bound.through_most = 0.0;
        const Vec2 axis = parts[parts.size() / 2].through_cone.middle;
        const auto turned = [&](CrowdBound::Cone cone) {
            cone.middle = glm::dot(cone.middle, axis) < 0.0 ? -cone.middle : cone.middle;
            return cone;
        };
        ConeOf cone;
        for (const CrowdBound& part : parts) {
            bound.through_most = std::max(bound.through_most, part.through_most);
            cone.add(turned(part.through_cone).middle);
        }
        cone.close();
        for (const CrowdBound& part : parts)
            cone.widen(turned(part.through_cone));
        bound.through_cone = cone.cone();
    }
    return true;
}

} // namespace tp
