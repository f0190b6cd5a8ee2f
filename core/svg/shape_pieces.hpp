// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/svg/path_pieces.hpp"
#include "core/svg/svg_number.hpp"

#include <pugixml.hpp>

#include <string_view>

namespace tp::svg {

/// Whether elements of this name (without prefix) draw a line.
bool is_shape(std::string_view name);

/// What a shape draws, in its own units: `path`, `line`, `polyline`, `polygon`, `rect`, `circle`, `ellipse`.
/// Nothing for a shape without extent (a radius or a width of zero or below), as SVG says. The error goes on
/// after the element's name: "has a width that …".
Result<std::vector<Subpath>> subpaths_of(pugi::xml_node shape, std::string_view name,
                                         const LengthScale& scale, double tolerance, std::size_t piece_limit);

} // namespace tp::svg
