// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/decode/picture_file.hpp"

namespace tp {

/// The size that a PNG's first chunk states, px. An error where the file ends before that or starts
/// otherwise.
struct PngSize {
    long long width = 0;
    long long height = 0;
};
Result<PngSize> png_size(const Bytes& bytes);

/// The same PNG with nothing but what its pixels need, and that proved by its checksums: libpng writes to the
/// terminal about damage, and about colour profiles, times and texts it dislikes. An error where the file
/// ends within a chunk or before its last one, or where a checksum is wrong.
Result<Bytes> bare_png(const Bytes& bytes);

} // namespace tp
