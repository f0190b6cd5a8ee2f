// SPDX-License-Identifier: Apache-2.0
#include "app/lab/picture_item.hpp"

namespace tp {

PictureItem::PictureItem(QQuickItem* parent) : QQuickPaintedItem(parent) {
    connect(this, &PictureItem::changed, this, [this] { update(); });
}

void PictureItem::paint(QPainter* painter) {
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    painter->drawImage(boundingRect(), image_);
}

} // namespace tp
