// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as the file of the sticks' scales: none gives a stick a force that no stick
/// has. Empty where that holds, else what does not.
std::string complaint_about_joystick_scales(std::string_view bytes);

} // namespace tp::test
