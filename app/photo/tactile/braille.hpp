// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// Braille for paper: base of a dot, and distances between centres, mm. Those of Marburg Medium, which European
/// standards took over; NLS Specification 800, 3.2 (United States and Canada) asks for nearly the same: 1.44,
/// 2.34, 6.2 and 10.
namespace braille {
inline constexpr double dot_diameter_mm = 1.5;
inline constexpr double dot_pitch_mm = 2.5;
inline constexpr double cell_pitch_mm = 6.0;
inline constexpr double line_pitch_mm = 10.0;
} // namespace braille

/// One cell: bit i is dot i + 1 (1 to 3 down the left side, 4 to 6 down the right); 0 is a blank.
using BrailleCell = std::uint8_t;

/// A text in uncontracted braille.
struct BrailleText {
    std::vector<BrailleCell> cells;
    int left_out = 0; ///< characters that have no braille in the table, emoji above all
};

/// Languages whose braille can be written: "en", "de", "ko".
std::vector<std::string> braille_languages();

/// UTF-8 text in the braille of `language`; Hangul in Korean braille where the language's own has none for it.
/// Control characters and repeated blanks are dropped. Empty text gives no cells. An error, a sentence, for a
/// language without a table, and where liblouis does not find the table on this machine. Any thread: liblouis
/// itself belongs to one at a time.
Result<BrailleText> braille_of(std::string_view text, const std::string& language);

/// The same cells as Unicode braille patterns, UTF-8; a line's end between lines.
std::string as_unicode(const std::vector<std::vector<BrailleCell>>& lines);

/// Cells broken into lines of at most `most` > 0 cells, between words where that is possible.
std::vector<std::vector<BrailleCell>> wrapped(const std::vector<BrailleCell>& cells, std::size_t most);

/// Width and height, mm, of lines of braille, dots and all; 0 × 0 for none.
Vec2 size_of(const std::vector<std::vector<BrailleCell>>& lines);
/// The dots' centres, y down, where the block's upper left corner is `corner`.
std::vector<Vec2> dots_of(const std::vector<std::vector<BrailleCell>>& lines, Vec2 corner);

} // namespace tp
