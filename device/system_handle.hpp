// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tp {

/// What the system calls an open device or file by: a descriptor, on Windows a HANDLE.
using SystemHandle = std::intptr_t;
inline constexpr SystemHandle no_handle = -1; ///< INVALID_HANDLE_VALUE too

} // namespace tp
