// SPDX-License-Identifier: Apache-2.0
#include "app/explore/photo_item.hpp"

#include <QPainter>

namespace tp {

PhotoItem::PhotoItem(QQuickItem* parent) : QQuickPaintedItem(parent) {
    connect(this, &PhotoItem::changed, this, [this] { update(); });
}

void PhotoItem::paint(QPainter* painter) {
    if (image_.isNull() || place_.isEmpty())
        return;
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    painter->drawImage(place_, image_);
}

} // namespace tp
