// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace tp {

namespace {

/// Beyond this a distance inside the grid might need more than double.
constexpr double widest_mm = 5e4;
/// Scenes of fewer segments can afford cells for their surroundings too.
constexpr std::size_t small_scene = 16384;
constexpr double surroundings = 0.3; ///< on every side, as a share of the scene
constexpr std::size_t large_scene = 200'000;

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
        : grid_(grid), set_(set), tree_(tree), band_(band), margin_(margin), most_listed_(most_listed),
          most_pairs_(set.size() < large_scene ? 15 : CellGrid::most_pairs) {}

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
    static constexpr std::size_t short_list_coarse = 6;
    static constexpr std::uint32_t last_side_coarse = 4;
    /// A child looks for its candidates in the tree rather than in a list longer than this.
    static constexpr std::size_t long_list = 800;
    /// First blocks with more candidates than this wait until the others are done.
    static constexpr std::size_t most_found = 4096;
    static constexpr std::uint32_t few_blocks = 15;
    static constexpr std::size_t most_looks = 400; ///< for each cell that holds a list; usually a tenth

    Block block_at(std::uint32_t column, std::uint32_t row, std::uint32_t side) const;
    bool refine_from_tree(const Block& block, std::size_t depth, std::size_t most);
    /// Whether the work so far is in proportion to the segments and to the cells that hold a list.
    bool affordable() const { return looks_ < 4 * set_.size() + 20'000 + most_looks * listed_; }
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
    std::size_t most_pairs_;  ///< of one list: in a large scene, whose tree answers slowly, twice as many
    std::array<View, 8> views_;
    View found_;
    std::size_t looks_ = 0;  ///< two segments or places each
    std::size_t listed_ = 0; ///< cells
};

void CellGridBuilder::build() {
    std::uint32_t side = largest_first_side;
    while (side > 1 && std::size_t{side} * side * set_.size() > first_crowd * grid_.cell_count())
        side /= 2;
    const std::uint32_t across = (grid_.row_length_ + side - 1) / side;
    const std::uint32_t count = across * ((static_cast<std::uint32_t>(grid_.rows_) + side - 1) / side);
    std::uint32_t stride = std::max(1u, count * 5 / 13); // so that the first blocks speak for all
    while (std::gcd(stride, count) != 1)
        ++stride;
    std::vector<Block> crowded;
    std::uint64_t at = 0;
    for (std::uint32_t done = 0; done < count; ++done, at = (at + stride) % count) {
        const auto number = static_cast<std::uint32_t>(at);
        const Block block = block_at(number % across * side, number / across * side, side);
        if (!refine_from_tree(block, 0, most_found))
            crowded.push_back(block);
        if (done == few_blocks && crowded.size() == few_blocks + 1) {
            grid_.rows_ = grid_.columns_ = 0.0; // crowds everywhere: no cell would hold a list
            grid_.outside_ = 0;
            return grid_.cells_.clear();
        }
    }
    for (const Block& block : crowded)
        refine_from_tree(block, 0, set_.size());
}

CellGridBuilder::Block CellGridBuilder::block_at(std::uint32_t column, std::uint32_t row,
                                                 std::uint32_t side) const {
    const double cell = grid_.cell_size_mm();
    const double half = 0.5 * side * cell;
    return {column, row, side, grid_.origin_ + Vec2(column * cell + half, row * cell + half), half};
}

/// False, and nothing done, where more than `most` segments are in question.
bool CellGridBuilder::refine_from_tree(const Block& block, std::size_t depth, std::size_t most) {
    if (!affordable())
        return true;
    Closest<double> nearest;
    tree_.search(set_, block.centre, nearest);
    const IndexedSegment& segment = set_.segments[nearest.segment];
    found_.segments.clear();
    if (!tree_.collect_unbeaten(block.corners(), point_on(segment, nearest.parameter), 8.0 * margin_, most,
                                found_.segments)) {
        looks_ += found_.segments.size();
        return false;
    }
    found_.count = found_.segments.size();
    found_.segments.push_back(set_.filler());
    for (const std::size_t k : corner_places)
        found_.squares[k].resize(std::max(found_.squares[k].size(), found_.even()));
    look_from(block, 0, 2, found_);
    look_from(block, 6, 8, found_);
    keep_possible(block, found_, corner_places, views_[depth]);
    refine(block, depth);
    return true;
}

/// Measures the candidates of a view from two of the block's places.
void CellGridBuilder::look_from(const Block& block, std::size_t one, std::size_t other, View& view) {
    looks_ += view.even();
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
    double farthest = 0.0;
    for (const std::size_t k : corner_places) {
        nearest = std::min(nearest, view.next[k].squared);
        farthest = std::max(farthest, view.next[k].squared);
    }
    const bool beyond = std::sqrt(nearest) - block.radius() - 2.0 * margin_ > band_;
    // Beyond the band there is no force: where memory runs short, lists are kept coarser there.
    const bool coarse = beyond && grid_.lists_.size() > most_listed_ / 2;
    const bool straddles = !beyond && block.side > last_side_coarse && farthest > band_ * band_;
    if (block.side <= (coarse ? last_side_coarse : 1) ||
        (view.count <= (coarse ? short_list_coarse : short_list) && !straddles))
        return store(block, view, beyond);
    const std::size_t cells = std::size_t(block.side) * block.side;
    if (view.count > cells * most_pairs_ * 2 || !affordable())
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
                refine_from_tree(quarter, depth + 1, set_.size());
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
    if (pairs > most_pairs_ || lists.size() + 2 * pairs > most_listed_)
        return fill(block, mark);
    listed_ += std::size_t(block.side) * block.side;
    const auto first_pair = static_cast<std::uint32_t>(lists.size() / 2);
    lists.insert(lists.end(), view.segments.begin(),
                 view.segments.begin() + static_cast<std::ptrdiff_t>(view.even()));
    fill(block, (first_pair << CellGrid::flag_bits) | mark | static_cast<std::uint32_t>(pairs));
}

namespace {

/// Cells leave out an end that is farther than this, mm, and half of their width, from the mass of all.
constexpr double stray_mm = 150.0;

/// The rectangle of all ends but those that lie far from nearly all others.
Rect extent_of(const SegmentSet& set) {
    const std::size_t step = 1 + set.size() / 4096;
    std::array<std::vector<double>, 2> samples;
    for (std::size_t i = 0; i < set.size(); i += step)
        for (const Vec2 end : {set.segments[i].a, set.segments[i].b}) {
            samples[0].push_back(end.x);
            samples[1].push_back(end.y);
        }
    const std::size_t count = samples[0].size();
    const std::size_t few = count < 32 ? 0 : std::max<std::size_t>(2, count / 50);
    Rect wide;
    for (const int axis : {0, 1}) {
        std::vector<double>& all = samples[static_cast<std::size_t>(axis)];
        const auto at = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(all.begin(), at(few), all.end());
        const double low = all[few];
        std::nth_element(all.begin(), at(count - 1 - few), all.end());
        const double high = all[count - 1 - few];
        const double room = stray_mm + 0.5 * (high - low);
        wide.min[axis] = low - room;
        wide.max[axis] = high + room;
    }
    Rect extent{Vec2(std::numeric_limits<double>::infinity()),
                Vec2(-std::numeric_limits<double>::infinity())};
    for (std::size_t i = 0; i < set.size(); ++i)
        for (const Vec2 end : {set.segments[i].a, set.segments[i].b})
            if (few == 0 || wide.contains(end)) {
                extent.min = glm::min(extent.min, end);
                extent.max = glm::max(extent.max, end);
            }
    return extent;
}

} // namespace

CellGrid::CellGrid(const SegmentSet& set, const SegmentTree& tree, double band, std::size_t most_bytes) {
    if (set.size() == 0 || !(band < 1e6))
        return;
    const auto [min, max] = extent_of(set);
    bool strays = false; // beyond the cells lies more
    for (std::size_t i = 0; i < set.size(); ++i) {
        const auto& s = set.segments[i];
        const Vec2 low = glm::min(s.a, s.b), high = glm::max(s.a, s.b);
        strays = strays || low.x < min.x || low.y < min.y || high.x > max.x || high.y > max.y;
    }
    const double share = set.size() < small_scene ? surroundings : 0.0;
    const Vec2 pad = Vec2(band) + share * (max - min);
    const Vec2 around = max - min + 2.0 * pad;
    const double largest =
        std::max({std::abs(min.x), std::abs(min.y), std::abs(max.x), std::abs(max.y)}) + band;
    const auto count = static_cast<double>(set.size());
    const double wanted = std::clamp(48.0 * count, 4096.0, std::max(655360.0, std::min(1.2 * count, 8e5)));
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
    outside_ = strays ? 0 : beyond_band;
    cells_.resize(std::size_t(row_length_) * static_cast<std::size_t>(rows_));
    CellGridBuilder(*this, set, tree, band, margin,
                    (most_bytes - std::min(most_bytes, cells_.size() * 4)) / 4)
        .build();
    lists_.shrink_to_fit();
}

} // namespace tp
