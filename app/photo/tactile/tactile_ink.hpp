// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Colour of what is only to be read by eye. Swell paper rises where it is black; a light ink hardly does.
inline constexpr const char* title_ink = "#5aa0e6";

} // namespace tp
