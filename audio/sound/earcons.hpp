// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// A short sound that stands for something that happened. What begins, rises; what ends, falls.
enum class Earcon {
    program_start,
    ready,
    face_entered,
    face_left,
    contour_crossed, ///< a tick; the only one that comes many times a second
    next,
    previous,
    list_end,
    recording_started,
    recording_stopped,
    saved,
    deleted,
    undone,
    error, ///< what was asked for is not possible
    fault, ///< safety: the force is off, a device is lost
};

inline constexpr std::array every_earcon{Earcon::program_start,
                                         Earcon::ready,
                                         Earcon::face_entered,
                                         Earcon::face_left,
                                         Earcon::contour_crossed,
                                         Earcon::next,
                                         Earcon::previous,
                                         Earcon::list_end,
                                         Earcon::recording_started,
                                         Earcon::recording_stopped,
                                         Earcon::saved,
                                         Earcon::deleted,
                                         Earcon::undone,
                                         Earcon::error,
                                         Earcon::fault};

/// "face_entered"
std::string_view name_of(Earcon earcon);

/// The sound, one channel, `sound_rate` a second: at most 300 ms, peak −12 dBFS, first and last sample zero,
/// its tones between 300 and 3000 Hz, where older ears hear. Rendered at the first call; any thread.
std::span<const float> samples_of(Earcon earcon);

} // namespace tp
