// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/waveform_item.hpp"

#include <QPainter>
#include <QRectF>

#include <algorithm>
#include <cmath>

namespace tp {

WaveformItem::WaveformItem(QQuickItem* parent) : QQuickPaintedItem(parent) {
    connect(this, &WaveformItem::changed, this, [this] { update(); });
}

void WaveformItem::paint(QPainter* painter) {
    if (peaks_.isEmpty())
        return;
    constexpr double step = 4.0, bar = 3.0; // px, so that all bars are equally broad
    const auto bars = std::max<qsizetype>(1, static_cast<qsizetype>(width() / step));
    const qsizetype peaks = peaks_.size();
    painter->setPen(Qt::NoPen);
    for (qsizetype i = 0; i < bars; ++i) {
        const qsizetype begin = i * peaks / bars, end = std::max(begin + 1, (i + 1) * peaks / bars);
        const float peak = *std::max_element(peaks_.begin() + begin, peaks_.begin() + end);
        const double middle = (static_cast<double>(i) + 0.5) / static_cast<double>(bars);
        const double half = std::max(1.0, 0.5 * height() * std::sqrt(static_cast<double>(peak))); // soft voices show
        painter->setBrush(middle >= from_ && middle <= to_ ? color_ : dim_color_);
        painter->drawRect(QRectF(static_cast<double>(i) * step, 0.5 * height() - half, bar, 2.0 * half));
    }
}

} // namespace tp
