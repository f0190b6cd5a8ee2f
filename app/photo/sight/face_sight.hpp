// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/seen/seen_photo.hpp"
#include "faces/base/face.hpp"

#include <optional>

namespace tp {

/// What is read off the contours of a face; percent of the distance between the outer corners of the eyes where no
/// other unit is said (core/study/expression_cues.hpp).
struct FaceMeasures {
    double mouth_width = 0.0, mouth_opening = 0.0;
    double corner_lift = 0.0;  ///< of the inner lips
    double smile = 0.0;        ///< log odds of smiling against neutral; 0: as likely
    double eye_openness = 0.0; ///< height to width of the wider opened eye
    /// −1 … 1: how much more of the face is seen beside its left eye than beside its right one; 0: frontal.
    double turn = 0.0;
    bool eyes_sure = false,
         mouth_sure = false; ///< nothing covers them, and their error is expected to be small
};

/// Nothing where contours are missing.
std::optional<FaceMeasures> measures_of(const Face& face);

Mien mien_of(const FaceMeasures& measures);
Eyes eyes_of(const FaceMeasures& measures);
Facing facing_of(const FaceMeasures& measures);

} // namespace tp
