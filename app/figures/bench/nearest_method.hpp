// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/contour_index.hpp"

#include <array>
#include <memory>
#include <span>
#include <string_view>

namespace tp {

/// A way to the nearest place on the contours of a scene, built for one scene.
class NearestMethod {
public:
    virtual ~NearestMethod() = default;
    /// Asks for every place and returns the sum of the answers, so that none can be optimised away. The loop
    /// is the method's own: no method pays for a virtual call per question.
    virtual double ask(std::span<const Vec2> places) const = 0;
    /// One answer: distance (infinity where the method finds nothing) and the place it is to.
    virtual Nearest nearest(Vec2 place) const = 0;
    /// Memory held, bytes.
    virtual std::size_t bytes() const = 0;
    /// Farther away than this, mm, the method need not find anything.
    virtual double reach() const;
    /// What is asked: "band", whether there is something within `reach`, and if so where, or "any".
    std::string_view query() const;

    /// ours                ContourIndex, within the band of the default profile, as the servo asks at every tick
    /// ours_any_distance   ContourIndex without the bound
    /// boost_rtree         Boost.Geometry R-tree of segments, packed, nearest k = 1, within the same band
    /// boost_rtree_any     the same without the bound
    /// nanoflann           k-d tree of vertices: the nearest vertex, which is not the nearest point
    /// plain_loop          every segment, every time
    /// published_scan      the paper's Algorithm 1 as listed
    /// published_kdtree    the same with v1 and v2 from a k-d tree
    static constexpr std::array<std::string_view, 8> names{
        "ours",      "boost_rtree", "ours_any_distance", "boost_rtree_any",
        "nanoflann", "plain_loop",  "published_scan",    "published_kdtree"};
    /// One of `names`, built for `scene`, which need not outlive the call; null for another name.
    static std::unique_ptr<NearestMethod> make(std::string_view name, const FlatScene& scene);
};

std::unique_ptr<NearestMethod> make_ours(const FlatScene& scene, bool within_band);
std::unique_ptr<NearestMethod> make_boost_rtree(const FlatScene& scene, bool within_band);
std::unique_ptr<NearestMethod> make_nanoflann(const FlatScene& scene);
std::unique_ptr<NearestMethod> make_plain_loop(const FlatScene& scene);
std::unique_ptr<NearestMethod> make_published_scan(const FlatScene& scene);
std::unique_ptr<NearestMethod> make_published_kdtree(const FlatScene& scene);

/// What the methods have in common: `ask` as a loop over the method's own inlined `answer`, a Nearest.
template <typename Self>
class LoopingMethod : public NearestMethod {
public:
    double ask(std::span<const Vec2> places) const final {
        double sum = 0.0;
        for (const Vec2 place : places)
            sum += static_cast<const Self*>(this)->answer(place).distance;
        return sum;
    }
    Nearest nearest(Vec2 place) const final { return static_cast<const Self*>(this)->answer(place); }
};

} // namespace tp
