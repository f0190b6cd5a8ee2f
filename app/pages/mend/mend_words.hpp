// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/report/field_difference.hpp"
#include "app/pages/mend/mend_contour.hpp"

#include <QString>

#include <cstddef>
#include <optional>
#include <string>

namespace tp {

/// A feature as a person reads and hears it, "left eye"; with `face` ≥ 0 "left eye of face 1".
QString feature_words(const std::string& name, int face = -1);
/// "Corner 3 of 16".
QString node_words(const MendContour& contour, std::size_t node);
/// "412 across, 308.5 down", in pixels of the photograph.
QString place_words(Vec2 place);
/// How much what is felt changed, in a sentence; empty where nothing can be said.
QString change_words(const std::optional<FieldDifference>& difference);

} // namespace tp
