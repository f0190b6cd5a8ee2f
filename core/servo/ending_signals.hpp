// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// From now on `action` is done first when a signal is about to end this process, before what stood there has its turn. It may
/// do what a signal handler may. To be called once.
void on_ending_signals(void (*action)() noexcept) noexcept;

} // namespace tp
