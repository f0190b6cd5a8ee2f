// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace tp {

/// What was seen on one frame of a burst.
struct BurstLook {
    int faces = 0; ///< whole ones, in the picture
    int shut = 0;  ///< of them, with both eyes shut
    std::optional<double>
        fineness; ///< of the worst face, or of the middle where nobody is (app/capture/seeing)
};

/// In what the frame that is kept is better than the next best.
enum class BurstReason {
    only,  ///< there is no other
    alike, ///< in nothing that matters
    not_blurred,
    everybody, ///< more faces are whole and in the picture
    eyes_open, ///< fewer eyes are shut
    sharper
};

/// Frames from the best to the worst, by their places in the burst.
struct BurstOrder {
    std::vector<std::size_t> frames;
    BurstReason why = BurstReason::only;
};

/// Of the finest frame of the burst; what is less fine is blurred: by a smear of three neighbours.
inline constexpr double blurred_below = 0.4;
/// Frames whose fineness differs by less are equally sharp.
inline constexpr double as_sharp = 0.05;

/// Better is, in this order: not blurred, everybody in, eyes open, sharper; where all are alike, nearest to `wished`, the frame of
/// the shutter. The same looks give the same order.
BurstOrder order_of(const std::vector<BurstLook>& looks, std::size_t wished);

} // namespace tp
