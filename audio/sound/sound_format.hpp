// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Everything that sounds or is recorded passes the room's ports at this rate, per second.
inline constexpr int sound_rate = 48000;

/// What is played is interleaved left, right. (What is recorded has one channel.)
inline constexpr int played_channels = 2;

} // namespace tp
