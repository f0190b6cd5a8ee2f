// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/scene/scene_builder.hpp"

#include <cstddef>
#include <vector>

namespace tp {

/// The features of a face as a tour takes them, as indices into `features`: the outline, which helps to find the rest,
/// then brows, eyes, irises and nose, then lips and mouth.
std::vector<int> tour_order(const std::vector<SceneFeature>& features, std::size_t face);

} // namespace tp
