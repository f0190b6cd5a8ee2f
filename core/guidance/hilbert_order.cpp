// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/segment_tree.hpp"

#include <algorithm>

namespace tp {

namespace {

struct Keyed {
    std::uint64_t key;
    std::uint32_t segment;
};

/// Place on a Hilbert curve of order 32 (the usual bitwise walk from the coarsest quadrant inwards).
std::uint64_t hilbert_place(std::uint32_t x, std::uint32_t y) {
    std::uint64_t place = 0;
    for (int bit = 31; bit >= 0; --bit) { // without branches, which no processor could foresee
        const std::uint32_t right = (x >> bit) & 1u;
        const std::uint32_t upper = (y >> bit) & 1u;
        place = (place << 2) | ((right * 3u) ^ upper);
        const std::uint32_t lower = upper - 1u;    // all bits where the quadrant is a lower one
        const std::uint32_t flip = lower & -right; // the lower right one is mirrored, both are transposed
        const std::uint32_t swap = lower & (x ^ y);
        x ^= flip ^ swap;
        y ^= flip ^ swap;
    }
    return place;
}

/// Half a coordinate's way into [min, max], as 32 bits; halves keep extents beyond 1e308 finite.
std::uint32_t lattice(double middle, double min, double extent) {
    if (!(extent > 0.0))
        return 0;
    return static_cast<std::uint32_t>(std::clamp((middle - min) / extent, 0.0, 1.0) * 4294967295.0);
}

} // namespace

void sort_along_hilbert_curve(SegmentSet& set, Repeats repeats) {
    const auto count = static_cast<std::uint32_t>(set.size());
    if (count == 0)
        return;
    const auto halfway = [](const IndexedSegment& s) { return 0.25 * s.a + 0.25 * s.b; };
    Vec2 min = halfway(set.segments.front());
    Vec2 max = min;
    for (const IndexedSegment& segment : set.segments) {
        min = glm::min(min, halfway(segment));
        max = glm::max(max, halfway(segment));
    }
    const double extent = std::max(max.x - min.x, max.y - min.y);
    std::vector<Keyed> order(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 middle = halfway(set.segments[i]);
        order[i] = {hilbert_place(lattice(middle.x, min.x, extent), lattice(middle.y, min.y, extent)), i};
    }
    const auto ends = [&](std::uint32_t i) {
        const IndexedSegment& s = set.segments[i];
        return std::tie(s.a.x, s.a.y, s.b.x, s.b.y);
    };
    std::sort(order.begin(), order.end(), [&](const Keyed& l, const Keyed& r) {
        if (l.key != r.key)
            return l.key < r.key;
        if (ends(l.segment) != ends(r.segment))
            return ends(l.segment) < ends(r.segment);
        return std::tie(set.owners[l.segment], set.numbers[l.segment]) <
               std::tie(set.owners[r.segment], set.numbers[r.segment]);
    });
    if (repeats == Repeats::left_out)
        order.erase(std::unique(order.begin(), order.end(),
                                [&](const Keyed& l, const Keyed& r) {
                                    return l.key == r.key && ends(l.segment) == ends(r.segment);
                                }),
                    order.end());

    SegmentSet sorted;
    sorted.longest = set.longest;
    sorted.segments.reserve(order.size() + 1);
    sorted.owners.reserve(order.size());
    sorted.numbers.reserve(order.size());
    for (const Keyed& keyed : order) {
        sorted.segments.push_back(set.segments[keyed.segment]);
        sorted.owners.push_back(set.owners[keyed.segment]);
        sorted.numbers.push_back(set.numbers[keyed.segment]);
    }
    sorted.add_filler();
    set = std::move(sorted);
}

} // namespace tp
