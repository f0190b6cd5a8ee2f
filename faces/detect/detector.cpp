// SPDX-License-Identifier: Apache-2.0
#include "faces/detect/detector.hpp"

#include <algorithm>

namespace tp {
namespace {

double intersection_over_union(const Rect& a, const Rect& b) {
    const double width = std::min(a.max.x, b.max.x) - std::max(a.min.x, b.min.x);
    const double height = std::min(a.max.y, b.max.y) - std::max(a.min.y, b.min.y);
    if (!(width > 0.0 && height > 0.0))
        return 0.0;
    const double common = width * height;
    return common / (a.width() * a.height() + b.width() * b.height() - common);
}

} // namespace

std::vector<Detection> without_doubles(std::vector<Detection> detections, double overlap) {
    std::stable_sort(detections.begin(), detections.end(),
                     [](const Detection& a, const Detection& b) { return a.score > b.score; });
    std::vector<Detection> kept;
    for (const Detection& candidate : detections)
        if (std::none_of(kept.begin(), kept.end(), [&](const Detection& other) {
                return intersection_over_union(candidate.box, other.box) > overlap;
            }))
            kept.push_back(candidate);
    return kept;
}

} // namespace tp
