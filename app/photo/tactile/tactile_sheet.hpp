// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/tactile/braille.hpp"
#include "app/photo/tactile/paper.hpp"
#include "app/photo/tactile/spaced_lines.hpp"
#include "core/base/result.hpp"
#include "faces/base/face.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tp {

struct TactileOptions {
    Paper paper = papers[0];         ///< as it is to be held: `turned` for landscape
    std::optional<std::size_t> face; ///< index of the only face to be drawn; none: all of them
    std::vector<std::string> names;  ///< of the extraction's faces, in their order, UTF-8; empty: nobody named
    std::string language = "en";     ///< of the braille
    std::string title;               ///< in print, UTF-8; empty: none
};

/// A name in braille on a sheet.
struct TactileLabel {
    std::string name;
    std::vector<std::vector<BrailleCell>> lines;
    Vec2 corner{0.0}; ///< mm, upper left corner of the block
};

/// Faces as raised lines, with names in braille: everything in mm from the paper's upper left corner, y down.
struct TactileSheet {
    static constexpr double margin_mm = 10.0;
    static constexpr double feature_width_mm = 1.0;
    static constexpr double outline_width_mm = 1.5;
    static constexpr double mark_mm = 12.0; ///< legs of the cut corner
    static constexpr double title_mm = 4.5; ///< size of the title's letters

    double width_mm = 0.0, height_mm = 0.0;
    double mm_per_px = 0.0; ///< the scale: mm on paper per pixel of the photograph
    std::vector<TactileLine> lines;
    std::vector<TactileLabel> labels;
    std::string title;              ///< as it is printed, shortened where it is too long
    std::vector<std::string> notes; ///< sentences, translated: what was simplified or left out

    /// Where the title's letters begin, on their base line.
    Vec2 title_place() const { return {margin_mm, height_mm - margin_mm - 1.2}; }
};

/// Fits the subject onto the paper. The line across the upper right corner says which way the sheet is held, as
/// the cut corner of tactile graphics does. An error, a sentence, where there is no face or no such face, and
/// for a language without braille.
Result<TactileSheet> make_tactile_sheet(const Extraction& extraction, const TactileOptions& options);

} // namespace tp
