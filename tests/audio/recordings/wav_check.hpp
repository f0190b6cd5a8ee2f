// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as a WAV file that a crash left: it is refused with words, or the samples lie
/// within it and can be read. And as samples that were written behind our header, cut anywhere: they come
/// back exactly, and no more than are there. Empty where all of that holds, else what does not.
std::string complaint_about_wav(std::string_view bytes);

} // namespace tp::test
