// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What does not hold for these bytes, as they come from a board and as they go to one; empty where all is
/// well. What is taken is given back as it came; a board that got them pulls within its limit, and is brought
/// back into step.
std::string complaint_about_board_bytes(std::string_view bytes);

} // namespace tp::test
