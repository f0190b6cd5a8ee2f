// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/crowd_bound.hpp"

#include <array>

namespace tp {

/// Packed R-tree over segments in Hilbert order (Kamel & Faloutsos 1993): every node but the last of a level
/// is full, so there are no pointers. Boxes are kept in single precision relative to the middle of the scene,
/// rounded outwards, and are only ever used to leave something out; the answers come from the segments.
class SegmentTree {
public:
    SegmentTree() = default;
    /// `set` must be in the order of `sort_along_hilbert_curve`.
    explicit SegmentTree(const SegmentSet& set);

    /// Prepares for places from which a crowd of segments is about equally far (see CrowdBound).
    void expect_crowds(const SegmentSet& set);

    /// Offers `best` every segment that may beat it or tie with it; returns how many. Real is double or long double. After
    /// expect_crowds, and once more than `crowd` segments have been offered, segments that are nearer by less
    /// than `indistinct_mm` than another may be left out.
    template <typename Real>
    std::uint32_t search(const SegmentSet& set, Vec2 p, Closest<Real>& best) const noexcept;
    static constexpr std::uint32_t crowd = 1024;
    static constexpr double indistinct_mm = 5e-10;

    /// Appends the segments, and perhaps a few more, that are not farther from all of `corners` than `rival`
    /// is, give or take `margin` mm. False, and not all of them, where they are more than `most`.
    bool collect_unbeaten(const std::array<Vec2, 4>& corners, Vec2 rival, double margin, std::size_t most,
                          std::vector<std::uint32_t>& out) const;

    /// Calls `visit` with every segment whose box meets the rectangle from `low` to `high` (mm), and perhaps with a few more.
    /// Allocates nothing.
    template <typename Visit>
    void for_each_near(Vec2 low, Vec2 high, Visit visit) const noexcept;

    std::size_t bytes() const {
        return nodes_.capacity() * sizeof(Node) + crowds_.capacity() * sizeof(CrowdBound);
    }

    static constexpr std::uint32_t fan_out = 8;   ///< boxes a node
    static constexpr std::uint32_t leaf_size = 4; ///< segments a lowest box
    static constexpr std::uint32_t segments_in_lowest_node = fan_out * leaf_size;

private:
    static constexpr int most_levels = 12;

    struct alignas(64) Node {
        std::array<float, fan_out> min_x, min_y, max_x, max_y;
        Node();
    };
    /// A box that is still to be looked at: level 0 boxes hold segments, the others the node of the same
    /// number one level below.
    template <typename Bound>
    struct Pending {
        Bound squared; ///< at most the squared distance of what it holds, mm²
        std::uint32_t box;
        std::int32_t level;
    };

    const Node& node(int level, std::uint32_t number) const {
        return nodes_[first_node_[static_cast<std::size_t>(level)] + number];
    }
    /// How many boxes the node holds that is box `box` of `level`.
    std::uint32_t held(int level, std::uint32_t box) const {
        return std::min(fan_out, boxes_[static_cast<std::size_t>(level) - 1] - box * fan_out);
    }
    template <bool in_crowd, typename Real>
    bool search_from_root(const SegmentSet& set, Vec2 p, Closest<Real>& best,
                          std::uint32_t& leaves) const noexcept;
    template <typename Bound>
    void raise_by_crowds(int level, std::uint32_t first_box, std::uint32_t count, Vec2 p, double nearest,
                         std::array<Bound, fan_out>& squared) const noexcept;
    void set_box(std::size_t level, std::uint32_t box, const std::array<float, 4>& bounds);
    /// The rectangle as boxes are kept, rounded outwards: min x, min y, max x, max y.
    std::array<float, 4> as_box(Vec2 low, Vec2 high) const;

    Vec2 middle_{0.0};
    std::uint32_t segment_count_ = 0;
    int levels_ = 0;
    std::array<std::uint32_t, most_levels> boxes_{}; ///< of each level
    std::array<std::uint32_t, most_levels> first_node_{};
    std::vector<Node> nodes_;
    std::vector<CrowdBound> crowds_; ///< one a node, or none
};

template <typename Visit>
void SegmentTree::for_each_near(Vec2 low, Vec2 high, Visit visit) const noexcept {
    const std::array<float, 4> wanted = as_box(low, high);
    struct Waiting {
        std::uint32_t box;
        std::int32_t level;
    };
    std::array<Waiting, std::size_t{most_levels} * fan_out> stack;
    std::size_t height = 0;
    stack[height++] = {0, levels_};
    while (height > 0) {
        const Waiting now = stack[--height];
        if (now.level == 0) {
            const std::uint32_t end = std::min(segment_count_, (now.box + 1) * leaf_size);
            for (std::uint32_t i = now.box * leaf_size; i < end; ++i)
                visit(i);
            continue;
        }
        const Node& holder = node(now.level - 1, now.box);
        for (std::uint32_t k = 0; k < held(now.level, now.box); ++k)
            if (!(holder.min_x[k] > wanted[2] || holder.max_x[k] < wanted[0] || holder.min_y[k] > wanted[3] ||
                  holder.max_y[k] < wanted[1]))
                stack[height++] = {now.box * fan_out + k, now.level - 1};
    }
}

/// Whether segments that lie on one another are kept.
enum class Repeats {
    left_out, ///< of those that repeat another one only that with the first owner: the others can never be nearest
    kept
};

/// Brings segments into Hilbert order. Adds the filler.
void sort_along_hilbert_curve(SegmentSet& set, Repeats repeats = Repeats::left_out);

} // namespace tp
