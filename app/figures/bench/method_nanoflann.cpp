// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/nearest_method.hpp"
#include "core/guidance/published_law.hpp"

#include <nanoflann.hpp>

namespace tp {

namespace {

/// The vertices of a scene as nanoflann wants them.
struct Vertices {
    std::vector<Vec2> points;

    explicit Vertices(const FlatScene& scene) {
        for (const Polyline& line : scene.lines)
            points.insert(points.end(), line.points.begin(), line.points.end());
    }
    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const {
        return axis == 0 ? points[i].x : points[i].y;
    }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Vertices>, Vertices, 2>;

/// Builds the tree; returns what tree and vertices hold, bytes.
std::size_t built(Tree& tree, const Vertices& vertices) {
    tree.buildIndex();
    return tree.usedMemory(tree) + vertices.points.capacity() * sizeof(Vec2);
}

class NearestVertex final : public LoopingMethod<NearestVertex> {
public:
    explicit NearestVertex(const FlatScene& scene)
        : vertices_(scene), tree_(2, vertices_), bytes_(built(tree_, vertices_)) {}
    Nearest answer(Vec2 place) const {
        std::uint32_t nearest = 0;
        double squared = std::numeric_limits<double>::infinity();
        tree_.knnSearch(&place.x, 1, &nearest, &squared);
        return {std::sqrt(squared), vertices_.points[nearest]};
    }
    std::size_t bytes() const override { return bytes_; }

private:
    Vertices vertices_;
    Tree tree_;
    std::size_t bytes_;
};

/// The listing up to its distance: v1 and v2 from the tree, and the foot between them or v1. Of equally near
/// vertices the tree may take another than the scan.
class PublishedKdTree final : public LoopingMethod<PublishedKdTree> {
public:
    explicit PublishedKdTree(const FlatScene& scene)
        : vertices_(scene), tree_(2, vertices_), bytes_(built(tree_, vertices_)) {}
    Nearest answer(Vec2 place) const {
        std::uint32_t nearest[2] = {0, 0};
        double squared[2];
        if (tree_.knnSearch(&place.x, 2, nearest, squared) < 2)
            return {};
        const Vec2 foot = published_foot(vertices_.points[nearest[0]], vertices_.points[nearest[1]], place);
        return {length(foot - place), foot};
    }
    std::size_t bytes() const override { return bytes_; }

private:
    Vertices vertices_;
    Tree tree_;
    std::size_t bytes_;
};

} // namespace

std::unique_ptr<NearestMethod> make_nanoflann(const FlatScene& scene) {
    return std::make_unique<NearestVertex>(scene);
}

std::unique_ptr<NearestMethod> make_published_kdtree(const FlatScene& scene) {
    return std::make_unique<PublishedKdTree>(scene);
}

} // namespace tp
