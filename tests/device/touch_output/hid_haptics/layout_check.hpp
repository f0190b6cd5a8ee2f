// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What does not hold for these bytes as the report descriptor of a device with haptics, for what it then says and for what it is
/// sent; empty where all is well. The first byte says how long the descriptor is, in fours; what is behind it is a report.
std::string complaint_about_haptics(std::string_view bytes);

} // namespace tp::test
