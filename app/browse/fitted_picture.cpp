// SPDX-License-Identifier: Apache-2.0
#include "app/browse/fitted_picture.hpp"

#include <QRectF>
#include <QSizeF>

namespace tp {

FittedPicture::FittedPicture(QQuickItem* parent) : QQuickPaintedItem(parent) {
    connect(this, &FittedPicture::changed, this, [this] { update(); });
}

void FittedPicture::paint(QPainter* painter) {
    if (image_.isNull() || width() < 1.0 || height() < 1.0)
        return;
    const QSizeF size = QSizeF(image_.size()).scaled({width(), height()}, Qt::KeepAspectRatio);
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    painter->drawImage(
        QRectF(0.5 * (width() - size.width()), 0.5 * (height() - size.height()), size.width(), size.height()),
        image_);
}

} // namespace tp
