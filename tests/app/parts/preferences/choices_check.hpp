// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as a person's preferences: each choice is one that there is, and written they
/// are read back as they were. Empty where that holds, else what does not.
std::string complaint_about_choices(std::string_view bytes);

} // namespace tp::test
