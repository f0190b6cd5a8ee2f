// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QPainter>
#include <QQuickPaintedItem>
#include <QRectF>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// Draws a picture that the program holds; nothing for a null one, or for no picture at all. What lies outside the item is
/// not drawn, so that a picture that is larger costs no more.
class PictureItem : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(QVariant picture MEMBER picture_ NOTIFY changed)
    Q_PROPERTY(Fill fill MEMBER fill_ NOTIFY changed)
    /// Where it is drawn, in the item's own pixels; an empty one leaves that to `fill`.
    Q_PROPERTY(QRectF place MEMBER place_ NOTIFY changed)
public:
    enum Fill {
        Whole,  ///< all of it, as large as there is room, in the middle
        Cover,  ///< its middle, over the whole item
        Stretch ///< all of it over the whole item, whatever its shape
    };
    Q_ENUM(Fill)

    explicit PictureItem(QQuickItem* parent = nullptr);
    void paint(QPainter* painter) override;

signals:
    void changed();

private:
    QRectF target(QSizeF size) const;

    QVariant picture_; ///< a QImage
    Fill fill_ = Whole;
    QRectF place_;
};

} // namespace tp
