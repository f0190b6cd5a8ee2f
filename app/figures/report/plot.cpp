// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/plot.hpp"

#include "core/files/durable_file.hpp"

#include <QBuffer>
#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

constexpr int panel_width = 620;
constexpr int panel_height = 480;
const QColor ink(30, 30, 36);
const QColor grid(224, 224, 230);

class PanelPainter {
public:
    PanelPainter(QPainter& painter, const PlotPanel& panel, const QRectF& area)
        : painter_(painter), panel_(panel), box_(area.adjusted(74, 46, -18, -58)) {}

    void paint() {
        axis(panel_.x, true);
        axis(panel_.y, false);
        painter_.save();
        painter_.setClipRect(box_.adjusted(-4, -4, 4, 4));
        for (const PlotPanel::Dot& dot : panel_.dots)
            draw_dot(place(dot.place), dot.colour, dot.hollow);
        for (const PlotPanel::Line& line : panel_.lines) {
            painter_.setPen(QPen(line.colour, 2.0, line.dashed ? Qt::DashLine : Qt::SolidLine));
            for (std::size_t i = 1; i < line.points.size(); ++i)
                painter_.drawLine(place(line.points[i - 1]), place(line.points[i]));
        }
        painter_.restore();
        for (const PlotPanel::Text& words : panel_.texts) {
            const QPointF at = place(words.place);
            text(QRectF(at.x() - 40, at.y() - 24, 80, 18), Qt::AlignCenter, words.words, 13, true);
        }
        painter_.setPen(QPen(ink, 1.2));
        painter_.drawRect(box_);
        legend();
        const bool noted = !panel_.note.isEmpty();
        text(QRectF(box_.left(), box_.top() - (noted ? 46 : 40), box_.width(), noted ? 26 : 30),
             Qt::AlignCenter, panel_.title, 17, true);
        if (noted)
            text(QRectF(box_.left() - 60, box_.top() - 21, box_.width() + 70, 18), Qt::AlignCenter,
                 panel_.note, 12);
    }

private:
    static double share(const PlotAxis& axis, double value) {
        if (axis.logarithmic)
            return std::log(std::max(value, 1e-300) / axis.low) / std::log(axis.high / axis.low);
        return (value - axis.low) / (axis.high - axis.low);
    }

    QPointF place(Vec2 p) const {
        return {box_.left() + share(panel_.x, p.x) * box_.width(),
                box_.bottom() - share(panel_.y, p.y) * box_.height()};
    }

    static std::vector<double> ticks(const PlotAxis& axis) {
        std::vector<double> values;
        if (axis.logarithmic) {
            const bool narrow = axis.high / axis.low < 2e3;
            const std::vector<double> steps = narrow ? std::vector{1.0, 2.0, 5.0} : std::vector{1.0};
            for (double decade = std::floor(std::log10(axis.low)); decade <= std::log10(axis.high) + 1e-9;
                 ++decade)
                for (const double step : steps)
                    values.push_back(step * std::pow(10.0, decade));
        } else {
            const double rough = (axis.high - axis.low) / 5.0;
            const double power = std::pow(10.0, std::floor(std::log10(rough)));
            const double step = power * (rough / power < 1.5   ? 1.0
                                         : rough / power < 3.5 ? 2.0
                                         : rough / power < 7.5 ? 5.0
                                                               : 10.0);
            for (double value = std::ceil(axis.low / step) * step; value <= axis.high + 1e-9 * step;
                 value += step)
                values.push_back(std::abs(value) < 1e-9 * step ? 0.0 : value);
        }
        std::erase_if(values,
                      [&](double v) { return v < axis.low * (1 - 1e-9) || v > axis.high * (1 + 1e-9); });
        return values;
    }

    /// Words that are too wide for their place are written smaller, so that none is cut off.
    void text(const QRectF& where, int align, const QString& words, int pixels, bool bold = false) {
        constexpr int smallest = 8;
        QFont font = painter_.font();
        font.setPixelSize(pixels);
        font.setBold(bold);
        while (pixels > smallest && QFontMetricsF(font).size(0, words).width() > where.width())
            font.setPixelSize(--pixels);
        painter_.setFont(font);
        painter_.setPen(ink);
        painter_.drawText(where, align, words);
    }

