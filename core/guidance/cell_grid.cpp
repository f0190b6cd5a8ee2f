// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tp {

namespace {

/// Beyond this a distance inside the grid might need more than double.
constexpr double widest_mm = 5e4;
/// Scenes of fewer segments can afford cells for their surroundings too.
constexpr std::size_t small_scene = 16384;

/// Squared distances from the four corners of a block, mm².
struct CornerSquares {
    TwoReals lower, upper;
};

} // namespace

/// Builds the lists from coarse blocks of cells down to single cells; a child block's candidates are found
/// among its parent's. A block whose list is short enough shares it between all of its cells.
class CellGridBuilder {
public:
    CellGridBuilder(CellGrid& grid, const SegmentSet& set, const SegmentTree& tree, double band,
                    double margin, std::size_t most_listed)
        : grid_(grid), set_(set), tree_(tree), band_(band), margin_(margin), most_listed_(most_listed) {}

    void build();

private:
    struct Block {
        std::uint32_t column, row, side; ///< in cells
        Vec2 centre;                     ///< mm
        double half;                     ///< half of its width, mm, with a margin for the rounding of places

        double radius() const { return std::numbers::sqrt2 * half; }
        std::array<Vec2, 4> corners() const {
            return {centre + Vec2(-half, -half), centre + Vec2(half, -half), centre + Vec2(-half, half),
                    centre + Vec2(half, half)};
        }
    };
    /// A point of a segment, and how far it is from the corners of a block.
    struct Rival {
        Vec2 point;
        CornerSquares from;
    };
    using List = std::vector<std::uint32_t>;

    /// The first blocks have this many cells a side, or fewer where more than first_crowd segments would fall
    /// to each.
    static constexpr std::uint32_t largest_first_side = 16;
    static constexpr std::size_t first_crowd = 32;
    /// A list this short is not worth dividing the block for.
    static constexpr std::size_t short_list = 2;
    /// Beyond the band there is no force: lists are kept coarser.
    static constexpr std::size_t short_list_beyond = 6;
    static constexpr std::uint32_t last_side_beyond = 4;
    /// A child looks for its candidates in the tree rather than in a list longer than this.
    static constexpr std::size_t long_list = 96;

    Block block_at(std::uint32_t column, std::uint32_t row, std::uint32_t side) const;
    void refine_from_tree(const Block& block, std::size_t depth);
    void refine(const Block& block, const List& parents, std::size_t depth);
    double possible_of(const Block& block, const List& parents, List& list);
    void fill(const Block& block, std::uint32_t entry);
    void store(const Block& block, const List& list, bool beyond);

    CellGrid& grid_;
    const SegmentSet& set_;
    const SegmentTree& tree_;
    double band_;
    double margin_;           ///< mm, far above what rounding can do here
    std::size_t most_listed_; ///< entries of lists_
    std::array<List, 8> lists_;
    List found_;
    std::vector<CornerSquares> squares_;
    Vec2 last_centre_{0.0};
    double last_distance_ = std::numeric_limits<double>::infinity();
};

void CellGridBuilder::build() {
    std::uint32_t first_side = largest_first_side;
    while (first_side > 1 && first_side * first_side * set_.size() > first_crowd * grid_.cell_count())
        first_side /= 2;
    for (std::uint32_t row = 0; row < grid_.rows_; row += first_side)
        for (std::uint32_t column = 0; column < grid_.columns_; column += first_side)
            refine_from_tree(block_at(column, row, first_side), 0);
}

CellGridBuilder::Block CellGridBuilder::block_at(std::uint32_t column, std::uint32_t row,
                                                 std::uint32_t side) const {
    const double cell = grid_.cell_size_mm();
    const double half = 0.5 * side * cell;
    return {column, row, side, grid_.origin_ + Vec2(column * cell + half, row * cell + half), half + margin_};
}

