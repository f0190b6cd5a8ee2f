// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/sound_stream.hpp"
#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace tp {

/// The sound of the video that is `size` bytes of a file from `begin` on (VideoSound says of which videos).
/// Decoded by a helper where this program has some, and else by itself. An error is the end of a sentence.
/// Where decoding breaks off, the sound ends.
Result<std::unique_ptr<SoundStream>> sound_of_video(const std::filesystem::path& file, std::uint64_t begin,
                                                    std::uint64_t size);

} // namespace tp
