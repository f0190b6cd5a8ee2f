// SPDX-License-Identifier: Apache-2.0
// Compiled with what a target that depends on tp_geometry sees; must not compile.
#include "core/guidance/scene.hpp"

int main() { return static_cast<int>(tp::Scene{}.contours.size()); }
