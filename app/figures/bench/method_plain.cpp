// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/nearest_method.hpp"
#include "core/guidance/published_law.hpp"

#include <limits>

namespace tp {

namespace {

class PlainLoop final : public LoopingMethod<PlainLoop> {
public:
    explicit PlainLoop(const FlatScene& scene) {
        for (const Polyline& line : scene.lines)
            for (std::size_t i = 0; i < line.segment_count(); ++i)
                segments_.push_back({line.segment_start(i), line.segment_end(i)});
    }
    Nearest answer(Vec2 place) const {
        double best = std::numeric_limits<double>::infinity();
        Vec2 towards(0.0);
        for (const Segment& segment : segments_) {
            const Vec2 along = segment.b - segment.a;
            const Vec2 to_place = place - segment.a;
            const double squared = glm::dot(along, along);
            const double way = squared > 0.0 ? glm::dot(to_place, along) / squared : 0.0;
            const Vec2 away = to_place - std::min(1.0, std::max(0.0, way)) * along;
            const double here = glm::dot(away, away);
            towards = here < best ? away : towards;
            best = std::min(best, here);
        }
        return {std::sqrt(best), place - towards};
    }
    std::size_t bytes() const override { return segments_.capacity() * sizeof(Segment); }

private:
    struct Segment {
        Vec2 a, b;
    };
    std::vector<Segment> segments_;
};

/// As it is listed, with nothing passed over.
class PublishedScan final : public LoopingMethod<PublishedScan> {
public:
    explicit PublishedScan(const FlatScene& scene)
        : law_(scene, TentProfile{}, std::numeric_limits<std::size_t>::max()) {
        for (const Polyline& line : scene.lines)
            vertices_ += line.points.size();
    }
    Nearest answer(Vec2 place) const {
        const Guidance guidance = law_.at(place);
        return {guidance.distance, guidance.nearest};
    }
    std::size_t bytes() const override { return vertices_ * (sizeof(Vec2) + sizeof(int)); }

private:
    PublishedLaw law_;
    std::size_t vertices_ = 0;
};

} // namespace

std::unique_ptr<NearestMethod> make_plain_loop(const FlatScene& scene) {
    return std::make_unique<PlainLoop>(scene);
}

std::unique_ptr<NearestMethod> make_published_scan(const FlatScene& scene) {
    return std::make_unique<PublishedScan>(scene);
}

} // namespace tp
