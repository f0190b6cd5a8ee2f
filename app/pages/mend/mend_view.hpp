// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <QPointF>
#include <QRectF>

namespace tp {

/// Which part of a photograph is seen in a window of so many pixels. Places in the photograph count from the
/// centre of its first pixel.
class MendView {
public:
    static constexpr double largest_scale = 40.0; ///< window px per px of the photograph

    void set_window(double width, double height);
    void set_photo(double width, double height);
    /// Shows the whole photograph.
    void show_all();
    /// Shows this part of the photograph with room round it.
    void show(const Rect& part);
    /// Larger or smaller by `factor`, the place under `keep` (window px) staying there.
    void zoom(double factor, QPointF keep);
    void pan(QPointF by_window_px);
    /// Moves as little as needed to have that place in sight, not nearer than a tenth to the border.
    void bring_in_sight(Vec2 place);

    double scale() const { return scale_; }
    /// What of the photograph lies at the window's top left corner.
    QPointF origin() const { return {origin_.x, origin_.y}; }
    QPointF middle() const { return {0.5 * width_, 0.5 * height_}; }
    QPointF to_window(Vec2 place) const {
        return {(place.x - origin_.x) * scale_, (place.y - origin_.y) * scale_};
    }
    Vec2 to_photo(QPointF place) const { return origin_ + Vec2(place.x(), place.y()) / scale_; }
    /// Where the photograph lies in the window.
    QRectF photo_rect() const;

private:
    void centre_on(Vec2 place);
    double smallest_scale() const;

    double width_ = 400.0, height_ = 300.0;
    double photo_width_ = 1.0, photo_height_ = 1.0;
    double scale_ = 1.0;
    Vec2 origin_{0.0};
};

} // namespace tp
