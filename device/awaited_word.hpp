// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

namespace tp {

/// Waits until `word` is not `seen` any more. Who changes it then wakes whoever waits; none is left asleep. On Windows by the
/// system's own call, because the std::atomic::wait of GCC 12's library can miss a wake-up there: it looks at the word before it
/// holds the lock under which it falls asleep.
void await_change(const std::atomic<std::uint32_t>& word, std::uint32_t seen) noexcept;
/// One of those that wait for it. Any thread, also from a signal handler: no lock, no allocation.
void wake_one(std::atomic<std::uint32_t>& word) noexcept;

} // namespace tp
