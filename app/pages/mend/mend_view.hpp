// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mended_photo.hpp"
#include "core/geometry/vec.hpp"

#include <QObject>
#include <QPointF>
#include <QRectF>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// Which part of the photograph is seen in a window of so many pixels. Places in the photograph count from
/// the centre of its first pixel.
class MendView final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    /// What of the photograph lies at the window's top left corner.
    Q_PROPERTY(QPointF origin READ origin NOTIFY changed)
    Q_PROPERTY(double scale READ scale NOTIFY changed) ///< window px per px of the photograph
public:
    static constexpr double largest_scale = 40.0;

    /// A photograph that comes is seen as a whole. It must outlive the view.
    explicit MendView(const MendedPhoto& photo);

    double scale() const { return scale_; }
    QPointF origin() const { return {origin_.x, origin_.y}; }
    QPointF middle() const { return {0.5 * width_, 0.5 * height_}; }
    QPointF to_window(Vec2 place) const {
        return {(place.x - origin_.x) * scale_, (place.y - origin_.y) * scale_};
    }
    Vec2 to_photo(QPointF place) const { return origin_ + Vec2(place.x(), place.y()) / scale_; }
    /// Where the photograph lies in the window.
    QRectF photo_rect() const;

    Q_INVOKABLE void setWindow(double width, double height);
    /// Larger or smaller by `factor`, the place under (x, y) in the window staying there.
    Q_INVOKABLE void zoomAt(double factor, double x, double y);
    /// Moves the photograph by pixels of the window, its middle at most to its border.
    Q_INVOKABLE void panBy(double dx, double dy);
    /// The whole photograph.
    Q_INVOKABLE void showAll();
    /// This part of the photograph with room round it.
    void show(const Rect& part);
    /// Moves as little as needed to have that place in sight, not nearer than a tenth to the border.
    void bring_in_sight(Vec2 place);

signals:
    void changed();

private:
    void set_photo(double width, double height);
    void centre_on(Vec2 place);
    double smallest_scale() const;

    double width_ = 400.0, height_ = 300.0;
    double photo_width_ = 1.0, photo_height_ = 1.0;
    double scale_ = 1.0;
    Vec2 origin_{0.0};
};

} // namespace tp
