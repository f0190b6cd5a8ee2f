// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/report/field_difference.hpp"
#include "app/pages/mend/mend_work.hpp"

#include <QImage>
#include <QRectF>

#include <optional>

namespace tp {

/// The force field of contours as they are now, and how differently it feels from those found by the program.
struct FeltChange {
    QImage field;                              ///< transparent where there is no force; null where there is nothing to feel
    QRectF place;                              ///< of `field` in the photograph, px
    std::optional<FieldDifference> difference; ///< none where one of both has nothing to feel
};

/// On the surface of the Explore page, into which all faces are fitted as `before` has them (as `now` has them
/// where that has none), so that the picture stays in place while a line is moved.
FeltChange felt_change(const std::vector<Face>& before, const std::vector<Face>& now);

/// The faces as the program found them, without what a person did.
std::vector<Face> found_faces(const MendWork& work);

} // namespace tp
