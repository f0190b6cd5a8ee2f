// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSize>
#include <QVideoFrameFormat>

#include <opencv2/core/mat.hpp>

#include <span>
#include <vector>

namespace tp {

/// One plane of a picture as it lies in memory.
struct MappedPlane {
    std::span<const unsigned char> bytes; ///< all that may be read
    long long row_step = 0;               ///< bytes from one row to the next
};

/// A camera's picture as it lies in memory, and what is told of it. A camera may tell what is not so.
struct MappedPicture {
    QVideoFrameFormat::PixelFormat form = QVideoFrameFormat::Format_Invalid;
    QSize size; ///< px
    std::vector<MappedPlane> planes;
};

/// Pictures of this form become pixels.
bool is_read(QVideoFrameFormat::PixelFormat form);
/// A picture of this form and size can be one of a camera: at most `most_pixels`, with the even sides that its form needs.
bool can_be_read(QVideoFrameFormat::PixelFormat form, QSize size);

/// The picture as 8-bit BGR of the told size, in memory of its own. Empty where it cannot be read, or where its planes are too
/// short for what is told. A JPEG has the size of its own header, which cameras fill up to whole blocks, of at most
/// `most_pixels`; one that is damaged inside is shown as far as it goes, because cables lose bytes.
cv::Mat bgr_of(const MappedPicture& picture);

} // namespace tp