    void axis(const PlotAxis& axis, bool across) {
        std::vector<std::pair<double, QString>> marks = axis.names;
        if (marks.empty())
            for (const double value : ticks(axis))
                marks.emplace_back(value, QString::number(value, 'g', 3));
        const double wide =
            across && !axis.names.empty() ? box_.width() / static_cast<double>(marks.size()) : 80.0;
        for (const auto& [value, number] : marks) {
            const double at = share(axis, value);
            painter_.setPen(QPen(grid, 1.0));
            if (across) {
                const double x = box_.left() + at * box_.width();
                painter_.drawLine(QPointF(x, box_.top()), QPointF(x, box_.bottom()));
                text(QRectF(x - 0.5 * wide, box_.bottom() + 4, wide, number.contains('\n') ? 32 : 18),
                     Qt::AlignCenter, number, wide < 60.0 ? 10 : 13);
            } else {
                const double y = box_.bottom() - at * box_.height();
                painter_.drawLine(QPointF(box_.left(), y), QPointF(box_.right(), y));
                text(QRectF(box_.left() - 176, y - 9, 170, 18), Qt::AlignRight | Qt::AlignVCenter, number,
                     13);
            }
        }
        if (across) {
            text(QRectF(box_.left(), box_.bottom() + 26, box_.width(), 24), Qt::AlignCenter, axis.label, 14);
        } else {
            painter_.save();
            painter_.translate(box_.left() - 62, box_.center().y());
            painter_.rotate(-90.0);
            text(QRectF(-200, -12, 400, 24), Qt::AlignCenter, axis.label, 14);
            painter_.restore();
        }
    }

    void draw_dot(const QPointF& at, const QColor& colour, bool hollow) {
        painter_.setPen(QPen(colour, 1.6));
        painter_.setBrush(hollow ? Qt::NoBrush : QBrush(colour));
        painter_.drawEllipse(at, 4.0, 4.0);
        painter_.setBrush(Qt::NoBrush);
    }

    void legend() {
        constexpr double row_height = 19.0;
        const auto named = std::count_if(panel_.lines.begin(), panel_.lines.end(),
                                         [](const PlotPanel::Line& line) { return !line.name.isEmpty(); });
        const double height = row_height * static_cast<double>(named + std::ssize(panel_.dot_names));
        double y = panel_.legend_at_bottom ? box_.bottom() - 10 - height : box_.top() + 10;
        const auto row = [&](const QString& words) {
            text(QRectF(box_.left() + 42, y - 1, box_.width() - 50, 18), Qt::AlignLeft | Qt::AlignVCenter,
                 words, 13);
            y += row_height;
        };
        for (const PlotPanel::Line& line : panel_.lines)
            if (!line.name.isEmpty()) {
                painter_.setPen(QPen(line.colour, 2.0, line.dashed ? Qt::DashLine : Qt::SolidLine));
                painter_.drawLine(QPointF(box_.left() + 10, y + 8), QPointF(box_.left() + 36, y + 8));
                row(line.name);
            }
        for (const PlotPanel::DotName& dot : panel_.dot_names) {
            draw_dot(QPointF(box_.left() + 23, y + 8), dot.colour, dot.hollow);
            row(dot.name);
        }
    }

    QPainter& painter_;
    const PlotPanel& panel_;
    QRectF box_;
};

void paint_all(QPaintDevice& device, const std::vector<PlotPanel>& panels, const QRectF& whole) {
    QPainter painter(&device);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(whole, Qt::white);
    for (std::size_t i = 0; i < panels.size(); ++i)
        PanelPainter(painter, panels[i],
                     QRectF(static_cast<double>(i) * panel_width, 0.0, panel_width, panel_height))
            .paint();
}

Result<std::filesystem::path> write_bytes(const std::filesystem::path& file, const QByteArray& bytes) {
    if (const std::string reason = replace_file(file, bytes.toStdString()); !reason.empty())
        return Error{"The plot " + file.string() + " cannot be written: " + reason};
    return file;
}

} // namespace

Result<std::filesystem::path> write_plot(const std::filesystem::path& stem,
                                         const std::vector<PlotPanel>& panels) {
    const QSize size(panel_width * static_cast<int>(panels.size()), panel_height);
    const QRectF whole(QPointF(0.0, 0.0), QSizeF(size));
    QImage image(size, QImage::Format_RGB32);
    paint_all(image, panels, whole);
    QByteArray png;
    QBuffer png_buffer(&png);
    image.save(&png_buffer, "png");

    QByteArray svg;
    {
        QBuffer svg_buffer(&svg);
        QSvgGenerator generator;
        generator.setOutputDevice(&svg_buffer);
        generator.setSize(size);
        generator.setViewBox(whole);
        paint_all(generator, panels, whole);
    }
    const auto written = write_bytes(stem.string() + ".svg", svg);
    return written ? write_bytes(stem.string() + ".png", png) : written;
}

} // namespace tp
