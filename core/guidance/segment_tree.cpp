// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/segment_tree.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// The largest float below `x`, and below x minus the rounding of what led to `x`.
float rounded_down(double x) {
    if (x <= -double(std::numeric_limits<float>::max()))
        return -infinite;
    const double held = std::min(x, double(std::numeric_limits<float>::max()));
    return std::nextafter(static_cast<float>(held), -infinite);
}

float rounded_up(double x) { return -rounded_down(-x); }

/// What a segment's foot may be wrong by, per mm of the segment (see Foot): 16 ulp.
constexpr double foot_slack = 4e-15;

/// A place on one axis as a box sees it: never farther from the box's sides than it is. What overflows to
/// something that is not a number counts as inside.
template <typename Bound>
struct Place {
    Bound low, high;
    /// How far beyond the sides; zero between them.
    Bound outside(float min, float max) const {
        const Bound before = Bound(min) - high;
        const Bound behind = low - Bound(max);
        const Bound either = before > behind ? before : behind;
        return either > Bound(0) ? either : Bound(0);
    }
};

/// Single precision will do to leave boxes out when the answer is wanted in double.
template <typename Real>
struct BoundFor {
    using type = Real;
    static Place<Real> place(double p, double middle) { return {Real(p) - middle, Real(p) - middle}; }
};
template <>
struct BoundFor<double> {
    using type = float;
    static Place<float> place(double p, double middle) {
        return {rounded_down(p - middle), rounded_up(p - middle)};
    }
};

/// In a crowd the bounds of the boxes differ by little.
struct Crowded {};
template <>
struct BoundFor<Crowded> {
    using type = double;
    static Place<double> place(double p, double middle) { return {p - middle, p - middle}; }
};

/// Boxes from here on are left out: bounds may be wrong by a few of their ulp, so that much is allowed for,
/// and it is above `squared`, so that ties stay in.
template <typename Bound, typename Real>
Bound limit_above(Real squared) {
    constexpr Real slack = Real(16) * Real(std::numeric_limits<Bound>::epsilon());
    return static_cast<Bound>(squared * (Real(1) + slack)) + std::numeric_limits<Bound>::min();
}

} // namespace

SegmentTree::Node::Node() {
    min_x.fill(infinite); // an empty box is infinitely far from everything
    min_y.fill(infinite);
    max_x.fill(-infinite);
    max_y.fill(-infinite);
}

void SegmentTree::set_box(std::size_t level, std::uint32_t box, const std::array<float, 4>& bounds) {
    Node& holder = nodes_[first_node_[level] + box / fan_out];
    const std::uint32_t slot = box % fan_out;
    holder.min_x[slot] = bounds[0];
    holder.min_y[slot] = bounds[1];
    holder.max_x[slot] = bounds[2];
    holder.max_y[slot] = bounds[3];
}

std::array<float, 4> SegmentTree::as_box(Vec2 low, Vec2 high) const {
    const Vec2 from = low - middle_;
    const Vec2 to = high - middle_;
    return {rounded_down(from.x), rounded_down(from.y), rounded_up(to.x), rounded_up(to.y)};
}

SegmentTree::SegmentTree(const SegmentSet& set) : segment_count_(static_cast<std::uint32_t>(set.size())) {
    if (segment_count_ == 0)
        return;
    Vec2 min = set.segments.front().a;
    Vec2 max = min;
    for (std::uint32_t i = 0; i < segment_count_; ++i) {
        const IndexedSegment& s = set.segments[i];
        min = glm::min(min, glm::min(s.a, s.b));
        max = glm::max(max, glm::max(s.a, s.b));
    }
    middle_ = 0.5 * min + 0.5 * max;

    boxes_[0] = (segment_count_ + leaf_size - 1) / leaf_size;
    std::uint32_t total = 0;
    for (levels_ = 0;; ++levels_) {
        const auto level = static_cast<std::size_t>(levels_);
        first_node_[level] = total;
        const std::uint32_t nodes = (boxes_[level] + fan_out - 1) / fan_out;
        total += nodes;
        if (nodes == 1)
            break;
        boxes_[level + 1] = nodes;
    }
    ++levels_;
    nodes_.resize(total);

    for (std::uint32_t box = 0; box < boxes_[0]; ++box) {
        Vec2 low(std::numeric_limits<double>::infinity());
        Vec2 high = -low;
        const std::uint32_t end = std::min(segment_count_, (box + 1) * leaf_size);
        for (std::uint32_t i = box * leaf_size; i < end; ++i) {
            const IndexedSegment& s = set.segments[i];
            const Vec2 slack = foot_slack * glm::abs(s.b - s.a);
            const Vec2 wide(slack.x + slack.y);
            low = glm::min(low, glm::min(s.a, s.b) - middle_ - wide);
            high = glm::max(high, glm::max(s.a, s.b) - middle_ + wide);
        }
        set_box(0, box, {rounded_down(low.x), rounded_down(low.y), rounded_up(high.x), rounded_up(high.y)});
    }
    for (std::size_t level = 1; level < static_cast<std::size_t>(levels_); ++level)
        for (std::uint32_t box = 0; box < boxes_[level]; ++box) {
            const Node& below = node(static_cast<int>(level) - 1, box);
            set_box(level, box,
                    {std::ranges::min(below.min_x), std::ranges::min(below.min_y),
                     std::ranges::max(below.max_x), std::ranges::max(below.max_y)});
        }
}

