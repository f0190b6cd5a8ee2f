// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "core/base/result.hpp"

#include <QDateTime>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <optional>
#include <string>

namespace tp {

/// What a photograph's own file says of itself.
struct PhotographFacts {
    QDateTime taken;             ///< where it was taken, to the millisecond, with its offset
    std::string make{}, model{}; ///< of the device; empty: not known
    std::string software = "TouchPhoto";
    std::optional<Place> place{}; ///< only where the person chose that it is kept
};

/// Of 100; cameras write 90 to 95.
inline constexpr int photograph_quality = 92;

/// A picture as the bytes of a JPEG file (4:2:0) that says nothing of itself yet.
struct CodedPicture {
    std::string jpeg;
    cv::Size size;
};

/// Of an upright picture, 8-bit BGR. An error is the end of a sentence. 12 megapixel take about a tenth of a second.
Result<CodedPicture> coded_picture(const cv::Mat& picture);
/// Its pixels again, 8-bit BGR; empty where they cannot be had.
cv::Mat pixels_of(const CodedPicture& coded);

/// The same bytes with EXIF 2.31. An error is the end of a sentence.
Result<std::string> photograph_jpeg(const CodedPicture& coded, const PhotographFacts& facts);

} // namespace tp
