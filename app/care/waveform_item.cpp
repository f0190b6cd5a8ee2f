// SPDX-License-Identifier: Apache-2.0
#include "app/care/waveform_item.hpp"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace tp {

WaveformItem::WaveformItem(QQuickItem* parent) : QQuickPaintedItem(parent) {
    connect(this, &WaveformItem::changed, this, [this] { update(); });
}

void WaveformItem::paint(QPainter* painter) {
    if (peaks_.isEmpty())
        return;
    const double step = width() / static_cast<double>(peaks_.size());
    painter->setPen(Qt::NoPen);
    for (qsizetype i = 0; i < peaks_.size(); ++i) {
        const double middle = (static_cast<double>(i) + 0.5) / static_cast<double>(peaks_.size());
        const double half = std::max(1.0, 0.5 * height() * std::sqrt(static_cast<double>(peaks_[i]))); // soft voices show
        painter->setBrush(middle >= from_ && middle <= to_ ? color_ : dim_color_);
        painter->drawRect(QRectF(static_cast<double>(i) * step, 0.5 * height() - half, std::max(1.0, 0.75 * step), 2.0 * half));
    }
}

} // namespace tp
