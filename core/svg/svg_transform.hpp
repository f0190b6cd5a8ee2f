// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/transform.hpp"

#include <optional>
#include <string_view>

namespace tp::svg {

/// The map that a `transform` attribute describes: matrix, translate, scale, rotate, skewX and skewY, the
/// leftmost acting last. The identity for an empty text; nothing where the text is no transform, or where one
/// of its numbers is not finite.
std::optional<Affine> transform_from(std::string_view text);

/// The part of the plane that a drawing shows.
struct ViewBox {
    double x = 0.0;
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;
};

/// Four finite numbers, width and height above zero; nothing otherwise.
std::optional<ViewBox> view_box_from(std::string_view text);

/// User units of `box` → a viewport of `width` × `height` with its origin at its top left, as
/// `preserveAspectRatio` says; an empty or unknown text is xMidYMid meet.
Affine fit_view_box(const ViewBox& box, double width, double height, std::string_view preserve_aspect_ratio);

/// The largest factor by which the map stretches a length.
double largest_stretch(const Affine& map);

} // namespace tp::svg
