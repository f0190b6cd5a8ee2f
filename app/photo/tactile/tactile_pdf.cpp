// SPDX-License-Identifier: Apache-2.0
#include "app/photo/tactile/tactile_file.hpp"
#include "app/photo/tactile/tactile_ink.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <QBuffer>
#include <QColor>
#include <QFont>
#include <QMarginsF>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>
#include <QPen>
#include <QPointF>
#include <QSizeF>
#include <QString>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace tp {

namespace {

constexpr double points_per_mm = 72.0 / 25.4;
constexpr int dots_per_inch = 1200;

QPointF qpoint(Vec2 p) { return {p.x, p.y}; }

QPainterPath tactile_path(const Contour& contour) {
    QPainterPath path;
    for (const Piece& piece : contour.pieces) {
        if (path.elementCount() == 0)
            path.moveTo(qpoint(start_of(piece)));
        if (const auto* q = std::get_if<Quadratic>(&piece))
            path.quadTo(qpoint(q->control), qpoint(q->b));
        else if (const auto* c = std::get_if<Cubic>(&piece))
            path.cubicTo(qpoint(c->control_a), qpoint(c->control_b), qpoint(c->b));
        else
            path.lineTo(qpoint(end_of(piece)));
    }
    if (contour.closed)
        path.closeSubpath();
    return path;
}

void paint(QPainter& painter, const TactileSheet& sheet) {
    painter.setBrush(Qt::NoBrush);
    for (const TactileLine& line : sheet.lines) {
        painter.setPen(QPen(Qt::black, line.width_mm, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(tactile_path(line.path));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::black);
    for (const TactileLabel& label : sheet.labels)
        for (const Vec2 dot : dots_of(label.lines, label.corner))
            painter.drawEllipse(qpoint(dot), 0.5 * braille::dot_diameter_mm, 0.5 * braille::dot_diameter_mm);
    if (sheet.title.empty())
        return;
    // Fonts have whole sizes: set in tenths of a millimetre.
    QFont font("DejaVu Sans");
    font.setPixelSize(static_cast<int>(std::lround(10.0 * TactileSheet::title_mm)));
    painter.setFont(font);
    painter.setPen(QColor(title_ink));
    painter.save();
    painter.translate(qpoint(sheet.title_place()));
    painter.scale(0.1, 0.1);
    painter.drawText(QPointF(0.0, 0.0), QString::fromStdString(sheet.title));
    painter.restore();
}

/// The time at which a PDF was made, of which nobody has a use, becomes one that never changes.
void forget_the_time(std::string& pdf) {
    const std::string key = "/CreationDate (D:";
    const std::size_t at = pdf.find(key);
    if (at == std::string::npos)
        return;
    const std::string always = "20000101000000";
    for (std::size_t i = 0; i < always.size() && at + key.size() + i < pdf.size(); ++i)
        if (std::isdigit(static_cast<unsigned char>(pdf[at + key.size() + i])))
            pdf[at + key.size() + i] = always[i];
}

} // namespace

std::string tactile_pdf(const TactileSheet& sheet) {
    QByteArray bytes;
    {
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QPdfWriter writer(&buffer);
        writer.setCreator("TouchPhoto");
        writer.setTitle(QString::fromStdString(sheet.title));
        writer.setResolution(dots_per_inch);
        const bool across = sheet.width_mm > sheet.height_mm;
        const QSizeF upright(std::min(sheet.width_mm, sheet.height_mm) * points_per_mm,
                             std::max(sheet.width_mm, sheet.height_mm) * points_per_mm);
        writer.setPageLayout(QPageLayout(QPageSize(upright, QPageSize::Point, QString(), QPageSize::ExactMatch),
                                         across ? QPageLayout::Landscape : QPageLayout::Portrait, QMarginsF()));
        QPainter painter(&writer);
        painter.scale(dots_per_inch / 25.4, dots_per_inch / 25.4);
        paint(painter, sheet);
    }
    std::string pdf = bytes.toStdString();
    forget_the_time(pdf);
    return pdf;
}

Result<std::filesystem::path> write_tactile(const std::filesystem::path& file, const TactileSheet& sheet) {
    const std::string ending = file.extension().string();
    if (ending != ".pdf" && ending != ".svg")
        return Error{"A tactile sheet is written as .pdf or .svg, not as " + quoted(file) + "."};
    const std::string reason = replace_file(file, ending == ".pdf" ? tactile_pdf(sheet) : tactile_svg(sheet));
    if (!reason.empty())
        return Error{"The tactile sheet cannot be saved as " + quoted(file) + ": " + reason};
    return file;
}

} // namespace tp
