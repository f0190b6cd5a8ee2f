// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/segment_tree.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace tp {

namespace {

/// A number to be sorted by, and what it stands for.
struct Keyed {
    std::uint64_t key;
    std::uint32_t segment;
};

/// Sorts by key; equal keys stay in their order (least significant digit first, 11 bits each).
void sort_by_key(std::span<Keyed> order) {
    constexpr std::size_t few = 512;
    if (order.size() < few) {
        std::stable_sort(order.begin(), order.end(),
                         [](const Keyed& l, const Keyed& r) { return l.key < r.key; });
        return;
    }
    constexpr int bits = 11;
    constexpr std::size_t digits = std::size_t(1) << bits;
    std::uint64_t any = 0, all = ~std::uint64_t(0);
    for (const Keyed& it : order) {
        any |= it.key;
        all &= it.key;
    }
    std::vector<Keyed> room(order.size());
    std::span<Keyed> from = order, to = room;
    for (int shift = 0; shift < 64; shift += bits) {
        if (((any ^ all) >> shift) % digits == 0)
            continue; // the same digit everywhere
        std::array<std::uint32_t, digits> begins{};
        for (const Keyed& it : from)
            ++begins[(it.key >> shift) % digits];
        std::uint32_t sum = 0;
        for (std::uint32_t& begin : begins)
            sum += std::exchange(begin, sum);
        for (const Keyed& it : from)
            to[begins[(it.key >> shift) % digits]++] = it;
        std::swap(from, to);
    }
    if (from.data() != order.data())
        std::copy(from.begin(), from.end(), order.begin());
}

/// How far `x` is from `low` to `high`, in 2³² steps; halves keep extents beyond 1e308 finite.
std::uint64_t in_steps(double x, double low, double high) {
    const double extent = 0.5 * high - 0.5 * low;
    const double share = (0.5 * x - 0.5 * low) / extent;
    return extent > 0.0 ? static_cast<std::uint64_t>(4294967295.0 * std::clamp(share, 0.0, 1.0)) : 0;
}

/// A Hilbert curve, four levels of quadrants at once: for each of its four orientations and 4 bits of x and y
/// the 8 bits of the place and the orientation within.
class HilbertSteps {
public:
    HilbertSteps() {
        for (std::uint32_t turned = 0; turned < 4; ++turned)
            for (std::uint32_t xy = 0; xy < 256; ++xy)
                steps_[turned * 256 + xy] = step(turned, xy >> 4, xy & 15u);
    }
    /// The place of the lattice point (x, y), both below 2^24.
    std::uint64_t place(std::uint32_t x, std::uint32_t y) const {
        std::uint64_t place = 0;
        std::uint32_t turned = 0;
        for (int shift = 20; shift >= 0; shift -= 4) {
            const std::uint16_t next =
                steps_[turned * 256 + (((x >> shift) & 15u) << 4) + ((y >> shift) & 15u)];
            place = (place << 8) | (next & 255u);
            turned = next >> 8;
        }
        return place;
    }

private:
    /// Bit 0 of an orientation swaps x and y, bit 1 mirrors both before.
    static std::uint16_t step(std::uint32_t turned, std::uint32_t x, std::uint32_t y) {
        std::uint32_t place = 0;
        for (int bit = 3; bit >= 0; --bit) {
            std::uint32_t right = (x >> bit) & 1u;
            std::uint32_t upper = (y >> bit) & 1u;
            if ((turned & 2u) != 0) {
                right ^= 1u;
                upper ^= 1u;
            }
            if ((turned & 1u) != 0)
                std::swap(right, upper);
            place = (place << 2) | ((right * 3u) ^ upper);
            if (upper == 0) // the lower right quadrant is mirrored, both lower ones are transposed
                turned ^= right != 0 ? 3u : 1u;
        }
        return static_cast<std::uint16_t>(turned << 8 | place);
    }

