// SPDX-License-Identifier: Apache-2.0
#include "device/hid/field_slot.hpp"

#include <algorithm>

namespace tp::hid {

Slot slot_of(const Field& field, std::uint32_t index) {
    Slot slot;
    if (field.bit_size == 0 || field.bit_size > 32 || index >= field.count)
        return slot;
    slot.bit = field.bit_offset + index * field.bit_size;
    slot.size = static_cast<std::uint8_t>(field.bit_size);
    const bool negative = field.logical_min < 0;
    const std::int64_t most = (std::int64_t{1} << (slot.size - (negative ? 1 : 0))) - 1;
    const std::int64_t least = negative ? -most - 1 : 0;
    slot.least = std::max(field.logical_min, least);
    slot.most = std::min(field.logical_max, most);
    if (slot.most <= slot.least) {
        slot.least = least;
        slot.most = most;
    }
    return slot;
}

} // namespace tp::hid
