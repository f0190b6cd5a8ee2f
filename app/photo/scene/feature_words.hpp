// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp {

/// A contour's name as a person hears it: "left_eye" → "left eye", "outer_lip" → "lips",
/// "inner_lip" → "mouth opening", "outline" → "face outline", "face 2 left_eye" → "left eye of face 2".
/// Other names keep their words, with underscores as spaces.
std::string spoken_feature(std::string_view contour_name);

} // namespace tp