    std::array<std::uint16_t, 1024> steps_;
};

/// Half a coordinate's way into [min, max], as 24 bits; halves keep extents beyond 1e308 finite.
std::uint32_t lattice(double middle, double min, double extent) {
    if (!(extent > 0.0))
        return 0;
    return static_cast<std::uint32_t>(std::clamp((middle - min) / extent, 0.0, 1.0) * 16777215.0);
}
constexpr int place_bits = 48;

/// Long segments among short ones would widen every box that holds one of them, so they get boxes of their
/// own, behind all others. Long is more than 16 times the median, and than the way between segments spread
/// evenly; `half_extent` is half the width of all middles.
void put_long_ones_last(std::vector<Keyed>& order, const SegmentSet& set, double half_extent) {
    std::vector<double> lengths(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Vec2 along = glm::abs(set.segments[i].b - set.segments[i].a);
        lengths[i] = std::max(along.x, along.y);
    }
    const double spacing = 2.0 * half_extent / std::sqrt(static_cast<double>(order.size()));
    if (!(set.longest > 16.0 * spacing))
        return;
    const auto median = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), median, lengths.end());
    double longer = 16.0 * std::max(*median, spacing);
    for (std::uint64_t power = 1; power < 6 && longer < set.longest; ++power, longer *= 16.0)
        for (Keyed& it : order) {
            const Vec2 along = glm::abs(set.segments[it.segment].b - set.segments[it.segment].a);
            if (std::max(along.x, along.y) > longer)
                it.key += std::uint64_t(1) << place_bits;
        }
}

/// Orders the runs of segments that are longer than the way between them, such as the diameters of a circle,
/// by direction and by the distance from one another's lines rather than by their middles. A run is what
/// a node of the tree holds, and is halved along with the nodes below.
class OrderByDirection {
public:
    OrderByDirection(const SegmentSet& set, std::vector<Keyed>& order) : set_(set), order_(order) {
        sizes_.reserve(order.size());
        for (const Keyed& it : order) {
            const IndexedSegment& s = set.segments[it.segment];
            const Vec2 along = glm::abs(s.b - s.a);
            sizes_.push_back({0.5 * s.a + 0.5 * s.b, std::max(along.x, along.y)});
        }
    }

    void arrange() {
        std::size_t size = SegmentTree::segments_in_lowest_node;
        while (size < order_.size())
            size *= SegmentTree::fan_out;
        look_at(0, size);
    }

private:
    static constexpr std::size_t fewest = 64; ///< segments worth it
    /// Middles closer together than this many lengths make a run.
    static constexpr double close = 4.0;

    struct Size {
        Vec2 middle;   ///< mm
        double length; ///< mm, at least 0.7 of it
    };
    struct Leaning {
        Vec2 middle;   ///< mm
        double lean;   ///< its direction, -1 … 1 from straight down to straight up
        double length; ///< mm, at least 0.7 of it
    };

    void look_at(std::size_t first, std::size_t size);
    void arrange(std::size_t first, std::size_t size);
    void divide(std::size_t first, std::size_t size);
    template <typename Key>
    void order_by(std::size_t first, std::size_t end, std::size_t middle, Key key);

    const SegmentSet& set_;
    std::vector<Keyed>& order_;
    std::vector<Size> sizes_;      ///< one a segment, in the order so far
    std::vector<Leaning> leaning_; ///< of one run, in the order so far
    struct Placed {
        double key;
        std::uint32_t number; ///< in leaning_
    };
    std::vector<Placed> run_;
};

void OrderByDirection::look_at(std::size_t first, std::size_t size) {
    const std::size_t end = std::min(first + size, order_.size());
    if (end < first + fewest)
        return;
    Vec2 low = sizes_[first].middle;
    Vec2 high = low;
    double lengths = 0.0;
    for (std::size_t i = first; i < end; ++i) {
        low = glm::min(low, sizes_[i].middle);
        high = glm::max(high, sizes_[i].middle);
        lengths += sizes_[i].length;
    }
    if (close * lengths > std::max(high.x - low.x, high.y - low.y) * static_cast<double>(end - first))
        return arrange(first, size);
    for (std::size_t child = first; child < end; child += size / SegmentTree::fan_out)
        look_at(child, size / SegmentTree::fan_out);
}

