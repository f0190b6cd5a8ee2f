// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/seen/seen_photo.hpp"

#include <string_view>

namespace tp {

/// As JSON has them: "perhaps_smiling", "dark_background".
std::string_view name_of(Mien mien);
std::string_view name_of(Eyes eyes);
std::string_view name_of(Facing facing);
std::string_view name_of(Nearness nearness);
std::string_view name_of(Light light);
std::string_view name_of(Colours colours);

} // namespace tp
