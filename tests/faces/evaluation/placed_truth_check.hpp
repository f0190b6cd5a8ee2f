// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as a file of contours placed by hand: refused in a sentence, or photographs with five
/// contours each, of finite places. Empty where that holds, else what does not.
std::string complaint_about_placed_truth(std::string_view bytes);

} // namespace tp::test
