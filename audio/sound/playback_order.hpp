// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/recording.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace tp {

/// A recording in a list that is played.
struct PlayItem {
    std::filesystem::path file;
    RecordingKind kind = RecordingKind::memo;
    std::optional<int> place; ///< where a person has put it in the order; empty: not re-ordered
    double gain_db = 0.0;     ///< evens out the loudness; keeps the true peak below full scale
    double resume_at_s = 0.0; ///< where it was left the last time
};

/// In the order in which they are heard: those that a person has put in order first, in that order; then
/// memo, person, place, story, ambient. What is equal stays as it was.
std::vector<PlayItem> playback_order(std::vector<PlayItem> items);

} // namespace tp
