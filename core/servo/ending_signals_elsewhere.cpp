// SPDX-License-Identifier: Apache-2.0
// Where nothing ends a program so.
#include "core/servo/ending_signals.hpp"

namespace tp {

void on_ending_signals(void (*)() noexcept) noexcept {}

} // namespace tp
