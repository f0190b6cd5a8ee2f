// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

namespace tp {

/// Straight piece between two finite points, `a` before `b` in (x, y) so that its direction does not matter.
struct IndexedSegment {
    Vec2 a{0.0}, b{0.0};     ///< mm
    double per_square = 0.0; ///< 1 / length², mm⁻²; 0 for a segment too short to tell from a point

    IndexedSegment() = default;
    IndexedSegment(Vec2 one_end, Vec2 other_end) : a(one_end), b(other_end) {
        if (std::tie(b.x, b.y) < std::tie(a.x, a.y))
            std::swap(a, b);
        const double square = glm::dot(b - a, b - a);
        if (square > 1e-280)
            per_square = 1.0 / square;
    }
    bool is_longer_than(double mm) const { return per_square > 0.0 && per_square * mm * mm < 1.0; }
};

/// The segments of an index in the order in which they lie in memory, and whose they are. Behind the last one
/// stands a filler that is never nearest, for lists that need an even number.
struct SegmentSet {
    std::vector<IndexedSegment> segments;
    std::vector<int> owners;            ///< one a segment: place of its contour in the order that breaks ties
    std::vector<std::uint32_t> numbers; ///< one a segment: its number in its contour's line
    double longest = 0.0;               ///< mm, an upper bound
    /// Squares that differ by less than this factor and this much in mm² may be in the wrong order (see
    /// closest_of): 10 ulp of a distance plus the longest segment, twice over.
    static constexpr double indistinct = 1.0 + 1e-11;
    double indistinct_square = 0.0;
    /// Of segments up to here double tells which is nearer to 1e-10 mm.
    static constexpr double double_tells_mm = 1e5;

    /// Segments without the filler.
    std::size_t size() const { return owners.size(); }
    std::uint32_t filler() const { return static_cast<std::uint32_t>(size()); }
    void add_filler() {
        segments.emplace_back(Vec2(1e145), Vec2(1e145));
        indistinct_square = 4e-18 * longest * longest;
    }
    std::size_t bytes() const {
        return segments.capacity() * sizeof(IndexedSegment) + owners.capacity() * sizeof(int) +
               numbers.capacity() * sizeof(std::uint32_t);
    }
};

/// Two doubles side by side, as every 64-bit processor computes them.
using TwoReals = double __attribute__((vector_size(16)));
using TwoMarks = std::int64_t __attribute__((vector_size(16)));

/// Where a segment passes nearest to a point, by clamped projection. In `Real` = double the distance is true
/// to a few ulp of the segment's length plus the distance, wherever in the plane the two lie: everything is
/// computed relative to the point.
template <typename Real>
struct Foot {
    Real squared;   ///< squared distance, mm²
    Real parameter; ///< 0 at a … 1 at b

    Foot(const IndexedSegment& segment, Vec2 p) {
        const Real along_x = Real(segment.b.x) - Real(segment.a.x);
        const Real along_y = Real(segment.b.y) - Real(segment.a.y);
        const Real x = Real(p.x) - Real(segment.a.x);
        const Real y = Real(p.y) - Real(segment.a.y);
        // A segment of length zero gives 0/0, which fails both comparisons and so becomes `a`.
        const Real raw = (x * along_x + y * along_y) / (along_x * along_x + along_y * along_y);
        const Real clamped = raw > Real(0) ? raw : Real(0);
        parameter = clamped < Real(1) ? clamped : Real(1);
        const bool at_b = !(clamped < Real(1));
        const Real away_x = at_b ? Real(p.x) - Real(segment.b.x) : x - parameter * along_x;
        const Real away_y = at_b ? Real(p.y) - Real(segment.b.y) : y - parameter * along_y;
        squared = away_x * away_x + away_y * away_y;
    }
};

/// Squared distances of two segments from one point, or of one segment from two, mm². May differ from Foot's
/// by the rounding of an end point, see `indistinct`.
struct TwoSquares {
    TwoReals squared;
    TwoReals parameter;

