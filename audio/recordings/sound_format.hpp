// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tp {

/// How sound lies in a file. A frame is one sample for each channel.
struct SoundFormat {
    int rate = 48'000; ///< frames a second
    int channels = 1;

    bool operator==(const SoundFormat&) const = default;
};

/// Longest recording that is made or taken in, in seconds: a day. Also what keeps a hostile file, which may
/// claim to last for ages, from filling the disk.
constexpr std::uint64_t longest_recording_s = std::uint64_t{24} * 60 * 60;

} // namespace tp