void OrderByDirection::arrange(std::size_t first, std::size_t size) {
    const std::size_t end = std::min(first + size, order_.size());
    leaning_.clear();
    leaning_.reserve(end - first);
    run_.clear();
    run_.reserve(end - first);
    for (std::size_t i = first; i < end; ++i) {
        const IndexedSegment& s = set_.segments[order_[i].segment];
        const double x = 0.5 * s.b.x - 0.5 * s.a.x, y = 0.5 * s.b.y - 0.5 * s.a.y;
        const double sum = std::abs(x) + std::abs(y);
        run_.push_back({0.0, static_cast<std::uint32_t>(leaning_.size())});
        leaning_.push_back({sizes_[i].middle, sum > 0.0 ? y / sum : 0.0, sizes_[i].length});
    }
    divide(0, size);
    std::vector<Keyed> arranged;
    arranged.reserve(run_.size());
    for (const Placed& it : run_)
        arranged.push_back(order_[first + it.number]);
    std::copy(arranged.begin(), arranged.end(), order_.begin() + static_cast<std::ptrdiff_t>(first));
}

template <typename Key>
void OrderByDirection::order_by(std::size_t first, std::size_t end, std::size_t middle, Key key) {
    for (std::size_t i = first; i < end; ++i)
        run_[i].key = key(leaning_[run_[i].number]);
    const auto at = [&](std::size_t i) { return run_.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto before = [](const Placed& l, const Placed& r) {
        return std::tie(l.key, l.number) < std::tie(r.key, r.number);
    };
    if (middle < end) {
        std::nth_element(at(first), at(middle), at(end), before);
        return;
    }
    const auto is_first = [](const Placed& l, const Placed& r) { return l.number < r.number; };
    if (!std::is_sorted(at(first), at(end), is_first))
        std::sort(at(first), at(end), is_first);
    const auto [low, high] = std::minmax_element(
        at(first), at(end), [](const Placed& l, const Placed& r) { return l.key < r.key; });
    std::vector<Keyed> keyed;
    keyed.reserve(end - first);
    for (std::size_t i = first; i < end; ++i)
        keyed.push_back({in_steps(run_[i].key, low->key, high->key), run_[i].number});
    sort_by_key(keyed);
    for (std::size_t i = first; i < end; ++i)
        run_[i].number = keyed[i - first].segment;
}

/// Halves a run where it is widest: by the distance across the lines, along them, or by what their directions
/// make of it.
void OrderByDirection::divide(std::size_t first, std::size_t size) {
    const std::size_t end = std::min(first + size, run_.size());
    if (end <= first + SegmentTree::leaf_size)
        return;
    if (end <= first + size / 2)
        return divide(first, size / 2);
    Vec2 twice(0.0); // the sum of unit vectors at twice the angle of a direction, which has no sign
    double lengths = 0.0;
    for (std::size_t i = first; i < end; i += 1 + (end - first) / 64) {
        const double lean = leaning_[run_[i].number].lean;
        const Vec2 direction = glm::normalize(Vec2(1.0 - std::abs(lean), lean));
        twice += Vec2(direction.x * direction.x - direction.y * direction.y, 2.0 * direction.x * direction.y);
    }
    for (std::size_t i = first; i < end; ++i)
        lengths += leaning_[run_[i].number].length;
    const double length = lengths / static_cast<double>(end - first);
    const double angle = 0.5 * std::atan2(twice.y, twice.x);
    const Vec2 along(std::cos(angle), std::sin(angle));
    const double lean = along.y / (std::abs(along.x) + std::abs(along.y));
    const auto place_along = [&](const Leaning& it) { return glm::dot(along, it.middle); };
    const auto place_across = [&](const Leaning& it) { return cross(along, it.middle); };
    const auto direction = [&](const Leaning& it) {
        const double turn = it.lean - lean;
        return turn > 1.0 ? turn - 2.0 : turn < -1.0 ? turn + 2.0 : turn;
    };
    std::array<double, 3> low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t i = first; i < end; ++i) {
        const Leaning& it = leaning_[run_[i].number];
        const std::array<double, 3> here{place_along(it), place_across(it), direction(it)};
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], here[k]);
            high[k] = std::max(high[k], here[k]);
        }
    }
    const double lengthwise = std::max(0.0, high[0] - low[0] - length);
    const double across = high[1] - low[1];
    const double turned = length * (high[2] - low[2]);
    const double widest = std::max({lengthwise, across, turned});
    // Where one of them stays the widest down to the last leaf, one sorting does.
    const std::size_t full = (end - first) / SegmentTree::leaf_size;
    const auto leaves = static_cast<double>(full);
    const bool alone = widest > leaves * (lengthwise + across + turned - widest);
    const std::size_t middle = alone ? end : first + size / 2;
    if (turned == widest)
        order_by(first, end, middle, direction);
    else if (across == widest)
        order_by(first, end, middle, place_across);
    else
        order_by(first, end, middle, place_along);
    if (alone)
        return;
    divide(first, size / 2);
    divide(middle, size / 2);
}

