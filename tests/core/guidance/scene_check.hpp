// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any text that is read as a scene and made ready to be felt: index and brute force
/// agree, in any order of the contours; every force of every law is finite and within its bound; corners,
/// gaps and thinned contours are finite. Empty where all of that holds, or where the text is no scene; else
/// what does not. The fuzzer's and the hostile test's one entry.
std::string complaint_about_scene(std::string_view svg);

} // namespace tp::test
