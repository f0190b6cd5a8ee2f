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

/// The nine places of a block that its four quarters have as corners, row by row from the lower left; the
/// block's own corners are the four of them that stand at `corner_places`.
constexpr std::size_t places = 9;
constexpr std::array<std::size_t, 4> corner_places{0, 2, 6, 8};

} // namespace

/// Builds the lists from coarse blocks of cells down to single cells; a child block's candidates are found
/// among its parent's, from distances that the parent measured for all of its children. A block whose list
/// is short enough shares it between all of its cells.
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
        double half;                     ///< half of its width, mm

        double radius() const { return std::numbers::sqrt2 * half; }
        Vec2 place(std::size_t number) const {
            return centre + half * Vec2(double(number % 3) - 1.0, double(number / 3) - 1.0);
        }
        std::array<Vec2, 4> corners() const { return {place(0), place(2), place(6), place(8)}; }
    };
    /// What is nearest to a place.
    struct Next {
        double squared; ///< mm²
        Vec2 point;
    };
    /// A block's candidates as its nine places see them.
    struct View {
        std::size_t count = 0;                           ///< of the candidates
        std::vector<std::uint32_t> segments;             ///< `even` of them: the last may be a filler
        std::array<std::vector<double>, places> squares; ///< mm², one a segment
        std::array<Next, places> next;

        std::size_t even() const { return count + count % 2; }
        void make_room(std::size_t size) {
            if (size <= segments.size())
                return;
            segments.resize(size);
            for (std::vector<double>& column : squares)
                column.resize(size);
        }
    };

    /// The first blocks have this many cells a side, or fewer where more than first_crowd segments would fall
    /// to each.
    static constexpr std::uint32_t largest_first_side = 32;
    static constexpr std::size_t first_crowd = 200;
    /// A list this short is not worth dividing the block for.
    static constexpr std::size_t short_list = 2;
    /// Beyond the band there is no force: lists are kept coarser.
    static constexpr std::size_t short_list_beyond = 6;
    static constexpr std::uint32_t last_side_beyond = 4;
    /// A child looks for its candidates in the tree rather than in a list longer than this.
    static constexpr std::size_t long_list = 800;

    Block block_at(std::uint32_t column, std::uint32_t row, std::uint32_t side) const;
    void refine_from_tree(const Block& block, std::size_t depth);
    void refine(const Block& block, std::size_t depth);
    void look_from(const Block& block, std::size_t one, std::size_t other, View& view);
    void keep_possible(const Block& block, const View& from, const std::array<std::size_t, 4>& corners,
                       View& kept);
    void fill(const Block& block, std::uint32_t entry);
    void store(const Block& block, const View& view, bool beyond);

    CellGrid& grid_;
    const SegmentSet& set_;
    const SegmentTree& tree_;
    double band_;
    double margin_;           ///< mm, far above what rounding can do here
    std::size_t most_listed_; ///< entries of lists_
    std::array<View, 8> views_;
    View found_;
    Vec2 last_centre_{0.0};
    double last_distance_ = std::numeric_limits<double>::infinity();
};

void CellGridBuilder::build() {
    std::uint32_t first_side = largest_first_side;
    while (first_side > 1 &&
           std::size_t{first_side} * first_side * set_.size() > first_crowd * grid_.cell_count())
        first_side /= 2;
    for (std::uint32_t row = 0; row < grid_.rows_; row += first_side)
        for (std::uint32_t column = 0; column < grid_.columns_; column += first_side)
            refine_from_tree(block_at(column, row, first_side), 0);
}

CellGridBuilder::Block CellGridBuilder::block_at(std::uint32_t column, std::uint32_t row,
                                                 std::uint32_t side) const {
    const double cell = grid_.cell_size_mm();
    const double half = 0.5 * side * cell;
    return {column, row, side, grid_.origin_ + Vec2(column * cell + half, row * cell + half), half};
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
    found_.segments.clear();
    tree_.collect_unbeaten(block.corners(), point_on(segment, nearest.parameter), 8.0 * margin_,
                           found_.segments);
    found_.count = found_.segments.size();
    found_.segments.push_back(set_.filler());
    for (const std::size_t k : corner_places)
        found_.squares[k].resize(std::max(found_.squares[k].size(), found_.even()));
    look_from(block, 0, 2, found_);
    look_from(block, 6, 8, found_);
    keep_possible(block, found_, corner_places, views_[depth]);
    refine(block, depth);
}

/// Measures the candidates of a view from two of the block's places.
void CellGridBuilder::look_from(const Block& block, std::size_t one, std::size_t other, View& view) {
    const Vec2 p = block.place(one);
    const Vec2 q = block.place(other);
    constexpr double far = 1e300;
    TwoReals nearest{far, far}, parameter{};
    TwoMarks segment{};
    for (std::size_t i = 0; i < view.even(); ++i) {
        const TwoSquares here(set_.segments[view.segments[i]], p, q);
        view.squares[one][i] = here.squared[0];
        view.squares[other][i] = here.squared[1];
        const TwoMarks its{view.segments[i], view.segments[i]};
        const TwoMarks nearer = here.squared < nearest;
        segment = nearer ? its : segment;
        parameter = nearer ? here.parameter : parameter;
        nearest = nearer ? here.squared : nearest;
    }
    const auto next = [&](std::size_t k) -> Next {
        return {nearest[k], point_on(set_.segments[static_cast<std::size_t>(segment[k])], parameter[k])};
    };
    view.next[one] = next(0);
    view.next[other] = next(1);
}

