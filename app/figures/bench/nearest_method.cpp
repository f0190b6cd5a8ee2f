// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/nearest_method.hpp"

#include <limits>

namespace tp {

double NearestMethod::reach() const { return std::numeric_limits<double>::infinity(); }

std::string_view NearestMethod::query() const {
    return reach() < std::numeric_limits<double>::infinity() ? "band" : "any";
}

std::unique_ptr<NearestMethod> NearestMethod::make(std::string_view name, const FlatScene& scene) {
    if (name == "ours")
        return make_ours(scene, true);
    if (name == "ours_any_distance")
        return make_ours(scene, false);
    if (name == "boost_rtree")
        return make_boost_rtree(scene, true);
    if (name == "boost_rtree_any")
        return make_boost_rtree(scene, false);
    if (name == "nanoflann")
        return make_nanoflann(scene);
    if (name == "plain_loop")
        return make_plain_loop(scene);
    if (name == "published_scan")
        return make_published_scan(scene);
    if (name == "published_kdtree")
        return make_published_kdtree(scene);
    return nullptr;
}

} // namespace tp
