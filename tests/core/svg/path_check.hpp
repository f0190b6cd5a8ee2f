// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any text as path data: it is refused with words, or what it draws is finite, joined and
/// no more than was allowed, and closes where it says so. Empty where all of that holds, else what does not.
std::string complaint_about_path(std::string_view path_data);

} // namespace tp::test