/// Copies those candidates that can be nearest somewhere in the block, whose corners are the given places of
/// `from`.
///
/// Where a point t is nearer to a corner than all of a segment is, it is nearer than each point y of it. The
/// places nearer to t than to y are a half-plane, and one that holds the four corners holds the block. So t
/// beats the segment in all of the block where it does at the corners. The points tried are the nearest ones
/// of the corners.
void CellGridBuilder::keep_possible(const Block& block, const View& from,
                                    const std::array<std::size_t, 4>& corners, View& kept) {
    double farthest = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        kept.next[corner_places[k]] = from.next[corners[k]];
        farthest = std::max(farthest, from.next[corners[k]].squared);
    }
    // As a difference of squared distances, so large that it holds for all places within margin_ of the block
    // too: the squares' difference is affine in the place, its slope twice the way between t and y.
    const double clearly = 16.0 * margin_ * (std::sqrt(farthest) + 4.0 * block.half);
    const std::array<Vec2, 4> at = block.corners();
    std::array<std::array<double, 4>, 4> limits; ///< of a rival, at a corner
    std::array<Vec2, 4> rivals;
    std::size_t rival_count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 point = from.next[corners[k]].point;
        if (std::find(rivals.begin(), rivals.begin() + rival_count, point) != rivals.begin() + rival_count)
            continue;
        const Vec2 low = (at[0] - point) * (at[0] - point);
        const Vec2 high = (at[3] - point) * (at[3] - point);
        rivals[rival_count] = point;
        limits[rival_count++] = {low.x + low.y + clearly, high.x + low.y + clearly, low.x + high.y + clearly,
                                 high.x + high.y + clearly};
    }
    const std::array<const double*, 4> seen{from.squares[corners[0]].data(), from.squares[corners[1]].data(),
                                            from.squares[corners[2]].data(), from.squares[corners[3]].data()};
    kept.make_room(from.even() + 1);
    std::size_t count = 0;
    for (std::size_t i = 0; i < from.count; i += 2) {
        std::array<TwoReals, 4> squares;
        for (std::size_t k = 0; k < 4; ++k)
            squares[k] = TwoReals{seen[k][i], seen[k][i + 1]};
        TwoReals lead{-1.0, -1.0}; // by how much, at least, the best rival is nearer at every corner
        for (std::size_t r = 0; r < rival_count; ++r) {
            TwoReals least = squares[0] - limits[r][0];
            for (std::size_t k = 1; k < 4; ++k) {
                const TwoReals here = squares[k] - limits[r][k];
                least = here < least ? here : least;
            }
            lead = least > lead ? least : lead;
        }
        for (std::size_t half = 0; half < 2; ++half) {
            kept.segments[count] = from.segments[i + half];
            for (std::size_t k = 0; k < 4; ++k)
                kept.squares[corner_places[k]][count] = squares[k][half];
            count += !(lead[half] > 0.0) && i + half < from.count ? 1 : 0;
        }
    }
    kept.count = count;
    if (count % 2 == 1) {
        kept.segments[count] = set_.filler();
        for (const std::size_t k : corner_places)
            kept.squares[k][count] = std::numeric_limits<double>::infinity();
    }
}

void CellGridBuilder::refine(const Block& block, std::size_t depth) {
    View& view = views_[depth];
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::size_t k : corner_places)
        nearest = std::min(nearest, view.next[k].squared);
    const bool beyond = std::sqrt(nearest) - block.radius() - 2.0 * margin_ > band_;
    const bool divisible = block.side > (beyond ? last_side_beyond : 1);
    if (!divisible || view.count <= (beyond ? short_list_beyond : short_list))
        return store(block, view, beyond);
    const std::size_t cells = std::size_t(block.side) * block.side;
    if (view.count > cells * CellGrid::most_pairs * 2)
        return fill(block, 0); // dividing a crowd evenly would still leave crowds
    const bool crowded = view.count > long_list;
    if (!crowded) {
        look_from(block, 1, 3, view);
        look_from(block, 5, 7, view);
        look_from(block, 4, 4, view);
    }
    const std::uint32_t half = block.side / 2;
    for (const std::uint32_t up : {0u, 1u})
        for (const std::uint32_t right : {0u, 1u}) {
            const std::uint32_t row = block.row + up * half;
            const std::uint32_t column = block.column + right * half;
            if (!(row < grid_.rows_ && column < grid_.columns_))
                continue;
            const Block quarter = block_at(column, row, half);
            if (crowded) {
                refine_from_tree(quarter, depth + 1);
                continue;
            }
            const std::size_t first = 3 * up + right;
            keep_possible(quarter, view, {first, first + 1, first + 3, first + 4}, views_[depth + 1]);
            refine(quarter, depth + 1);
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

void CellGridBuilder::store(const Block& block, const View& view, bool beyond) {
    std::vector<std::uint32_t>& lists = grid_.lists_;
    const std::uint32_t mark = beyond ? CellGrid::beyond_band : 0;
    const std::size_t pairs = view.even() / 2;
    if (pairs > CellGrid::most_pairs || lists.size() + 2 * pairs > most_listed_)
        return fill(block, mark);
    const auto first_pair = static_cast<std::uint32_t>(lists.size() / 2);
    lists.insert(lists.end(), view.segments.begin(),
                 view.segments.begin() + static_cast<std::ptrdiff_t>(view.even()));
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
    const double wanted = std::clamp(20.0 * static_cast<double>(set.size()), 4096.0, 655360.0);
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
