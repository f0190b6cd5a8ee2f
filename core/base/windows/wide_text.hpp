// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::windows {

/// UTF-8 as what Windows calls wide, and back.
std::wstring wide(std::string_view text);
std::string narrow(std::wstring_view text);

} // namespace tp::windows
