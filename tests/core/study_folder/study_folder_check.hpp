// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as a finger's path, packed: refused with one sentence, or the same again after it was written.
/// Empty where that holds, else what does not.
std::string complaint_about_path(std::string_view gzip);
/// The same for any text as its unpacked lines.
std::string complaint_about_path_text(std::string_view csv);
/// The same for any text as the terms of a study, and as its table of sittings.
std::string complaint_about_terms(std::string_view text);

} // namespace tp::test
