// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What does not hold for these bytes as a stream of frames; empty where all is well. Each frame is tried as
/// it is and with its header and CRC made right, goes through every decoder, and into a pad that turns its
/// motors.
std::string complaint_about_frames(std::string_view bytes);

} // namespace tp::test
