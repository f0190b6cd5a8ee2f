// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::svg {

/// The value of `property` in a `style` attribute, in small letters and without "!important"; empty where the
/// style does not set it. The last of several declarations holds.
std::string style_value(std::string_view style, std::string_view property);

} // namespace tp::svg
