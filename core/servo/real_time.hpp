// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace tp {

/// Real-time priority (SCHED_FIFO at `level`) for the calling thread, and a timer slack of 1 ns; without them
/// it still runs, only later: where the priority is refused, Linux since 6.12 lets it on sooner than who computes for
/// longer. True where the priority was given.
bool prefer_real_time(int level) noexcept;

/// Keeps `size` bytes from `data` on and what the calling thread may use of its stack (64 KiB) in memory, so
/// that no tick waits for a disk; until forget_memory and the end of the thread. True where the system allows
/// it. Not the whole process: a library that gives pages back and expects them empty, as QML's does, would
/// find them full.
bool lock_memory(const void* data, std::size_t size) noexcept;
/// Undoes that for the bytes.
void forget_memory(const void* data, std::size_t size) noexcept;

} // namespace tp
