// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QPainter>
#include <QQuickPaintedItem>
#include <QRectF>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// Draws an image into `place` (in the item's own pixels); what lies outside the item is not drawn, so that a
/// photograph that is larger than the surface costs no more than the surface.
class PhotoItem : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(QImage image MEMBER image_ NOTIFY changed)
    Q_PROPERTY(QRectF place MEMBER place_ NOTIFY changed)
public:
    explicit PhotoItem(QQuickItem* parent = nullptr);
    void paint(QPainter* painter) override;

signals:
    void changed();

private:
    QImage image_;
    QRectF place_;
};

} // namespace tp
