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

class BoostRtree final : public LoopingMethod<BoostRtree> {
public:
    explicit BoostRtree(const FlatScene& scene)
        : tree_(boost_segments(scene), Parameters(), Indexable(), Equal(), allocator_) {}
    Nearest answer(Vec2 place) const {
        const BoostPoint point(place.x, place.y);
        BoostSegment nearest;
        tree_.query(bg::index::nearest(point, 1), &nearest);
        return {bg::distance(point, nearest),
                nearest_on_segment({nearest.first.get<0>(), nearest.first.get<1>()},
                                   {nearest.second.get<0>(), nearest.second.get<1>()}, place)};
    }
    std::size_t bytes() const override { return *allocator_.held; }

private:
    using Parameters = bg::index::rstar<16>;
    using Indexable = bg::index::indexable<BoostSegment>;
    using Equal = bg::index::equal_to<BoostSegment>;
    using Allocator = CountingAllocator<BoostSegment>;

    Allocator allocator_;
    bg::index::rtree<BoostSegment, Parameters, Indexable, Equal, Allocator> tree_;
};

} // namespace

std::unique_ptr<NearestMethod> make_boost_rtree(const FlatScene& scene) {
    return std::make_unique<BoostRtree>(scene);
}

} // namespace tp