/// Calls `visit` with every run of more than one equal key.
template <typename Visit>
void for_each_run(std::span<Keyed> order, Visit visit) {
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first + 1;
        while (end < order.size() && order[end].key == order[first].key)
            ++end;
        if (end - first > 1)
            visit(order.subspan(first, end - first));
        first = end;
    }
}

/// Orders segments by their ends from coordinate `axis` on, then by owner and number. Changes their keys.
void order_by_ends(std::span<Keyed> order, const SegmentSet& set, std::size_t axis) {
    const auto coordinates = [&](const Keyed& it) {
        const IndexedSegment& s = set.segments[it.segment];
        return std::array<double, 4>{s.a.x, s.a.y, s.b.x, s.b.y};
    };
    constexpr std::size_t few = 512;
    if (order.size() < few || axis == 4) {
        std::sort(order.begin(), order.end(), [&](const Keyed& l, const Keyed& r) {
            const auto left = coordinates(l), right = coordinates(r);
            if (left != right)
                return left < right;
            return std::tie(set.owners[l.segment], set.numbers[l.segment]) <
                   std::tie(set.owners[r.segment], set.numbers[r.segment]);
        });
        return;
    }
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Keyed& it : order) {
        low = std::min(low, coordinates(it)[axis]);
        high = std::max(high, coordinates(it)[axis]);
    }
    const bool is_equal = !(0.5 * high - 0.5 * low > 0.0);
    for (Keyed& it : order)
        it.key = in_steps(coordinates(it)[axis], low, high);
    if (!is_equal)
        sort_by_key(order);
    for_each_run(order, [&](std::span<Keyed> run) { order_by_ends(run, set, is_equal ? axis + 1 : axis); });
}

} // namespace

void sort_along_hilbert_curve(SegmentSet& set, Repeats repeats) {
    static const HilbertSteps hilbert;
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
    double extent = std::max(max.x - min.x, max.y - min.y);
    if (!(extent > 1e-12 * set.longest)) // all middles in one place, but for rounding
        extent = 0.0;
    std::vector<Keyed> order(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 middle = halfway(set.segments[i]);
        order[i] = {hilbert.place(lattice(middle.x, min.x, extent), lattice(middle.y, min.y, extent)), i};
    }
    put_long_ones_last(order, set, extent);
    sort_by_key(order);
    for_each_run(order, [&](std::span<Keyed> run) { order_by_ends(run, set, 0); });
    const auto is_same = [&](const Keyed& l, const Keyed& r) {
        const IndexedSegment& s = set.segments[l.segment];
        const IndexedSegment& t = set.segments[r.segment];
        return s.a == t.a && s.b == t.b;
    };
    if (repeats == Repeats::left_out)
        order.erase(std::unique(order.begin(), order.end(), is_same), order.end());
    OrderByDirection(set, order).arrange();

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
