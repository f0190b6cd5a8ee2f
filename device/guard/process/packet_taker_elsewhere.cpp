// SPDX-License-Identifier: Apache-2.0
#include "device/guard/process/force_taker.hpp"

namespace tp::guard {

std::unique_ptr<ForceTaker> packet_taker(std::uint8_t, Bytes) { return nullptr; }

} // namespace tp::guard
