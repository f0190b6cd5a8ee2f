// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/scene.hpp"

namespace tp {

FlatScene flatten(const Scene& scene, const FlattenTolerance& tolerance) {
    FlatScene flat;
    for (const Contour& contour : scene.contours) {
        flat.names.push_back(contour.name);
        flat.lines.push_back(flatten(contour, tolerance));
    }
    return flat;
}

} // namespace tp
