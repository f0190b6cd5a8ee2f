// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for the faces looked for in any 8-bit BGR picture: the size is that of the picture as it
/// was turned, every face has finite contours near it, and what is wrong is a sentence. Empty where that
/// holds.
std::string complaint_about_search_in(const cv::Mat& picture);

/// What must hold for any bytes taken as a photograph: refused in a sentence, or decoded to a picture in
/// which faces are looked for (in one of eight); every face has finite contours near the picture, and what is
/// wrong is a sentence. Empty where all of that holds, else what does not. The fuzzer's and the hostile
/// test's one entry.
std::string complaint_about_picture(std::string_view bytes);

} // namespace tp::test
