// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/face.hpp"

#include <QString>

namespace tp {

/// What was found in a photograph and can be felt, as a person is told: "One face. Eyes, mouth and outline
/// can be felt.", followed by what is wrong with it, if anything.
QString describe(const Extraction& extraction);

} // namespace tp
