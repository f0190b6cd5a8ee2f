// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/tactile/tactile_sheet.hpp"

#include <filesystem>
#include <string>

namespace tp {

/// The sheet as SVG text in mm, for Inkscape and other drawing programs: lines are strokes, dots are circles.
std::string tactile_svg(const TactileSheet& sheet);

/// The sheet as the bytes of a PDF file, the same ones for the same sheet at any time. What is drawn is exact; the
/// page's own size is rounded to whole points (0.35 mm), as PDF writers do. Needs a QGuiApplication.
std::string tactile_pdf(const TactileSheet& sheet);

/// Writes PDF or SVG by the file's ending, through a temporary file, so that a reader never sees half a sheet.
Result<std::filesystem::path> write_tactile(const std::filesystem::path& file, const TactileSheet& sheet);

} // namespace tp
