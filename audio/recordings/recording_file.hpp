// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/recording_notes.hpp"
#include "audio/recordings/sound_format.hpp"
#include "audio/recordings/wav_part.hpp"
#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

namespace tp {

// A recording's life: `start_recording` makes the part, `finish_recording` makes the FLAC of it and then
// removes the part, `repair_folder` does the same for parts that a crash left. At every moment the part or
// the FLAC holds all that was synced. Every error is the end of a sentence.

/// A part in that folder, which is made where it is missing, named by its label.
Result<WavPart> start_recording(const std::filesystem::path& folder, const RecordingNotes& notes,
                                const SoundFormat& format = {});

/// The FLAC's place; nothing where not a frame had been recorded (the part is removed then too). On an error
/// the part stays, to be finished by `repair_folder` later.
Result<std::optional<std::filesystem::path>> finish_recording(WavPart part, const RecordingNotes& notes);

/// The same for a part that lies there, by who holds its lock. `notes` empty: those that the part carries.
Result<std::optional<std::filesystem::path>> finish_part(const std::filesystem::path& part,
                                                         const PartLock& lock,
                                                         const std::optional<RecordingNotes>& notes);

/// What a sound file says of itself.
struct RecordingAbout {
    RecordingNotes notes;
    SoundFormat format;
    std::uint64_t frames = 0; ///< as the file claims
    bool exact_length = true; ///< whether `frames` is more than an estimate, as it is in MP3
    bool flac = false;        ///< one that carries our comments, or may

    double seconds() const { return static_cast<double>(frames) / format.rate; }
};
Result<RecordingAbout> about_recording(const std::filesystem::path& file);

/// The comments of a sound file: all of a FLAC, speaker and date of another. An error only where the disk reports a fault.
Result<VorbisComments> comments_of(const std::filesystem::path& file);

/// Gives a FLAC file other notes; its sound and other programs' comments stay. The file is replaced as a
/// whole. The reason why not, else empty; "it was stopped." once a stop is asked for before all is copied.
std::string relabel_recording(const std::filesystem::path& file, const RecordingNotes& notes,
                              const std::stop_token& stop = {});

} // namespace tp
