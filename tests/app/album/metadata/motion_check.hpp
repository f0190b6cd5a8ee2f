// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as a photograph: where a video is found in them it lies within them, not over
/// their beginning, and begins as an MP4 file does. Empty where all of that holds, else what does not.
std::string complaint_about_motion(std::string_view bytes);

} // namespace tp::test
