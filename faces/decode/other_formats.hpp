// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/decode/picture_file.hpp"

#include <opencv2/core/mat.hpp>

namespace tp {

/// The pixels of a WebP, TIFF, BMP or JPEG 2000 file, 8-bit BGR, as they are stored (OpenCV turns a TIFF
/// by itself); empty where the bytes are damaged. OpenCV's decoders are loaded at the first call: with them
/// come a hundred libraries, 40 MB and a tenth of a second, for which a JPEG has no use. An error where they
/// are not on this machine.
Result<cv::Mat> decode_other_format(const Bytes& bytes);

/// Loads OpenCV's decoders now; false where they are not on this machine.
bool load_other_decoders();

} // namespace tp
