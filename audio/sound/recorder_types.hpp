// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/recording_notes.hpp"

#include <QString>

#include <filesystem>

namespace tp {

/// What is to be recorded.
struct RecordingPlan {
    std::filesystem::path folder; ///< made where it is missing
    RecordingNotes notes;
    double longest_s = 3 * 3600.0; ///< > 0; it ends by itself then
};

/// What was recorded, and lies on the disk.
struct FinishedRecording {
    std::filesystem::path file; ///< FLAC
    double duration_s = 0.0;
    double gain_db = 0.0; ///< evens out its loudness when it is played
    QString sentence;     ///< for the listener
};

/// idle → waiting → recording ⇄ paused → finishing → idle; from recording back to waiting where the
/// microphone goes away.
enum class RecorderState {
    idle,
    waiting, ///< for the microphone's first sound
    recording,
    paused,
    finishing, ///< the file is being made
};

} // namespace tp
