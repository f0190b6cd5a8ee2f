// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace tp {

/// A sheet to be printed on, upright.
struct Paper {
    const char* name; ///< as a shell names it
    double width_mm;
    double height_mm;
};

/// Braille paper is 11 × 11.5 inches, the longer side across.
inline constexpr std::array<Paper, 4> papers{{{"a4", 210.0, 297.0},
                                              {"letter", 215.9, 279.4},
                                              {"a3", 297.0, 420.0},
                                              {"braille", 292.1, 279.4}}};

/// By its name, upper or lower case.
std::optional<Paper> paper_named(std::string_view name);
/// Turned by a quarter.
inline Paper turned(const Paper& paper) { return {paper.name, paper.height_mm, paper.width_mm}; }

} // namespace tp
