// SPDX-License-Identifier: Apache-2.0
#include "app/photo/picture/field_picture.hpp"

#include "app/photo/picture/colour_map.hpp"

#include <QPainter>
#include <QPainterPath>
#include <QPointF>
#include <QPolygonF>

#include <algorithm>

namespace tp {

namespace {

constexpr double largest_side_px = 4000.0;
constexpr int legend_height = 44;
constexpr double force_share = 0.8;     ///< of the time; arrows and lines take the rest
constexpr double unseen_px = 0.2;       ///< a line that leaves out steps so small looks the same
constexpr qsizetype longest_piece = 64; ///< points

/// Surface millimetres → picture pixels.
struct Frame {
    Rect surface;
    double scale;
    QPointF operator()(Vec2 mm) const {
        return {(mm.x - surface.min.x) * scale, (surface.max.y - mm.y) * scale};
    }
    Vec2 back(double x, double y) const { return {surface.min.x + x / scale, surface.max.y - y / scale}; }
};

void paint_magnitude(QImage& image, const HapticScene& haptic, const Frame& frame, int height,
                     const std::stop_token& stop, const std::function<void(double)>& report) {
    const double peak = haptic.profile.peak();
    for (int y = 0; y < height && !stop.stop_requested(); ++y) {
        if (report)
            report(force_share * y / height);
        auto* const row = reinterpret_cast<QRgb*>(image.scanLine(y)); // of Format_RGB32
        for (int x = 0; x < image.width(); ++x) {
            const Vec2 force = haptic.law->force_at(frame.back(x + 0.5, y + 0.5));
            row[x] = field_colour(length(force) / peak).rgb();
        }
    }
}

void paint_arrow(QPainter& painter, QPointF from, QPointF step) {
    const QPointF tip = from + step;
    const double size = std::hypot(step.x(), step.y());
    const QPointF along = step / size;
    const QPointF across(-along.y(), along.x());
    const double head = std::min(5.0, 0.6 * size);
    painter.drawLine(from, tip);
    painter.drawLine(tip, tip - head * along + 0.5 * head * across);
    painter.drawLine(tip, tip - head * along - 0.5 * head * across);
}

void paint_arrows(QPainter& painter, const HapticScene& haptic, const Frame& frame, int width, int height) {
    const double gap = std::max(14.0, 0.5 * haptic.profile.range * frame.scale);
    painter.setPen(QPen(QColor(255, 255, 255, 150), 1.0));
    for (double y = 0.5 * gap; y < height; y += gap)
        for (double x = 0.5 * gap; x < width; x += gap) {
            const Vec2 force = haptic.law->force_at(frame.back(x, y)) / haptic.profile.peak();
            if (length(force) > 0.05)
                paint_arrow(painter, {x, y}, 0.85 * gap * QPointF(force.x, -force.y));
        }
}

/// In pieces, because a stroke costs the square of its points, and without points that nobody would see.
void paint_line(QPainter& painter, const Polyline& line, const Frame& frame) {
    if (line.points.empty())
        return;
    QPolygonF piece{frame(line.points.front())};
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
        const QPointF next = frame(line.segment_end(i));
        const QPointF step = next - piece.back();
        if (std::max(std::abs(step.x()), std::abs(step.y())) < unseen_px && i + 1 < line.segment_count())
            continue;
        piece << next;
        if (piece.size() < longest_piece)
            continue;
        painter.drawPolyline(piece);
        piece = {next};
    }
    painter.drawPolyline(piece);
}

void paint_legend(QPainter& painter, const HapticScene& haptic, const Frame& frame, int width, int top) {
    painter.fillRect(0, top, width, legend_height, QColor(12, 12, 18));
    QFont font = painter.font();
    font.setPixelSize(14);
    painter.setFont(font);
    painter.setPen(Qt::white);
    const int bar = std::min(200, width / 3);
    for (int x = 0; x < bar; ++x)
        painter.fillRect(12 + x, top + 8, 1, 12, field_colour(static_cast<double>(x) / bar));
    painter.drawText(12, top + 37, QStringLiteral("0"));
    const QString peak = QStringLiteral("%1 N").arg(haptic.profile.peak(), 0, 'g', 3);
    painter.drawText(12 + bar - painter.fontMetrics().horizontalAdvance(peak) / 2, top + 37, peak);
    const double rule = 20.0 * frame.scale;
    const double right = width - 12.0;
    painter.setPen(QPen(Qt::white, 2.0));
    painter.drawLine(QPointF(right - rule, top + 14.0), QPointF(right, top + 14.0));
    const QString length = QStringLiteral("20 mm");
    const double longer = std::max(rule, double(painter.fontMetrics().horizontalAdvance(length)));
    painter.drawText(QPointF(right - longer, top + 37.0), length);
}

} // namespace

QImage draw_force_field(const HapticScene& haptic, const Rect& surface, double pixels_per_mm,
                        const std::vector<Vec2>& way, const std::stop_token& stop,
                        const std::function<void(double)>& report) {
    const double scale =
        std::min(pixels_per_mm, largest_side_px / std::max(surface.width(), surface.height()));
    const Frame frame{surface, scale};
    const int width = std::max(1, static_cast<int>(std::lround(surface.width() * scale)));
    const int height = std::max(1, static_cast<int>(std::lround(surface.height() * scale)));
    QImage image(width, height + legend_height, QImage::Format_RGB32);
    paint_magnitude(image, haptic, frame, height, stop, report);
    if (stop.stop_requested())
        return {};

    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    paint_arrows(painter, haptic, frame, width, height);
    for (std::size_t i = 0; i < haptic.flat.lines.size(); ++i) {
        if (report)
            report(force_share + (1.0 - force_share) * static_cast<double>(i) /
                                     static_cast<double>(haptic.flat.lines.size()));
        painter.setPen(QPen(line_colour(static_cast<int>(i)), 2.0));
        paint_line(painter, haptic.flat.lines[i], frame);
    }
    if (!way.empty()) {
        painter.setPen(QPen(QColor(255, 70, 70), 1.2));
        paint_line(painter, Polyline{way, false}, frame);
    }
    paint_legend(painter, haptic, frame, width, height);
    return image;
}

} // namespace tp