void CellGridBuilder::refine_from_tree(const Block& block, std::size_t depth) {
    // The nearest segment is no farther than it was from the last block, plus the way between the blocks.
    const double at_most = last_distance_ + length(block.centre - last_centre_) + margin_;
    Closest<double> nearest;
    nearest.squared = at_most * at_most;
    tree_.search(set_, block.centre, nearest);
    last_centre_ = block.centre;
    last_distance_ = std::sqrt(nearest.squared);
    const IndexedSegment& segment = set_.segments[nearest.segment];
    found_.clear();
    tree_.collect_unbeaten(block.corners(), point_on(segment, nearest.parameter), margin_, found_);
    refine(block, found_, depth);
}

/// Puts those of `parents` into `list` that can be nearest somewhere in the block; returns the distance that
/// no place in the block falls below.
///
/// Where a point t is nearer to a corner than all of a segment is, it is nearer than each point y of it. The
/// places nearer to t than to y are a half-plane, and one that holds the four corners holds the block. So t
/// beats the segment in all of the block where it does at the corners. The points tried are the nearest ones
/// of the corners.
double CellGridBuilder::possible_of(const Block& block, const List& parents, List& list) {
    const std::array<Vec2, 4> corners = block.corners();
    const auto squares_from = [&](const auto& from) -> CornerSquares {
        return {TwoSquares(from, corners[0], corners[1]).squared,
                TwoSquares(from, corners[2], corners[3]).squared};
    };
    squares_.resize(parents.size());
    constexpr double far = 1e300;
    CornerSquares nearest{{far, far}, {far, far}};
    TwoMarks lower_nearest{}, upper_nearest{};
    for (std::size_t i = 0; i < parents.size(); ++i) {
        const CornerSquares here = squares_from(set_.segments[parents[i]]);
        squares_[i] = here;
        const TwoMarks its{parents[i], parents[i]};
        lower_nearest = here.lower < nearest.lower ? its : lower_nearest;
        upper_nearest = here.upper < nearest.upper ? its : upper_nearest;
        nearest.lower = here.lower < nearest.lower ? here.lower : nearest.lower;
        nearest.upper = here.upper < nearest.upper ? here.upper : nearest.upper;
    }
    const std::array<double, 4> reached{nearest.lower[0], nearest.lower[1], nearest.upper[0],
                                        nearest.upper[1]};
    const std::array<std::int64_t, 4> nearest_segment{lower_nearest[0], lower_nearest[1], upper_nearest[0],
                                                      upper_nearest[1]};
    // As a difference of squared distances; it leaves more than margin_ between the distances themselves.
    const double clearly = 2.0 * margin_ * (std::sqrt(std::ranges::max(reached)) + 4.0 * block.half);
    std::array<Rival, 4> rivals;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const IndexedSegment& segment = set_.segments[static_cast<std::size_t>(nearest_segment[k])];
        const Vec2 point = point_on(segment, Foot<double>(segment, corners[k]).parameter);
        bool known = false;
        for (std::size_t r = 0; r < count; ++r)
            known = known || rivals[r].point == point;
        if (known)
            continue;
        const Vec2 low = (corners[0] - point) * (corners[0] - point);
        const Vec2 high = (corners[3] - point) * (corners[3] - point);
        const TwoReals across{low.x + clearly, high.x + clearly};
        rivals[count++] = {point, {across + low.y, across + high.y}};
    }
    list.clear();
    for (std::size_t i = 0; i < parents.size(); ++i) {
        const CornerSquares here = squares_[i];
        const bool stays = std::all_of(rivals.begin(), rivals.begin() + count, [&](const Rival& rival) {
            const TwoReals lower = here.lower - rival.from.lower;
            const TwoReals upper = here.upper - rival.from.upper;
            const TwoReals lead = lower < upper ? lower : upper;
            return !(std::min(lead[0], lead[1]) > 0.0);
        });
        if (stays)
            list.push_back(parents[i]);
    }
    return std::sqrt(std::ranges::min(reached)) - block.radius() - margin_;
}

