// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/video/film_stream.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <memory>

namespace tp {

/// The pictures of a video file (VideoFilm says of which). Decoded by a helper where this program has some, and else by itself.
/// An error is the end of a sentence; where there is none, there is a picture.
Result<std::unique_ptr<FilmStream>> film_of_video(const std::filesystem::path& file);

} // namespace tp
