// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What does not hold for these bytes as an input report of a controller with Steam pads; empty where all is well.
std::string complaint_about_steam_report(std::string_view bytes);

} // namespace tp::test