    TwoSquares(TwoReals ax, TwoReals ay, TwoReals bx, TwoReals by, TwoReals per_square, TwoReals px,
               TwoReals py) {
        const TwoReals zero{0.0, 0.0};
        const TwoReals one{1.0, 1.0};
        const TwoReals along_x = bx - ax;
        const TwoReals along_y = by - ay;
        const TwoReals x = px - ax;
        const TwoReals y = py - ay;
        const TwoReals raw = (x * along_x + y * along_y) * per_square;
        const TwoReals clamped = raw < one ? raw : one;
        parameter = clamped > zero ? clamped : zero;
        const TwoReals away_x = x - parameter * along_x;
        const TwoReals away_y = y - parameter * along_y;
        squared = away_x * away_x + away_y * away_y;
    }
    TwoSquares(const IndexedSegment& s, const IndexedSegment& t, Vec2 p)
        : TwoSquares(TwoReals{s.a.x, t.a.x}, TwoReals{s.a.y, t.a.y}, TwoReals{s.b.x, t.b.x},
                     TwoReals{s.b.y, t.b.y}, TwoReals{s.per_square, t.per_square}, TwoReals{p.x, p.x},
                     TwoReals{p.y, p.y}) {}
    TwoSquares(const IndexedSegment& s, Vec2 p, Vec2 q)
        : TwoSquares(TwoReals{s.a.x, s.a.x}, TwoReals{s.a.y, s.a.y}, TwoReals{s.b.x, s.b.x},
                     TwoReals{s.b.y, s.b.y}, TwoReals{s.per_square, s.per_square}, TwoReals{p.x, q.x},
                     TwoReals{p.y, q.y}) {}
};

/// The same, x and y side by side, without a branch that depends on the place.
template <>
inline Foot<double>::Foot(const IndexedSegment& segment, Vec2 p) {
    const TwoReals at_a{segment.a.x, segment.a.y};
    const TwoReals at_b{segment.b.x, segment.b.y};
    const TwoReals at_p{p.x, p.y};
    const TwoReals along = at_b - at_a;
    const TwoReals product = (at_p - at_a) * along;
    parameter = std::max(0.0, std::min(1.0, (product[0] + product[1]) * segment.per_square));
    const TwoReals step{parameter, parameter};
    const TwoReals away = step < TwoReals{1.0, 1.0} ? at_p - at_a - step * along : at_p - at_b;
    const TwoReals squares = away * away;
    squared = squares[0] + squares[1];
}

/// The way from a point to the place of a segment at a foot's parameter. Its vector and length are those of
/// Foot, so that what is divided by the length is of length one.
template <typename Real>
struct WayToSegment {
    Real x, y; ///< mm

    WayToSegment(const IndexedSegment& segment, Real parameter, Vec2 p) {
        const bool at_b = !(parameter < Real(1));
        const Vec2 from = at_b ? segment.b : segment.a;
        x = Real(from.x) - Real(p.x);
        y = Real(from.y) - Real(p.y);
        if (!at_b) {
            x += parameter * (Real(segment.b.x) - Real(segment.a.x));
            y += parameter * (Real(segment.b.y) - Real(segment.a.y));
        }
    }
    Vec2 vector() const { return {static_cast<double>(x), static_cast<double>(y)}; }
    double length() const { return static_cast<double>(std::sqrt(x * x + y * y)); }
};

/// The point of a segment at a foot's parameter; the end points themselves at 0 and 1.
template <typename Real>
Vec2 point_on(const IndexedSegment& segment, Real parameter) {
    if (!(parameter < Real(1)))
        return segment.b;
    const auto at = [&](double a, double b) {
        return static_cast<double>(Real(a) + parameter * (Real(b) - Real(a)));
    };
    return {at(segment.a.x, segment.b.x), at(segment.a.y, segment.b.y)};
}
template <>
inline Vec2 point_on(const IndexedSegment& segment, double parameter) {
    const TwoReals at_a{segment.a.x, segment.a.y};
    const TwoReals at_b{segment.b.x, segment.b.y};
    const TwoReals step{parameter, parameter};
    const TwoReals point = step < TwoReals{1.0, 1.0} ? at_a + step * (at_b - at_a) : at_b;
    return {point[0], point[1]};
}

/// The nearest of the segments offered so far. Of equally near ones the tie rule of ContourIndex keeps one,
/// so the order of the offers does not matter.
template <typename Real>
struct Closest {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    Real squared = std::numeric_limits<Real>::infinity(); ///< mm²
    Real parameter = 0;
    std::uint32_t segment = none;

