// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/hid/report_bits.hpp"
#include "device/hid/report_descriptor.hpp"

#include <cstdint>

namespace tp::hid {

/// Where the value at `index` of a field lies; nowhere for one that the field does not have. A range that its bits cannot hold,
/// or that is none, is a mistake of the device: then the bits are the range.
Slot slot_of(const Field& field, std::uint32_t index);

} // namespace tp::hid
