// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/hand_path.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace tp {

std::vector<Vec2> hand_path(std::size_t count) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise;
    std::vector<Vec2> path;
    path.reserve(count);
    Vec2 place(10.0, 5.0);
    double heading = 0.3;
    double turn = 0.0;
    while (path.size() < count) {
        turn = 0.98 * turn + 0.004 * noise(random);
        heading += turn;
        const auto ahead = [&] {
            return place + hand_path_step_mm * Vec2(std::cos(heading), std::sin(heading));
        };
        if (std::max(std::abs(ahead().x), std::abs(ahead().y)) > hand_half_side_mm) {
            heading = std::atan2(-place.y, -place.x);
            turn = 0.0;
        }
        place = ahead();
        path.push_back(place);
    }
    return path;
}

} // namespace tp
