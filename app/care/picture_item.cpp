// SPDX-License-Identifier: Apache-2.0
#include "app/care/picture_item.hpp"

#include <QImage>
#include <QPainter>

#include <algorithm>

namespace tp {

PictureItem::PictureItem(QQuickItem* parent) : QQuickPaintedItem(parent) {
    connect(this, &PictureItem::changed, this, [this] { update(); });
}

void PictureItem::paint(QPainter* painter) {
    const auto picture = picture_.value<QImage>();
    if (picture.isNull() || width() <= 0.0 || height() <= 0.0)
        return;
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    const double across = width() / picture.width(), down = height() / picture.height();
    const double scale = whole_ ? std::min(across, down) : std::max(across, down);
    const QSizeF shown = whole_ ? QSizeF(picture.size()) : QSizeF(width() / scale, height() / scale);
    const QRectF part(0.5 * (picture.width() - shown.width()), 0.5 * (picture.height() - shown.height()),
                      shown.width(), shown.height());
    const QRectF place(0.5 * (width() - scale * shown.width()), 0.5 * (height() - scale * shown.height()),
                       scale * shown.width(), scale * shown.height());
    painter->drawImage(place, picture, part);
}

} // namespace tp
