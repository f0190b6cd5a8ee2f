// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/plot_item.hpp"

#include "app/pages/lab/plot_curves.hpp"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainterPath>
#include <QRectF>

#include <algorithm>

namespace tp {

namespace {

constexpr int time_steps = 5; ///< of the time axis

/// Where a plot lies in its item, and what it shows.
struct PlotFrame {
    QRectF area;
    LabTrace::Range axis;
    double y(double value) const {
        return area.bottom() - (value - axis.least) / (axis.most - axis.least) * area.height();
    }
};

void paint_grid(QPainter& painter, const PlotFrame& frame, const TracePlot& plot, double until, const QColor& grid,
                const QColor& text) {
    const QFontMetricsF metrics(painter.font());
    const QLocale locale;
    for (const double share : {0.0, 0.5, 1.0}) {
        const double value = frame.axis.least + share * (frame.axis.most - frame.axis.least);
        painter.setPen(QPen(grid, 1.0));
        painter.drawLine(QPointF(frame.area.left(), frame.y(value)), QPointF(frame.area.right(), frame.y(value)));
        painter.setPen(text);
        const QString label = locale.toString(value, 'g', 3) + (share == 1.0 ? QString(" ") + plot.unit : QString());
        painter.drawText(QRectF(0.0, frame.y(value) - metrics.height(), frame.area.left() - 6.0, 2.0 * metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, label);
    }
    for (int i = 0; i <= time_steps; ++i) {
        const double x = frame.area.left() + frame.area.width() * i / time_steps;
        painter.setPen(QPen(grid, 1.0));
        painter.drawLine(QPointF(x, frame.area.top()), QPointF(x, frame.area.bottom()));
        const double time = until - LabTrace::longest * (time_steps - i) / time_steps;
        const QString label = locale.toString(time, 'f', time == std::floor(time) ? 0 : 1) +
                              (i == time_steps ? QString(" s") : QString());
        const double width = metrics.horizontalAdvance(label);
        painter.setPen(text);
        painter.drawText(QPointF(std::clamp(x - 0.5 * width, 0.0, frame.area.right() + 8.0 - width),
                                 frame.area.bottom() + metrics.ascent() + 3.0),
                         label);
    }
}

void paint_curve(QPainter& painter, const PlotFrame& frame, const std::vector<CurveColumn>& columns, int count) {
    QPainterPath path;
    for (const CurveColumn& column : columns) {
        const double x = frame.area.left() + frame.area.width() * (column.column + 0.5) / count;
        if (path.elementCount() == 0)
            path.moveTo(x, frame.y(column.least));
        else
            path.lineTo(x, frame.y(column.least));
        path.lineTo(x, frame.y(column.most));
    }
    painter.drawPath(path);
}

} // namespace

PlotItem::PlotItem(QQuickItem* parent) : QQuickPaintedItem(parent) {
    connect(this, &PlotItem::changed, this, [this] { update(); });
}

void PlotItem::setMeasurements(LabMeasurements* measurements) {
    if (measurements_ == measurements)
        return;
    if (measurements_)
        disconnect(measurements_, nullptr, this, nullptr);
    measurements_ = measurements;
    if (measurements_)
        connect(measurements_, &LabMeasurements::plotted, this, [this] { update(); });
    emit changed();
}

void PlotItem::paint(QPainter* painter) {
    if (!measurements_)
        return;
    const LabTrace& trace = measurements_->trace();
    const TracePlot& plot = trace_plot(static_cast<TraceQuantity>(quantity_));
    QFont font = painter->font();
    font.setPixelSize(static_cast<int>(text_size_));
    painter->setFont(font);
    painter->setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(font);
    PlotFrame frame;
    frame.axis = axis_for(range_of(trace, plot), plot);
    const double left = metrics.horizontalAdvance("−0.55 mm") + 10.0;
    frame.area = QRectF(left, 0.5 * metrics.height(), width() - left - 10.0, height() - 1.9 * metrics.height());
    if (frame.area.width() < 20.0 || frame.area.height() < 10.0)
        return;
    const double until = trace.points().empty() ? LabTrace::longest
                                                : std::max(LabTrace::longest, trace.points().back().time);
    paint_grid(*painter, frame, plot, until, grid_color_, text_color_);
    const int columns = static_cast<int>(frame.area.width());
    const QColor colours[] = {line_color_, second_color_};
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        painter->setPen(QPen(colours[i], 2.0, i == 0 ? Qt::SolidLine : Qt::DashLine));
        paint_curve(*painter, frame, columns_of(trace, plot.curves[i], columns), columns);
        if (*plot.curves[i].name != '\0')
            painter->drawText(QPointF(frame.area.left() + 8.0 + 1.6 * text_size_ * static_cast<double>(i),
                                      frame.area.top() + metrics.ascent()),
                              plot.curves[i].name);
    }
}

} // namespace tp
