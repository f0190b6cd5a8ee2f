// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace tp {

/// The program's own experiments (resources/studies), in the order in which they are offered: the first has number 1.
inline constexpr std::array<std::string_view, 5> own_experiments{"tracking", "primitives", "expressions",
                                                                 "laws-tracking", "laws-expressions"};

/// The text of one, by its name or its number; nothing where there is none.
std::optional<std::string> own_experiment(std::string_view name);

} // namespace tp
