// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_contour.hpp"
#include "core/svg/contour_sheet.hpp"
#include "faces/base/face.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tp {

/// One feature of a face, there or not.
struct MendFeature {
    std::string name;                 ///< as in `feature`
    std::optional<MendContour> line;  ///< px; none: the face has it not
    std::optional<MendContour> found; ///< as the program found it; none: it did not
    bool found_felt = false;          ///< whether that is felt without anybody's doing, or was one of the extras
    bool mended = false;              ///< a person placed it, or took it away
};

struct MendFace {
    Rect box; ///< px, the head
    std::vector<MendFeature> features;
};

/// The faces of a photograph as a person mends them, all places in pixels of the upright picture.
struct MendWork {
    double width = 0.0, height = 0.0; ///< px
    std::vector<MendFace> faces;
};

/// What can be mended: of every face its eyes, lips and outline, be they there or not, and what else it has or
/// the program found beside them. `corrected` is `found` with the corrections that there are.
MendWork work_on(const Extraction& found, const Extraction& corrected);

/// What a person changed, as `corrected` reads it: only contours that were placed, and "NAME removed", a dot
/// where it was, for those that were taken away.
ContourSheet sheet_of(const MendWork& work);

/// The faces as they would be felt.
std::vector<Face> faces_of(const MendWork& work);

/// A contour to begin with for a feature that was not found: from its counterpart on the other side of the
/// face where that is there, else where such a feature usually lies in a head of that size.
MendContour template_for(const MendFace& face, const std::string& name);

/// A face of usual shape, `height` px high, about `centre`.
MendFace usual_face(Vec2 centre, double height);

} // namespace tp
