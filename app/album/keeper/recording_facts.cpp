// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/recording_facts.hpp"

#include "audio/recordings/loudness.hpp"
#include "audio/recordings/recording_file.hpp"
#include "core/files/file_words.hpp"

namespace tp {

Result<Tag> recording_facts(const std::filesystem::path& recording) {
    const auto about = about_recording(recording);
    if (!about)
        return Error{"The recording " + quoted(recording) + " cannot be used: " + about.error()};
    const auto loudness = loudness_of(recording);
    if (!loudness)
        return Error{"The recording " + quoted(recording) + " cannot be used: " + loudness.error()};
    return Tag{recording.filename().string(), about->notes.label, about->seconds(), loudness->gain_db(), 0};
}

} // namespace tp
