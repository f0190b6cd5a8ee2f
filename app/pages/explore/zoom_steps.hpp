// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/scene/scene_builder.hpp"

#include <optional>

namespace tp {

/// One step in, from what fills the surface now: all faces, then the face `here` (index; the one under the finger),
/// its eyes, its mouth, and all faces again. With one face it is its own beginning; a part that was not found is
/// left out.
Subject zoomed_in(const Extraction& extraction, const Subject& now, std::size_t here);

/// One step out: from an eye to both, from a part to its face, from a face to all of them; none at the outermost.
std::optional<Subject> zoomed_out(const Extraction& extraction, const Subject& now);

/// To what a finger is on: from all faces to that face, from a face to eyes or mouth, from both eyes to one; none
/// where there is nothing nearer.
std::optional<Subject> zoomed_to(const Extraction& extraction, const Subject& now, const SceneFeature& there);

} // namespace tp
