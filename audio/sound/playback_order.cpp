// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/playback_order.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tp {

std::vector<PlayItem> playback_order(std::vector<PlayItem> items) {
    std::ranges::stable_sort(items, {}, [](const PlayItem& item) {
        return std::pair(item.place.has_value() ? static_cast<long>(*item.place)
                                                : std::numeric_limits<long>::max(),
                         item.place.has_value() ? RecordingKind::memo : item.kind);
    });
    return items;
}

} // namespace tp
