// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/recording_notes.hpp"
#include "audio/recordings/sound_stream.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace tp {

/// A sound file that became a recording.
struct ImportedSound {
    std::filesystem::path file;
    std::string warning; ///< a sentence where not all of it could be read; else empty
};

/// Stores a sound file as a FLAC in that folder, which is made where it is missing, with these notes and a
/// name by them. A sound FLAC is copied, its sound byte for byte; anything else that libsndfile reads is
/// encoded, without loss where it has integer samples of at most 24 bit. Other programs' comments in a FLAC
/// stay. `from` is only read. An error is the end of a sentence, and then there is no new file.
Result<ImportedSound> import_sound(const std::filesystem::path& from, const std::filesystem::path& folder,
                                   const RecordingNotes& notes);

/// The same for sound that is in no sound file. `open` begins it anew whenever it is called.
Result<ImportedSound> import_sound(const std::function<Result<std::unique_ptr<SoundStream>>()>& open,
                                   const std::filesystem::path& folder, const RecordingNotes& notes);

} // namespace tp
