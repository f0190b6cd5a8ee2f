// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/scene.hpp"

namespace tp {

/// The face scene that figures are compared on (DESIGN.md §4): eyes 28×10 mm, lips 44×16 and 36×2 mm, an
/// outline arc 130×170 mm, as curves.
Scene reference_face();

} // namespace tp
