// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <istream>
#include <string>

namespace tp {

/// As much as is kept of a line that somebody, or another program, types.
inline constexpr std::size_t most_line_bytes = 4096;

/// The next line, without its end; false where there is none. Of a longer one `line` holds one byte more than
/// `most_line_bytes`, and what follows is not read: it may never end.
bool next_line(std::istream& in, std::string& line);

} // namespace tp