    void offer(const SegmentSet& set, std::uint32_t candidate, Vec2 p) noexcept {
        const Foot<Real> foot(set.segments[candidate], p);
        if (!(foot.squared <= squared))
            return;
        if (foot.squared == squared && segment != none && !wins_tie(set, candidate, foot.parameter))
            return;
        squared = foot.squared;
        parameter = foot.parameter;
        segment = candidate;
    }

private:
    [[gnu::noinline]] bool wins_tie(const SegmentSet& set, std::uint32_t candidate,
                                    Real candidate_parameter) const noexcept {
        const Vec2 mine = point_on(set.segments[segment], parameter);
        const Vec2 its = point_on(set.segments[candidate], candidate_parameter);
        return std::tie(its.x, its.y, set.owners[candidate]) < std::tie(mine.x, mine.y, set.owners[segment]);
    }
};

[[gnu::noinline]] inline Closest<double>
closest_of_equals(const SegmentSet& set, std::span<const std::uint32_t> list, Vec2 p) noexcept {
    const auto is_long = [&](std::uint32_t i) {
        return set.segments[i].is_longer_than(SegmentSet::double_tells_mm);
    };
    if (set.longest > SegmentSet::double_tells_mm && std::any_of(list.begin(), list.end(), is_long)) {
        Closest<long double> closest;
        for (const std::uint32_t candidate : list)
            closest.offer(set, candidate, p);
        return {static_cast<double>(closest.squared), static_cast<double>(closest.parameter),
                closest.segment};
    }
    Closest<double> closest;
    for (const std::uint32_t candidate : list)
        closest.offer(set, candidate, p);
    return closest;
}

/// The nearer of a pair, as closest_of finds it.
inline Closest<double> closer_of(const SegmentSet& set, std::span<const std::uint32_t> pair,
                                 Vec2 p) noexcept {
    const TwoSquares here(set.segments[pair[0]], set.segments[pair[1]], p);
    const std::size_t nearer = here.squared[1] < here.squared[0] ? 1 : 0;
    Closest<double> closest;
    closest.squared = here.squared[nearer];
    if (here.squared[1 - nearer] <= closest.squared * SegmentSet::indistinct + set.indistinct_square)
        [[unlikely]]
        return closest_of_equals(set, pair, p);
    closest.parameter = here.parameter[nearer];
    closest.segment = pair[nearer];
    return closest;
}

/// The nearest of a list, found by TwoSquares; where two of them are too close for that, offers all of them.
/// `list` comes in pairs, see SegmentSet::filler, and has at least one.
inline Closest<double> closest_of(const SegmentSet& set, std::span<const std::uint32_t> list,
                                  Vec2 p) noexcept {
    if (list.size() == 2)
        return closer_of(set, list, p);
    TwoReals best{1e300, 1e300};
    TwoReals second = best;
    TwoReals best_parameter{};
    TwoMarks best_segment{};
    for (std::size_t i = 0; i < list.size(); i += 2) {
        const TwoSquares here(set.segments[list[i]], set.segments[list[i + 1]], p);
        const TwoMarks better = here.squared < best;
        const TwoReals behind = here.squared > best ? here.squared : best;
        second = behind < second ? behind : second;
        best = here.squared < best ? here.squared : best;
        best_parameter = better ? here.parameter : best_parameter;
        best_segment = better ? TwoMarks{list[i], list[i + 1]} : best_segment;
    }
    Closest<double> closest;
    closest.squared = std::min(best[0], best[1]);
    const double other = std::min(std::max(best[0], best[1]), std::min(second[0], second[1]));
    if (other <= closest.squared * SegmentSet::indistinct + set.indistinct_square) [[unlikely]]
        return closest_of_equals(set, list, p);
    const TwoReals turned{best[1], best[0]};
    const TwoMarks left = best < turned;
    const TwoReals parameter_turned{best_parameter[1], best_parameter[0]};
    const TwoMarks segment_turned{best_segment[1], best_segment[0]};
    closest.parameter = (left ? best_parameter : parameter_turned)[0];
    closest.segment = static_cast<std::uint32_t>((left ? best_segment : segment_turned)[0]);
    return closest;
}

} // namespace tp
