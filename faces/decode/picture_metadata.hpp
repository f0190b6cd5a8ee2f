// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/decode/picture_file.hpp"

#include <optional>

namespace tp {

/// What a picture's file says about it without any pixel being decoded.
struct PictureMetadata {
    std::optional<int> orientation; ///< EXIF, 1 … 8; none where none is stated or it makes no sense
    long long width = 0;            ///< px as stored; 0 where unknown
    long long height = 0;           ///< px
};

/// Never throws: metadata that cannot be read is metadata that is not there.
PictureMetadata metadata_of(const Bytes& bytes) noexcept;

} // namespace tp
