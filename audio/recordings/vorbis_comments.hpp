// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// The comments of a FLAC or Ogg file, in their order: NAME=value, several of one name allowed (Xiph, "Ogg
/// Vorbis I format specification: comment field and header specification"). In FLAC they are the content of a
/// metadata block, without Vorbis' framing bit (RFC 9639, 8.6).
struct VorbisComments {
    struct Field {
        std::string name; ///< ASCII; case does not matter
        std::string value;

        bool operator==(const Field&) const = default;
    };
    std::string vendor; ///< the program that wrote the sound
    std::vector<Field> fields;

    bool operator==(const VorbisComments&) const = default;

    /// The first value of that name.
    std::optional<std::string> value(std::string_view name) const;
};

/// The most that a metadata block of FLAC holds, in bytes.
constexpr std::size_t most_comment_bytes = (1 << 24) - 1;

/// Fields without "=" or with a name that is not allowed are left out; what is damaged otherwise is an error
/// (the end of a sentence).
Result<VorbisComments> vorbis_comments(std::string_view block);

/// The block; an error (the end of a sentence) where it would be larger than `most_comment_bytes`.
Result<std::string> vorbis_comment_block(const VorbisComments& comments);

/// Whether two names of fields are the same, whatever their case.
bool same_field(std::string_view a, std::string_view b);

} // namespace tp
