// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/towns/town_list.hpp"

#include <optional>
#include <vector>

namespace tp {

/// How a place lies to a town.
struct NearTown {
    enum class Where { in, near, from };
    const Town* town = nullptr;
    double distance_km = 0.0; ///< from its middle
    Where where = Where::in;  ///< `from`: so far that the distance is worth saying
};

/// The town that a person would name for a place: the nearest one, where a large town reaches further than a small one;
/// none within 100 km, or a place that is none: nothing. Degrees, WGS 84. About 0.2 ms.
std::optional<NearTown> nearest_town(double latitude, double longitude,
                                     const std::vector<Town>& towns = all_towns());

/// On a sphere of 6371 km (haversine), degrees.
double distance_km(double latitude_a, double longitude_a, double latitude_b, double longitude_b);

} // namespace tp
