// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/base/face.hpp"

#include <string_view>

namespace tp {

/// What is felt of a face beside eyes, lips and outline. Nothing unless asked for: the paper found that more
/// features hinder a finger (Lim, Yoo, Choi 2019).
struct ExtraFeatures {
    bool brows = false, nose = false, irises = false;
};

/// From "brows,nose,irises" or some of these; an error names the word that is none of them.
Result<ExtraFeatures> extra_features_named(std::string_view words);

/// The extraction with the chosen ones of each face's extras among its contours, behind those it has. A
/// contour that is there already, placed by a person, stays as it is; one that a person took away stays away.
Extraction with_extras(Extraction extraction, const ExtraFeatures& chosen);

} // namespace tp
