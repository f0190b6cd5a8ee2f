// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as a sound file or a video: they are refused with the end of a sentence, or
/// give samples of a format that recordings have, no more at a time than were asked for. Empty where that
/// holds, else what does not.
std::string complaint_about_sound(std::string_view bytes);

} // namespace tp::test
