// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp {

/// The text without what XML 1.0 cannot hold: other control characters than tab and line ends, and what is
/// not UTF-8 (U+FFFD in its place).
std::string holdable(std::string_view text);

/// Written into XML between elements or in quotation marks, so that any reader gets the same text; what is
/// not holdable is left out.
std::string escaped(std::string_view text);

/// What a piece of XML says: the five named entities and numbers become characters, line ends one of a kind.
/// Other entities stay as they are written; what XML cannot hold, but some writer put there, is left out.
std::string unescaped(std::string_view xml);

} // namespace tp
