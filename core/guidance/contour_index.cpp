// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/contour_index.hpp"

#include <algorithm>
#include <numeric>

namespace tp {

namespace {

/// Up to here a distance computed in double is true to 5e-10 mm, and squares are far from overflow.
constexpr double double_suffices_mm = 1e6;
/// On longer segments than this the foot found in double is found again in extended precision.
constexpr double short_mm = 1e3;

/// What the cells may take, bytes: a face stays below a mebibyte in all, a million segments below a hundred.
constexpr std::size_t small_scene_bytes = std::size_t(512) << 10;
constexpr std::size_t large_scene_bytes = std::size_t(44) << 20;

/// What a search within `reach` begins with; a little above, so that what lies on the edge is found.
template <typename Real>
Real square_above(double reach) {
    return Real(reach) * Real(reach) * Real(1.0 + 1e-12);
}

/// Contours in the order that breaks ties: by name, then by place in the scene.
std::vector<int> by_name(const std::vector<std::string>& names, std::size_t count) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    const auto name = [&](int c) -> const std::string& { return names[static_cast<std::size_t>(c)]; };
    const auto before = [&](int l, int r) { return name(l) < name(r); };
    if (!std::is_sorted(order.begin(), order.end(), before))
        std::stable_sort(order.begin(), order.end(), before);
    return order;
}

SegmentSet segments_of(const FlatScene& scene, const std::vector<int>& contours) {
    SegmentSet set;
    std::size_t count = 0;
    for (const Polyline& line : scene.lines)
        count += line.segment_count();
    set.segments.reserve(count);
    set.owners.reserve(count);
    set.numbers.reserve(count);
    for (std::size_t owner = 0; owner < contours.size(); ++owner) {
        const Polyline& line = scene.lines[static_cast<std::size_t>(contours[owner])];
        for (std::size_t i = 0; i < line.segment_count(); ++i) {
            const Vec2 a = line.segment_start(i);
            const Vec2 b = line.segment_end(i);
            if (!is_finite(a) || !is_finite(b))
                continue;
            set.segments.emplace_back(a, b);
            set.owners.push_back(static_cast<int>(owner));
            set.numbers.push_back(static_cast<std::uint32_t>(i));
            set.longest = std::max(set.longest, std::abs(b.x - a.x) + std::abs(b.y - a.y));
        }
    }
    return set;
}

} // namespace

ContourIndex::ContourIndex(const FlatScene& scene, double band_mm)
    : contours_(by_name(scene.names, scene.lines.size())), band_(band_mm) {
    set_ = segments_of(scene, contours_);
    sort_along_hilbert_curve(set_);
    tree_ = SegmentTree(set_);
    if (set_.longest < double_suffices_mm)
        tree_.expect_crowds(set_);
    wide_ = !(set_.longest < double_suffices_mm);
    // A face stays below a mebibyte, a million segments below a hundred.
    const std::size_t most_cell_bytes = std::min(small_scene_bytes + 400 * set_.size(), large_scene_bytes);
    if (!wide_)
        grid_ = CellGrid(set_, tree_, band_, most_cell_bytes);
}

template <typename Real>
Nearest ContourIndex::answer(const Closest<Real>& closest, Vec2 p) const noexcept {
    if (closest.segment == Closest<Real>::none)
        return {};
    const IndexedSegment& segment = set_.segments[closest.segment];
    if constexpr (std::is_same_v<Real, double>)
        if (segment.is_longer_than(short_mm)) [[unlikely]]
            return answer_on_long(closest.segment, p);
    const WayToSegment<Real> way(segment, closest.parameter, p);
    Nearest nearest;
    nearest.distance = way.length();
    nearest.point = point_on(segment, closest.parameter);
    nearest.contour = contours_[static_cast<std::size_t>(set_.owners[closest.segment])];
    nearest.segment = set_.numbers[closest.segment];
    nearest.towards = way.vector();
    return nearest;
}

Nearest ContourIndex::answer_on_long(std::uint32_t segment, Vec2 p) const noexcept {
    const Foot<long double> foot(set_.segments[segment], p);
    return answer(Closest<long double>{foot.squared, foot.parameter, segment}, p);
}

Nearest ContourIndex::careful(Vec2 p, double reach) const noexcept {
    Closest<long double> closest;
    closest.squared = square_above<long double>(reach);
    tree_.search(set_, p, closest);
    const Nearest found = answer(closest, p);
    return found.distance <= reach ? found : Nearest{};
}

Nearest ContourIndex::from_tree(Vec2 p, double reach) const noexcept {
    if (!is_finite(p))
        return {};
    if (wide_)
        return careful(p, reach);
    Closest<double> closest;
    closest.squared = square_above<double>(reach);
    tree_.search(set_, p, closest);
    if (!(reach < double_suffices_mm || closest.squared < double_suffices_mm * double_suffices_mm))
        return careful(p, reach);
    const Nearest found = answer(closest, p);
    return found.distance <= reach ? found : Nearest{};
}

Nearest ContourIndex::nearest(Vec2 p) const noexcept {
    const CellGrid::Cell cell = grid_.at(p);
    if (cell.candidates.empty())
        return from_tree(p, std::numeric_limits<double>::infinity());
    return answer(closest_of(set_, cell.candidates, p), p);
}

Nearest ContourIndex::nearest_within(Vec2 p, double reach) const noexcept {
    const CellGrid::Cell cell = grid_.at(p);
    if (cell.beyond_band && reach <= band_)
        return {};
    if (cell.candidates.empty())
        return from_tree(p, reach);
    Nearest found = answer(closest_of(set_, cell.candidates, p), p);
    if (!(found.distance <= reach))
        found = Nearest{};
    return found;
}

std::size_t ContourIndex::bytes() const {
    return sizeof(*this) + set_.bytes() + tree_.bytes() + grid_.bytes() + contours_.capacity() * sizeof(int);
}

} // namespace tp
