// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/decode/picture_file.hpp"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

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

/// Decodes a bare PNG of this size to 8-bit BGR as it is stored, alpha dropped; `shrink` times smaller (1, 2, 4 or 8; sides
/// rounded up, areas averaged). It is shrunk row by row, so that all its pixels are never in memory at once, unless they are
/// interlaced. The caller has looked at the size.
Result<cv::Mat> decode_png(const Bytes& bare, cv::Size size, int shrink = 1);

} // namespace tp
