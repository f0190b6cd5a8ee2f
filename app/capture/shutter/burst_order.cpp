// SPDX-License-Identifier: Apache-2.0
#include "app/capture/shutter/burst_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace tp {

namespace {

/// What counts of a frame, as whole numbers of which the smaller is the better, the weightiest first.
using Worth = std::array<int, 5>;
constexpr std::array reasons{BurstReason::not_blurred, BurstReason::everybody, BurstReason::eyes_open,
                             BurstReason::sharper};

Worth worth_of(const std::vector<BurstLook>& looks, std::size_t frame, double finest, std::size_t wished) {
    const BurstLook& look = looks[frame];
    const double fine = finest > 0.0 ? look.fineness.value_or(0.0) / finest : 1.0;
    const int away = static_cast<int>(frame > wished ? frame - wished : wished - frame);
    return {fine < blurred_below ? 1 : 0, -look.faces, look.shut,
            -static_cast<int>(std::lround(fine / as_sharp)), away};
}

} // namespace

BurstOrder order_of(const std::vector<BurstLook>& looks, std::size_t wished) {
    double finest = 0.0;
    for (const BurstLook& look : looks)
        finest = std::max(finest, look.fineness.value_or(0.0));
    std::vector<Worth> worth;
    for (std::size_t frame = 0; frame < looks.size(); ++frame)
        worth.push_back(worth_of(looks, frame, finest, wished));
    BurstOrder order;
    order.frames.resize(looks.size());
    std::iota(order.frames.begin(), order.frames.end(), std::size_t{0});
    std::stable_sort(order.frames.begin(), order.frames.end(),
                     [&worth](std::size_t a, std::size_t b) { return worth[a] < worth[b]; });
    if (looks.size() < 2)
        return order;
    order.why = BurstReason::alike;
    const Worth& best = worth[order.frames[0]];
    const Worth& next = worth[order.frames[1]];
    for (std::size_t i = 0; i < reasons.size() && order.why == BurstReason::alike; ++i)
        if (best[i] != next[i])
            order.why = reasons[i];
    return order;
}

} // namespace tp
