// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp::guard {

inline constexpr int device_descriptor = 3;
inline constexpr int program_descriptor = 4;

} // namespace tp::guard
