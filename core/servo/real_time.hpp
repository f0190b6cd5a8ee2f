// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Real-time priority (SCHED_FIFO at `level`) for the calling thread, and a timer slack of 1 ns; without them
/// it still runs, only later. True where the priority was given.
bool prefer_real_time(int level) noexcept;

/// Keeps every page that the process has touched, or will touch, in memory, so that no tick waits for a disk.
/// True where the system allows it without a bound; where there is one, nothing is locked, because a process
/// at its bound could allocate no more.
bool lock_memory() noexcept;

} // namespace tp
