// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/sound_stream.hpp"
#include "core/processes/message.hpp"

#include <memory>
#include <optional>

namespace tp {

/// Loads every library that decodes the sound of a video: afterwards no file is opened for that any more.
void load_video_decoders();

/// The helper's end of sound_of_video.hpp: decodes what it is handed.
class SoundService {
public:
    /// None where none is wanted.
    std::optional<Message> answer(MessageReader& question);

private:
    std::unique_ptr<SoundStream> sound_;
};

} // namespace tp
