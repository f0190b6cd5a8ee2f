// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

namespace tp {

/// The largest whole number by which both sides of a picture can be divided so that the longer one keeps
/// `longer` px or more; at least 1.
int block_factor(cv::Size picture, int longer);

/// The picture shrunk by that number, areas averaged; itself where it is 1. Averaging whole blocks is several
/// times faster than areas of any size.
cv::Mat shrunk_by_blocks(const cv::Mat& picture, int longer);

/// Width and height of a picture whose longer side is brought to `longer` px.
cv::Size size_with_longer_side(cv::Size picture, int longer);

/// A picture shrunk until its longer side measures `longer` px, of which only some rows are made at a time:
/// whole it would take 60 MB beside 50 megapixel. Blocks are averaged first, then areas with the weights of
/// cv::resize's INTER_AREA, so that the rows are those of the whole.
class ShrunkRows {
public:
    /// 8-bit BGR, the longer side at least `longer` > 0 px; the pixels must outlive this.
    ShrunkRows(const cv::Mat& picture, int longer);
    cv::Size size() const { return size_; }
    /// Rows [start, end) of the shrunk picture.
    cv::Mat rows(cv::Range wanted) const;

private:
    cv::Mat picture_;
    int factor_;         ///< px of the picture per block
    cv::Size in_blocks_; ///< of the picture
    cv::Size size_;
};

} // namespace tp
