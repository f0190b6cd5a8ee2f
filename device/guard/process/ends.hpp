// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace tp::guard {

/// What the process is started with: the device, and the program that pulls on it.
enum class End : std::uint8_t { device, program };

/// Takes both over from who started it. False where they are not there.
bool take_ends();

/// How many bytes came, 0 where none did within `wait_ms` (negative: however long that takes), −1 where the
/// end is gone.
int read_within(End end, std::span<std::uint8_t> into, int wait_ms);

/// All of it; false where the end is gone, refuses it or takes nothing for two seconds.
bool write_all(End end, std::span<const std::uint8_t> bytes);

} // namespace tp::guard
