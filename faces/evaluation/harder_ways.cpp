// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/harder_ways.hpp"

#include "faces/evaluation/closed_eyes.hpp"
#include "faces/evaluation/opened_mouth.hpp"

namespace tp {

std::vector<Degraded> harder_ways(const cv::Mat& portrait, const std::vector<Contour>& truth, unsigned seed) {
    std::vector<Degraded> ways = degraded(portrait, truth, seed);
    for (const double openness : {0.1, 0.25, 0.5, 0.8})
        ways.push_back(with_opened_mouth(portrait, truth, openness, seed));
    for (const double shut : {0.5, 1.0})
        ways.push_back(with_closed_eyes(portrait, truth, shut, seed));
    return ways;
}

} // namespace tp