void CellGridBuilder::refine(const Block& block, const List& parents, std::size_t depth) {
    List& list = lists_[depth];
    const bool beyond = possible_of(block, parents, list) > band_;
    const bool divisible = block.side > (beyond ? last_side_beyond : 1);
    if (!divisible || list.size() <= (beyond ? short_list_beyond : short_list))
        return store(block, list, beyond);
    const std::size_t cells = std::size_t(block.side) * block.side;
    if (list.size() > 2 * CellGrid::most_pairs * cells)
        return fill(block, 0); // dividing a crowd evenly would still leave crowds
    const bool crowded = list.size() > long_list;
    const std::uint32_t half = block.side / 2;
    for (const std::uint32_t row : {block.row, block.row + half})
        for (const std::uint32_t column : {block.column, block.column + half}) {
            if (!(row < grid_.rows_ && column < grid_.columns_))
                continue;
            const Block child = block_at(column, row, half);
            if (crowded)
                refine_from_tree(child, depth + 1);
            else
                refine(child, list, depth + 1);
        }
}

void CellGridBuilder::fill(const Block& block, std::uint32_t entry) {
    const auto last_row = std::min(block.row + block.side, static_cast<std::uint32_t>(grid_.rows_));
    const auto last_column = std::min(block.column + block.side, grid_.row_length_);
    for (std::uint32_t row = block.row; row < last_row; ++row) {
        const auto begin =
            grid_.cells_.begin() + static_cast<std::ptrdiff_t>(std::size_t(row) * grid_.row_length_);
        std::fill(begin + block.column, begin + last_column, entry);
    }
}

void CellGridBuilder::store(const Block& block, const List& list, bool beyond) {
    std::vector<std::uint32_t>& lists = grid_.lists_;
    const std::uint32_t mark = beyond ? CellGrid::beyond_band : 0;
    const std::size_t pairs = (list.size() + 1) / 2;
    if (pairs > CellGrid::most_pairs || lists.size() + 2 * pairs > most_listed_)
        return fill(block, mark);
    const auto first_pair = static_cast<std::uint32_t>(lists.size() / 2);
    lists.insert(lists.end(), list.begin(), list.end());
    if (list.size() % 2 == 1)
        lists.push_back(set_.filler());
    fill(block, (first_pair << CellGrid::flag_bits) | mark | static_cast<std::uint32_t>(pairs));
}

CellGrid::CellGrid(const SegmentSet& set, const SegmentTree& tree, double band, std::size_t most_bytes) {
    if (set.size() == 0 || !(band < 1e6))
        return;
    Vec2 min = set.segments.front().a;
    Vec2 max = min;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const IndexedSegment& s = set.segments[i];
        min = glm::min(min, glm::min(s.a, s.b));
        max = glm::max(max, glm::max(s.a, s.b));
    }
    const double share = set.size() < small_scene ? 0.125 : 0.0;
    const Vec2 pad = Vec2(band) + share * (max - min);
    const Vec2 around = max - min + 2.0 * pad;
    const double largest =
        std::max({std::abs(min.x), std::abs(min.y), std::abs(max.x), std::abs(max.y)}) + band;
    const double wanted = std::clamp(32.0 * static_cast<double>(set.size()), 4096.0, 655360.0);
    const double wanted_in_memory = std::min(wanted, static_cast<double>(most_bytes) / 16.0);
    const double cell = std::sqrt(around.x / wanted_in_memory * around.y);
    const double margin = 1e-6 * cell;
    const Vec2 extent = around + Vec2(4.0 * margin);
    // Ten ulp of the largest coordinate, and the slack of a foot on the longest segment, must vanish in it.
    if (!(2.2e-15 * largest + 1e-14 * set.longest < margin) || !(std::max(extent.x, extent.y) < widest_mm))
        return;
    origin_ = min - pad - Vec2(2.0 * margin);
    cells_per_mm_ = 1.0 / cell;
    columns_ = std::ceil(extent.x / cell);
    rows_ = std::ceil(extent.y / cell);
    row_length_ = static_cast<std::uint32_t>(columns_);
    outside_ = beyond_band;
    cells_.resize(std::size_t(row_length_) * static_cast<std::size_t>(rows_));
    CellGridBuilder(*this, set, tree, band, margin,
                    (most_bytes - std::min(most_bytes, cells_.size() * 4)) / 4)
        .build();
    lists_.shrink_to_fit();
}

} // namespace tp
