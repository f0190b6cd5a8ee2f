// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/decode/picture.hpp"
#include "faces/decode/picture_file.hpp"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace tp {

/// The picture that these bytes are, upright, decoded in this process, and as small as it fits into `box`;
/// picture.hpp says what else holds.
Result<cv::Mat> decoded_to_fit(const Bytes& bytes, cv::Size box, double largest_px = largest_picture_px);

/// The same with fewer pixels (`read_picture_shrunk`). `whole` is there only where those that were decoded
/// are kept for it.
Result<ShrunkPicture> decoded_shrunk(const Bytes& bytes, int longest_px);

/// What is said where there is not enough memory.
Error no_memory();

} // namespace tp
