// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/contour.hpp"
#include "core/guidance/scene.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// Named contours on a sheet, as an SVG file holds them: x right, y down, origin at the top left.
struct ContourSheet {
    enum class Unit {
        millimetre, ///< scenes and tactile sheets
        pixel       ///< contours found in a photograph, in pixels of its upright picture
    };
    double width = 0.0;  ///< > 0
    double height = 0.0; ///< > 0
    Unit unit = Unit::millimetre;
    std::vector<Contour> contours;
};

/// Reads the SVG text of a sheet. What is drawn by `path`, `line`, `polyline`, `polygon`, `rect`, `circle`
/// and `ellipse` becomes contours, named by `id` (numbered "contour 1", "contour 2", … where there is none;
/// made unique by a number where an id repeats); a path with several subpaths becomes several contours.
/// Transforms of elements and groups and the viewBox are applied; `defs`, `clipPath`, `mask`, `symbol`,
/// `marker`, `pattern` and elements with display:none are left out. The size comes from width and height (mm,
/// cm, in, pt, pc; px and bare numbers are user units, 1 unit = 1 mm or 1 px by `unit`), else from the
/// viewBox. Arcs become cubics. Never throws; says in a sentence what is wrong with text that is not such a
/// file; one element that cannot be read, or is not finite, refuses the file and is named.
Result<ContourSheet> sheet_from_svg(std::string_view text,
                                    ContourSheet::Unit unit = ContourSheet::Unit::millimetre);

/// The sheet as SVG text that sheet_from_svg reads back to the same contours (to 1e-9 of a unit) and that a
/// drawing program opens: one stroked `path` a contour, its name as `id` (with underscores for what an id
/// cannot hold, and the exact name beside it in `data-name`). Straight pieces of length zero are left out
/// unless they are all of a contour; pieces that are not finite and contours without pieces are left out.
std::string sheet_to_svg(const ContourSheet& sheet);

/// The sheet's contours in the surface frame (mm, origin at the centre, y up); only for sheets in
/// millimetres, an empty scene for others.
Scene scene_from_sheet(const ContourSheet& sheet);
ContourSheet sheet_from_scene(const Scene& scene);

/// Whole files. Reading refuses what is larger than 64 MiB; writing is write-temporary, fsync, rename, so
/// that a reader never sees half a file, and refuses a sheet without a size. Permissions and links are kept.
Result<ContourSheet> read_sheet(const std::filesystem::path& file,
                                ContourSheet::Unit unit = ContourSheet::Unit::millimetre);
Result<std::filesystem::path> write_sheet(const std::filesystem::path& file, const ContourSheet& sheet);

} // namespace tp
