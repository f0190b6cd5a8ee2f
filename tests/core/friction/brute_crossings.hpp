// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/scene.hpp"

#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

namespace tp::testing {

/// Which segment of which contour was crossed, and whether to its left.
using Crossed = std::tuple<int, std::uint32_t, bool>;

/// Crossings in whole numbers: every step against every segment. Places are whole multiples of 1/`per_mm` mm, a power of two,
/// within ±`reach` of these units; everything is scaled by 2^(2k) and the way moved by (2^k, 1), so little that no side
/// changes that is a side at all, and so much that no place is on a line any more. No rule for ties is needed.
class BruteCrossings {
public:
    BruteCrossings(const FlatScene& scene, double per_mm, int reach) : per_mm_(per_mm) {
        while ((std::int64_t(1) << shift_) < 8 * std::int64_t(reach))
            ++shift_;
        for (std::size_t c = 0; c < scene.lines.size(); ++c) {
            const Polyline& line = scene.lines[c];
            const std::size_t first = segments_.size();
            for (std::size_t i = 0; i < line.segment_count(); ++i) {
                const Whole a = whole(line.segment_start(i)), b = whole(line.segment_end(i));
                if (a == b)
                    continue;
                segments_.push_back({a, b, int(c), std::uint32_t(i), segments_.size() + 1});
            }
            if (segments_.size() == first)
                continue;
            segments_.back().behind = line.closed ? first : none;
        }
    }

    std::vector<Crossed> cross(Vec2 from, Vec2 to) const {
        std::vector<Crossed> crossed;
        const Whole p = moved(whole(from)), q = moved(whole(to));
        std::vector<int> sides;
        for (const Segment& s : segments_)
            sides.push_back(side_crossed(s, p, q));
        for (std::size_t i = 0; i < segments_.size(); ++i) // a vertex that is only touched
            if (const std::size_t j = segments_[i].behind;
                j != none && sides[i] != 0 && sides[j] == -sides[i])
                if (turn(whole(from), whole(to), segments_[i].b) == 0)
                    sides[i] = sides[j] = 0;
        for (std::size_t i = 0; i < segments_.size(); ++i)
            if (sides[i] != 0)
                crossed.emplace_back(segments_[i].contour, segments_[i].number, sides[i] > 0);
        return crossed;
    }

private:
    __extension__ using Wide = __int128;
    static constexpr std::size_t none = ~std::size_t(0);
    struct Whole {
        std::int64_t x, y; ///< scaled
        bool operator==(const Whole&) const = default;
    };
    struct Segment {
        Whole a, b;
        int contour;
        std::uint32_t number;
        std::size_t behind; ///< the segment that begins where this one ends
    };

    Whole whole(Vec2 p) const {
        const auto scaled = [&](double mm) { return std::llround(mm * per_mm_) << (2 * shift_); };
        return {scaled(p.x), scaled(p.y)};
    }
    Whole moved(Whole p) const { return {p.x + (std::int64_t(1) << shift_), p.y + 1}; }
    static int turn(Whole a, Whole b, Whole p) {
        const Wide value = Wide(b.x - a.x) * (p.y - a.y) - Wide(b.y - a.y) * (p.x - a.x);
        return value > 0 ? 1 : value < 0 ? -1 : 0;
    }
    static int side_crossed(const Segment& s, Whole p, Whole q) {
        const int begins = turn(s.a, s.b, p), ends = turn(s.a, s.b, q);
        if (begins == ends || turn(p, q, s.a) == turn(p, q, s.b))
            return 0;
        return ends;
    }

    double per_mm_;
    int shift_ = 0;
    std::vector<Segment> segments_;
};

/// The scene with each point on a lattice of 1/`per_mm` mm.
inline FlatScene on_lattice(FlatScene scene, double per_mm) {
    for (Polyline& line : scene.lines)
        for (Vec2& p : line.points)
            p = {std::round(p.x * per_mm) / per_mm, std::round(p.y * per_mm) / per_mm};
    return scene;
}

} // namespace tp::testing
