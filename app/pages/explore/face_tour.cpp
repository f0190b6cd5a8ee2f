// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/face_tour.hpp"

#include "faces/base/face.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace tp {

namespace {

std::ptrdiff_t place_on_tour(std::string_view name) {
    static constexpr std::array<std::string_view, 10> order{
        feature::outline,   feature::left_brow,  feature::right_brow, feature::left_eye,  feature::right_eye,
        feature::left_iris, feature::right_iris, feature::nose,       feature::outer_lip, feature::inner_lip};
    return std::distance(order.begin(), std::ranges::find(order, name));
}

} // namespace

std::vector<int> tour_order(const std::vector<SceneFeature>& features, std::size_t face) {
    std::vector<int> order;
    for (std::size_t i = 0; i < features.size(); ++i)
        if (features[i].face == face)
            order.push_back(static_cast<int>(i));
    std::ranges::stable_sort(order, {}, [&](int i) { return place_on_tour(features[static_cast<std::size_t>(i)].name); });
    return order;
}

} // namespace tp
