// SPDX-License-Identifier: Apache-2.0
// Compiled with what a target that depends on tp_geometry sees.
#include "core/geometry/contour.hpp"

int main() { return static_cast<int>(tp::Contour{}.pieces.size()); }
