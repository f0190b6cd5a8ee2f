// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes taken as a photograph: refused in a sentence, or decoded to a picture in
/// which faces are looked for (in one of eight); every face has finite contours near the picture, and what is
/// wrong is a sentence. Empty where all of that holds, else what does not. The fuzzer's and the hostile
/// test's one entry.
std::string complaint_about_picture(std::string_view bytes);

} // namespace tp::test
