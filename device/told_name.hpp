// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp {

/// What the kernel writes of a device, without what is no printable letter of ASCII, and not longer than a person listens to.
std::string told_name(std::string_view text);

} // namespace tp
