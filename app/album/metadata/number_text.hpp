// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tp {

/// A finite number as a text that is read back as the same number, and the other way round. Any locale.
std::string number_text(double number);
std::optional<double> number_from(std::string_view text);

} // namespace tp
