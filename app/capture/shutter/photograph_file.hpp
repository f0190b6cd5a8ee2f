// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "core/base/result.hpp"

#include <QDateTime>

#include <opencv2/core/mat.hpp>

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

/// An upright picture, 8-bit BGR, as the bytes of a JPEG file (4:2:0) with EXIF 2.31. An error is the end of a sentence. 12 megapixel
/// take about a tenth of a second.
Result<std::string> photograph_jpeg(const cv::Mat& picture, const PhotographFacts& facts);

} // namespace tp
