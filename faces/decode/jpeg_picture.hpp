// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/decode/picture_file.hpp"

#include <opencv2/core/mat.hpp>

namespace tp {

/// What stands before a JPEG's first scan.
struct JpegHeader {
    int width = 0;        ///< px; 0 where the file ends before it says so
    int height = 0;       ///< px
    bool adobe = false;   ///< written by Adobe's rules: CMYK values are stored inverted
    std::size_t scan = 0; ///< where the first scan begins; 0 where there is none
};
JpegHeader jpeg_header(const Bytes& bytes);

/// What becomes of a JPEG that ends too soon, or is damaged, after its first scan has begun.
enum class JpegDamage {
    refused,
    shown ///< grey or wrong from there on, as any viewer shows it
};

/// Decodes a JPEG to 8-bit BGR as it is stored, grey and CMYK included; `shrink` times smaller (1, 2, 4 or 8; sides
/// rounded up), which costs less, because fewer coefficients of each block are transformed (libjpeg's scaled inverse
/// DCT). Harmless oddities are ignored; a file that is cut short or damaged is an error, unless damage is `shown`; one
/// of more than 100 scans always is. The caller has looked at the size.
Result<cv::Mat> decode_jpeg(const Bytes& bytes, const JpegHeader& header, int shrink = 1,
                            JpegDamage damage = JpegDamage::refused);

} // namespace tp
