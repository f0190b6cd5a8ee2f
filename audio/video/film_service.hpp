// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/video/film_messages.hpp"
#include "audio/video/film_stream.hpp"
#include "core/processes/message.hpp"

#include <memory>
#include <optional>

namespace tp {

/// The helper's end of film_of_video.hpp: decodes what it is handed. Its libraries: `load_video_decoders`.
class FilmService {
public:
    /// None where none is wanted.
    std::optional<Message> answer(MessageReader& question);

private:
    std::unique_ptr<FilmStream> film_;
    FilmTray tray_;
};

} // namespace tp
