// SPDX-License-Identifier: Apache-2.0
#include "app/parts/controls/picture_item.hpp"

#include <QPainter>
#include <QSizeF>

namespace tp {

PictureItem::PictureItem(QQuickItem* parent) : QQuickPaintedItem(parent) {
    connect(this, &PictureItem::changed, this, [this] { update(); });
}

QRectF PictureItem::target(QSizeF size) const {
    if (!place_.isEmpty())
        return place_;
    const QSizeF shown = size.scaled(this->size(), fill_ == Whole   ? Qt::KeepAspectRatio
                                                   : fill_ == Cover ? Qt::KeepAspectRatioByExpanding
                                                                    : Qt::IgnoreAspectRatio);
    return {0.5 * (width() - shown.width()), 0.5 * (height() - shown.height()), shown.width(), shown.height()};
}

void PictureItem::paint(QPainter* painter) {
    const auto picture = picture_.value<QImage>();
    if (picture.isNull() || width() < 1.0 || height() < 1.0)
        return;
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    painter->drawImage(target(picture.size()), picture);
}

} // namespace tp
