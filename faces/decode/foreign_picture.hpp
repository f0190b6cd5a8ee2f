// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/processes/helper.hpp"
#include "faces/decode/picture.hpp"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <filesystem>

namespace tp {

/// `read_picture_to_fit`, decoded by one of these helpers: the same pixels. What ends a helper, or takes it
/// too long, is one sentence.
Result<cv::Mat> foreign_to_fit(HelperPool& helpers, const std::filesystem::path& file, cv::Size box);

/// `read_picture_shrunk`, in the same way. The helper is this picture's until `whole` is destroyed.
Result<ShrunkPicture> foreign_shrunk(HelperPool& helpers, const std::filesystem::path& file, int longest_px);

} // namespace tp
