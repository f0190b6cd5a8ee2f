// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/byte_source.hpp"
#include "audio/recordings/vorbis_comments.hpp"
#include "core/base/result.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// What stands in a FLAC file before its sound (RFC 9639, 8): where its metadata blocks lie, and the
/// comments. libsndfile has fixed names for a few comments only, so ours are read and written here.
struct FlacHead {
    struct Block {
        int type = 0;
        std::uint64_t body = 0; ///< where its content begins
        std::uint32_t size = 0; ///< bytes of its content
    };
    std::vector<Block> blocks;
    std::uint64_t frames = 0; ///< 0: it does not say, as it was written into a pipe
    VorbisComments comments;  ///< of the first block of comments; empty where there is none or it is damaged
    std::uint64_t sound_begin = 0; ///< the first byte after the blocks
};

/// Whether the file begins like a FLAC file, or like one with an ID3v2 tag before it.
bool is_flac(const ByteSource& file);

/// An error is the end of a sentence.
Result<FlacHead> flac_head(const ByteSource& file);

/// Takes bytes one after the other; says why it cannot, else empty.
using ByteSink = std::function<std::string(std::string_view)>;

/// Writes the file once more with other comments: the sound byte for byte, the other blocks as they were,
/// without padding and ID3 tags. The reason why not, else empty.
std::string write_with_comments(const ByteSource& file, const FlacHead& head, const VorbisComments& comments,
                                const ByteSink& to);

} // namespace tp
