// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/indexed_segment.hpp"

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

    /// Offers `best` every segment that may beat it or tie with it. Real is double or long double.
    template <typename Real>
    void search(const SegmentSet& set, Vec2 p, Closest<Real>& best) const noexcept;

    /// Appends the segments, and perhaps a few more, that are not farther from all of `corners` than `rival`
    /// is, give or take `margin` mm.
    void collect_unbeaten(const std::array<Vec2, 4>& corners, Vec2 rival, double margin,
                          std::vector<std::uint32_t>& out) const;

    std::size_t bytes() const { return nodes_.capacity() * sizeof(Node); }

private:
    static constexpr std::uint32_t fan_out = 8;   ///< boxes a node
    static constexpr std::uint32_t leaf_size = 4; ///< segments a lowest box
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
    void set_box(std::size_t level, std::uint32_t box, const std::array<float, 4>& bounds);

    Vec2 middle_{0.0};
    std::uint32_t segment_count_ = 0;
    int levels_ = 0;
    std::array<std::uint32_t, most_levels> boxes_{}; ///< of each level
    std::array<std::uint32_t, most_levels> first_node_{};
    std::vector<Node> nodes_;
};

/// Brings segments into Hilbert order and leaves out those that repeat another one with the same owner or a
/// later one: they can never be the answer. Adds the filler.
void sort_along_hilbert_curve(SegmentSet& set);

} // namespace tp