void SegmentTree::expect_crowds(const SegmentSet& set) {
    if (segment_count_ <= crowd)
        return;
    crowds_.resize(nodes_.size());
    const auto bounds = [&](int level) {
        return crowds_.data() + first_node_[static_cast<std::size_t>(level) - 1];
    };
    const auto count = [&](int level) {
        return level == levels_ ? 1u : boxes_[static_cast<std::size_t>(level)];
    };
    const auto size = [](int level) { return std::uint64_t(leaf_size) << (3 * level); }; // fan_out is 2³
    const auto first = [&](int level, std::uint32_t box) {
        return static_cast<std::uint32_t>(box * size(level));
    };
    const auto end = [&](int level, std::uint32_t box) {
        return static_cast<std::uint32_t>(std::min<std::uint64_t>(segment_count_, (box + 1) * size(level)));
    };
    for (int level = levels_; level >= 1; --level)
        for (std::uint32_t box = 0; box < count(level); ++box)
            bounds(level)[box] =
                with_hubs(set, first(level, box), end(level, box),
                          level == levels_ ? nullptr : bounds(level + 1) + box / fan_out, level == 1);
    for (int level = 1; level <= levels_; ++level)
        for (std::uint32_t box = 0; box < count(level); ++box)
            if (level == 1 || !gather(bounds(level)[box],
                                      {bounds(level - 1) + std::size_t{box} * fan_out, held(level, box)}))
                measure(bounds(level)[box], set, first(level, box), end(level, box));
}

template <typename Real>
std::uint32_t SegmentTree::search(const SegmentSet& set, Vec2 p, Closest<Real>& best) const noexcept {
    std::uint32_t leaves = 0;
    if (segment_count_ > 0 && !search_from_root<false>(set, p, best, leaves))
        if constexpr (std::is_same_v<Real, double>)
            search_from_root<true>(set, p, best, leaves);
    return leaves * leaf_size;
}

/// Raises the bounds of `count` nodes to what CrowdBound says of them; to infinity for one that cannot be nearer
/// than `nearest` by more than is distinct.
template <typename Bound>
void SegmentTree::raise_by_crowds(int level, std::uint32_t first_box, std::uint32_t count, Vec2 p,
                                  double nearest, std::array<Bound, fan_out>& squared) const noexcept {
    const CrowdBound* const crowds = &crowds_[first_node_[static_cast<std::size_t>(level) - 1] + first_box];
    for (std::uint32_t k = 0; k < count; ++k) {
        const double bound = crowds[k].at_least(p);
        if (bound > nearest - indistinct_mm)
            squared[k] = std::numeric_limits<Bound>::infinity();
        else if (bound > 0.0)
            squared[k] = std::max(squared[k], static_cast<Bound>(bound * bound * (1.0 - 1e-14)));
    }
}

