// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/nearest_method.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace tp {

namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 2, bg::cs::cartesian>;
using BoostSegment = bg::model::segment<BoostPoint>;

/// std::allocator that keeps the sum of what is held.
template <typename T>
struct CountingAllocator {
    using value_type = T;
    std::shared_ptr<std::size_t> held = std::make_shared<std::size_t>(0);

    CountingAllocator() = default;
    template <typename Other>
    CountingAllocator(const CountingAllocator<Other>& other) : held(other.held) {}
    T* allocate(std::size_t count) {
        *held += count * sizeof(T);
        return std::allocator<T>().allocate(count);
    }
    void deallocate(T* memory, std::size_t count) {
        *held -= count * sizeof(T);
        std::allocator<T>().deallocate(memory, count);
    }
    template <typename Other>
    bool operator==(const CountingAllocator<Other>& other) const {
        return held == other.held;
    }
};

std::vector<BoostSegment> boost_segments(const FlatScene& scene) {
    std::vector<BoostSegment> segments;
    for (const Polyline& line : scene.lines)
        for (std::size_t i = 0; i < line.segment_count(); ++i) {
            const Vec2 a = line.segment_start(i);
            const Vec2 b = line.segment_end(i);
            segments.emplace_back(BoostPoint(a.x, a.y), BoostPoint(b.x, b.y));
        }
    return segments;
}

class BoostRtree {
public:
    explicit BoostRtree(const FlatScene& scene)
        : tree_(boost_segments(scene), Parameters(), Indexable(), Equal(), allocator_) {}
    Nearest nearest(Vec2 place) const {
        BoostSegment found;
        tree_.query(bg::index::nearest(BoostPoint(place.x, place.y), 1), &found);
        return answer(place, found);
    }
    /// Of its two ways the faster one: where many segments lie in the box round the place, it looks for the
    /// nearest at any distance, elsewhere for the nearest of those that meet the box.
    Nearest nearest_within(Vec2 place, double reach) const {
        constexpr std::size_t many = 30'000;
        const BoostPoint point(place.x, place.y);
        BoostSegment found;
        if (tree_.size() > many) {
            tree_.query(bg::index::nearest(point, 1), &found);
        } else {
            const bg::model::box<BoostPoint> box(BoostPoint(place.x - reach, place.y - reach),
                                                 BoostPoint(place.x + reach, place.y + reach));
            if (tree_.query(bg::index::intersects(box) && bg::index::nearest(point, 1), &found) == 0)
                return {};
        }
        const Nearest nearest = answer(place, found);
        return nearest.distance <= reach ? nearest : Nearest{};
    }
    std::size_t bytes() const { return *allocator_.held; }

private:
    static Nearest answer(Vec2 place, const BoostSegment& found) {
        Nearest nearest;
        nearest.distance = bg::distance(BoostPoint(place.x, place.y), found);
        nearest.point = nearest_on_segment({found.first.get<0>(), found.first.get<1>()},
                                           {found.second.get<0>(), found.second.get<1>()}, place);
        return nearest;
    }

    using Parameters = bg::index::rstar<16>;
    using Indexable = bg::index::indexable<BoostSegment>;
    using Equal = bg::index::equal_to<BoostSegment>;
    using Allocator = CountingAllocator<BoostSegment>;

    Allocator allocator_;
    bg::index::rtree<BoostSegment, Parameters, Indexable, Equal, Allocator> tree_;
};

class BoostAnyDistance final : public LoopingMethod<BoostAnyDistance> {
public:
    explicit BoostAnyDistance(const FlatScene& scene) : tree_(scene) {}
    Nearest answer(Vec2 place) const { return tree_.nearest(place); }
    std::size_t bytes() const override { return tree_.bytes(); }

private:
    BoostRtree tree_;
};

class BoostWithinBand final : public LoopingMethod<BoostWithinBand> {
public:
    explicit BoostWithinBand(const FlatScene& scene) : tree_(scene) {}
    Nearest answer(Vec2 place) const { return tree_.nearest_within(place, reach()); }
    std::size_t bytes() const override { return tree_.bytes(); }
    double reach() const override { return ContourIndex::usual_band_mm; }

private:
    BoostRtree tree_;
};

} // namespace

std::unique_ptr<NearestMethod> make_boost_rtree(const FlatScene& scene, bool within_band) {
    if (within_band)
        return std::make_unique<BoostWithinBand>(scene);
    return std::make_unique<BoostAnyDistance>(scene);
}

} // namespace tp
