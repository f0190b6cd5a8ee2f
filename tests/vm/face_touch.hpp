// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/polyline.hpp"
#include "core/guidance/scene.hpp"

#include <string>

namespace tp::vm {

/// The contours of a portrait (an SVG in pixels, as resources/samples has them) in the middle of what every
/// device reaches, the disc of 50 mm of a Falcon too: 80 × 80 mm.
Result<Scene> face_of(const std::string& svg_file);

/// A way past the whole face for a hand that misses every line by `beside` mm, on either side in turn: along
/// one contour after the other, mm.
Polyline way_beside(const Scene& face, double beside);

} // namespace tp::vm
