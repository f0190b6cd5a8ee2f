// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <QPointF>
#include <QRectF>

namespace tp {

/// The surface as a page draws it: millimetres from its top left corner, x right, y down. So a page only
/// multiplies by its pixels per millimetre.
struct SheetFrame {
    double width_mm = 0.0;
    double height_mm = 0.0;

    QPointF from_surface(Vec2 p) const { return {p.x + 0.5 * width_mm, 0.5 * height_mm - p.y}; }
    Vec2 to_surface(QPointF p) const { return {p.x() - 0.5 * width_mm, 0.5 * height_mm - p.y()}; }
    /// The upright rectangle round both corners.
    QRectF from_surface(const Rect& r) const {
        return QRectF(from_surface(r.min), from_surface(r.max)).normalized();
    }
};

} // namespace tp
