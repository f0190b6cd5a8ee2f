// SPDX-License-Identifier: Apache-2.0
// For systems of which nobody has found out how: the servo runs, only later.
#include "core/servo/real_time.hpp"

namespace tp {

bool prefer_real_time(int) noexcept { return false; }

bool lock_memory(const void*, std::size_t) noexcept { return false; }

void forget_memory(const void*, std::size_t) noexcept {}

} // namespace tp
