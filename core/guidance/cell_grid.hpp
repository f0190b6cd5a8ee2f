// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/segment_tree.hpp"

#include <span>

namespace tp {

/// For each cell of a square grid the segments that can be nearest to some point of the cell.
///
/// A list holds more than those segments, never fewer: a segment is left out of a block of cells only where
/// another one is nearer in all of the block, by a margin far above rounding. Cells in which too many
/// segments meet hold no list.
class CellGrid {
public:
    /// What one cell says of the nearest segment.
    struct Cell {
        std::span<const std::uint32_t> candidates; ///< for closest_of; none where the cell holds no list
        bool beyond_band;                          ///< everything is farther away than the band
    };

    CellGrid() = default;
    /// Covers the segments, but for those that stray far from nearly all others, and at least `band` mm round
    /// them, with at most `most_bytes` of lists. Empty where the coordinates are too coarse for cells of
    /// a useful size, and where crowds of segments meet in all of them.
    CellGrid(const SegmentSet& set, const SegmentTree& tree, double band, std::size_t most_bytes);

    Cell at(Vec2 p) const noexcept {
        const double x = (p.x - origin_.x) * cells_per_mm_;
        const double y = (p.y - origin_.y) * cells_per_mm_;
        if (!(x >= 0.0 && x < columns_ && y >= 0.0 && y < rows_))
            return {{}, (outside_ & beyond_band) != 0};
        const auto column = static_cast<std::uint32_t>(static_cast<std::int32_t>(x));
        const auto row = static_cast<std::uint32_t>(static_cast<std::int32_t>(y));
        const std::uint32_t entry = cells_[std::size_t(row) * row_length_ + column];
        return {{lists_.data() + 2 * std::size_t(entry >> flag_bits), 2 * std::size_t(entry & most_pairs)},
                (entry & beyond_band) != 0};
    }

    std::size_t cell_count() const { return cells_.size(); }
    double cell_size_mm() const { return 1.0 / cells_per_mm_; }
    std::size_t bytes() const {
        return cells_.capacity() * sizeof(std::uint32_t) + lists_.capacity() * sizeof(std::uint32_t);
    }

private:
    friend class CellGridBuilder;
    static constexpr std::uint32_t count_bits = 5;
    static constexpr std::uint32_t most_pairs = (1u << count_bits) - 1u; ///< of candidates in one list
    static constexpr std::uint32_t beyond_band = 1u << count_bits;
    static constexpr std::uint32_t flag_bits = count_bits + 1;

    Vec2 origin_{0.0};
    double cells_per_mm_ = 1.0;
    double columns_ = 0.0; ///< whole numbers, as doubles for the comparison with a place
    double rows_ = 0.0;
    std::uint32_t row_length_ = 0;
    std::uint32_t outside_ = 0;
    std::vector<std::uint32_t> cells_; ///< row by row: the list's first pair, and in the low bits how many
    std::vector<std::uint32_t> lists_;
};

} // namespace tp
