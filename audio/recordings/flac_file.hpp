// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/byte_source.hpp"
#include "audio/recordings/sound_stream.hpp"
#include "audio/recordings/vorbis_comments.hpp"
#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace tp {

/// What is done with a sound that ends before it should.
enum class Incomplete { refused, stored };

/// Stores the sound as a FLAC file that only its owner may read: encodes it, decodes it again and compares,
/// then brings it to the disk and gives it its name, which must be free. How many frames it has; an error is
/// the end of a sentence, and then there is no file.
Result<std::uint64_t> store_flac(SoundStream& sound, const VorbisComments& comments,
                                 const std::filesystem::path& place,
                                 Incomplete incomplete = Incomplete::refused);

/// Stores a copy of a FLAC file with other comments, the sound byte for byte; the name must be free. The
/// reason why not, else empty.
std::string store_flac_copy(const ByteSource& flac, const VorbisComments& comments,
                            const std::filesystem::path& place);

/// The fingerprint of what is left of the sound.
SoundFingerprint fingerprint_of(SoundStream& sound);

/// Samples that are read or written at a time.
constexpr std::size_t sound_block = 1 << 15;

} // namespace tp
