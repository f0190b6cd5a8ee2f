// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/face.hpp"

/// Up to seven faces of any size and place, with eyes and mouths from shut to wide open, and now and then brows,
/// nose and irises; the same for the same seed.
tp::Extraction drawn_faces(unsigned seed);
/// One frontal face, 400 × 500 px.
tp::Extraction one_drawn_face();
