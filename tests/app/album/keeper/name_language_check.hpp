// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as the file of a name's language: they are refused with the end of a
/// sentence, or they give a tag and a person that, written, are read back as they were. Empty where that
/// holds, else what does not.
std::string complaint_about_name_language(std::string_view bytes);

} // namespace tp::test