/// False where a crowd was met: the search has found something, but need not have found the nearest.
template <bool in_crowd, typename Real>
bool SegmentTree::search_from_root(const SegmentSet& set, Vec2 p, Closest<Real>& best,
                                   std::uint32_t& leaves) const noexcept {
    using Of = BoundFor<std::conditional_t<in_crowd, Crowded, Real>>;
    using Bound = typename Of::type;
    const Place<Bound> x = Of::place(p.x, middle_.x);
    const Place<Bound> y = Of::place(p.y, middle_.y);
    std::array<Pending<Bound>, std::size_t{most_levels} * fan_out> stack;
    std::size_t height = 0;
    Pending<Bound> now{Bound(0), 0, levels_};
    const bool ends_at_crowd = !in_crowd && std::is_same_v<Real, double> && !crowds_.empty();
    for (;;) {
        if (now.level == 0) {
            if (ends_at_crowd && leaves == crowd / leaf_size)
                return false;
            ++leaves;
            const std::uint32_t end = std::min(segment_count_, (now.box + 1) * leaf_size);
            for (std::uint32_t i = now.box * leaf_size; i < end; ++i)
                best.offer(set, i, p);
        } else {
            const Node& holder = node(now.level - 1, now.box);
            std::array<Bound, fan_out> squared;
            for (std::size_t k = 0; k < fan_out; ++k) {
                const Bound dx = x.outside(holder.min_x[k], holder.max_x[k]);
                const Bound dy = y.outside(holder.min_y[k], holder.max_y[k]);
                squared[k] = dx * dx + dy * dy;
            }
            const Bound limit = limit_above<Bound>(best.squared);
            const std::uint32_t count = held(now.level, now.box);
            if constexpr (in_crowd)
                if (now.level >= 2)
                    raise_by_crowds(now.level - 1, now.box * fan_out, count, p, std::sqrt(best.squared),
                                    squared);
            const std::size_t base = height;
            for (std::uint32_t k = 0; k < count; ++k) {
                if (!(squared[k] < limit))
                    continue;
                std::size_t place = height++; // farthest first, so that the nearest is taken next
                for (; place > base && stack[place - 1].squared < squared[k]; --place)
                    stack[place] = stack[place - 1];
                stack[place] = {squared[k], now.box * fan_out + k, now.level - 1};
            }
        }
        const Bound limit = limit_above<Bound>(best.squared);
        do {
            if (height == 0)
                return true;
            now = stack[--height];
        } while (!(now.squared < limit));
    }
}

template std::uint32_t SegmentTree::search(const SegmentSet&, Vec2, Closest<double>&) const noexcept;
template std::uint32_t SegmentTree::search(const SegmentSet&, Vec2, Closest<long double>&) const noexcept;

bool SegmentTree::collect_unbeaten(const std::array<Vec2, 4>& corners, Vec2 rival, double margin,
                                   std::size_t most, std::vector<std::uint32_t>& out) const {
    if (segment_count_ == 0)
        return true;
    std::array<Place<float>, 4> x, y;
    std::array<float, 4> limit;
    for (std::size_t k = 0; k < 4; ++k) {
        x[k] = BoundFor<double>::place(corners[k].x, middle_.x);
        y[k] = BoundFor<double>::place(corners[k].y, middle_.y);
        const double reach = length(corners[k] - rival) + margin;
        limit[k] = limit_above<float>(reach * reach);
    }
    std::vector<Pending<float>> stack{{0.0f, 0, levels_}};
    while (!stack.empty()) {
        if (out.size() > most)
            return false;
        const Pending<float> now = stack.back();
        stack.pop_back();
        if (now.level == 0) {
            const std::uint32_t end = std::min(segment_count_, (now.box + 1) * leaf_size);
            for (std::uint32_t i = now.box * leaf_size; i < end; ++i)
                out.push_back(i);
            continue;
        }
        const Node& holder = node(now.level - 1, now.box);
        std::array<float, fan_out> lead;
        lead.fill(infinite);
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t i = 0; i < fan_out; ++i) {
                const float dx = x[k].outside(holder.min_x[i], holder.max_x[i]);
                const float dy = y[k].outside(holder.min_y[i], holder.max_y[i]);
                const float here = dx * dx + dy * dy - limit[k];
                lead[i] = here < lead[i] ? here : lead[i];
            }
        for (std::uint32_t i = 0; i < held(now.level, now.box); ++i)
            if (!(lead[i] >= 0.0f))
                stack.push_back({0.0f, now.box * fan_out + i, now.level - 1});
    }
    return out.size() <= most;
}

} // namespace tp
