// SPDX-License-Identifier: Apache-2.0
#include "app/photo/towns/nearest_town.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tp {

namespace {

constexpr double earth_km = 6371.0, near_km = 25.0, furthest_km = 100.0;
constexpr double km_a_degree = earth_km * std::numbers::pi / 180.0;

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// How far a town reaches: as a disc with 3 000 people on a square kilometre, which European and Asian towns have.
double reach_km(const Town& town) {
    constexpr double people_on_km2 = 3000.0;
    return std::max(std::sqrt(1000.0 * town.thousands / (std::numbers::pi * people_on_km2)), 2.0);
}

} // namespace

double distance_km(double latitude_a, double longitude_a, double latitude_b, double longitude_b) {
    const double up = std::sin(0.5 * radians(latitude_b - latitude_a));
    const double aside = std::sin(0.5 * radians(longitude_b - longitude_a));
    const double h = up * up + std::cos(radians(latitude_a)) * std::cos(radians(latitude_b)) * aside * aside;
    return 2.0 * earth_km * std::asin(std::min(std::sqrt(h), 1.0));
}

std::optional<NearTown> nearest_town(double latitude, double longitude, const std::vector<Town>& towns) {
    if (!(std::abs(latitude) <= 90.0) || !(std::abs(longitude) <= 180.0))
        return std::nullopt;
    std::optional<NearTown> nearest;
    double least = furthest_km;
    for (const Town& town : towns) {
        const double reach = reach_km(town);
        if (std::abs(town.latitude - latitude) * km_a_degree - reach >= least)
            continue;
        const double distance = distance_km(latitude, longitude, town.latitude, town.longitude);
        if (distance > furthest_km || distance - reach >= least)
            continue;
        least = distance - reach;
        const auto where = distance <= 1.5 * reach ? NearTown::Where::in
                           : distance <= near_km   ? NearTown::Where::near
                                                   : NearTown::Where::from;
        nearest = NearTown{&town, distance, where};
    }
    return nearest;
}

} // namespace tp
