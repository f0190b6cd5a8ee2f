// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/wild_bench.hpp"
#include "app/photo/picture/overlay.hpp"
#include "app/photo/picture/picture_file.hpp"
#include "core/geometry/flatten.hpp"
#include "faces/decode/picture.hpp"

#include <QColor>
#include <QFont>
#include <QFontMetrics>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QPoint>
#include <QPointF>
#include <QRectF>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {

namespace {

constexpr int tile_px = 330, gap_px = 14, line_px = 20, said_lines = 2, across = 5, head_px = 120,
              text_px = 15;
constexpr double around_face = 0.12; ///< of a face's extent, on each side
const QColor ours_colour(255, 222, 40), mesh_colour(0, 200, 255), paper(24, 24, 28), ink(236, 236, 240);

const char* spoken(std::size_t contour) {
    constexpr std::array<const char*, 5> names{"right eye", "left eye", "outer lip", "inner lip", "outline"};
    return names[contour];
}

/// What the tile shows of the picture: a square, px; the whole picture where no face was found.
QRectF shown(const WildPhoto& photo, const cv::Mat& picture) {
    std::vector<Vec2> points;
    for (const std::optional<Face>* face : {&photo.face, &photo.mesh_face})
        if (*face)
            for (const Contour& contour : (*face)->contours) {
                const Polyline line = flatten(contour);
                points.insert(points.end(), line.points.begin(), line.points.end());
            }
    const Rect box = points.empty() ? Rect{{0.0, 0.0}, Vec2(picture.cols, picture.rows)} : bounds_of(points);
    const double side =
        std::max({box.width(), box.height(), 1.0}) * (points.empty() ? 1.0 : 1.0 + 2.0 * around_face);
    return {box.centre().x - 0.5 * side, box.centre().y - 0.5 * side, side, side};
}

/// Reads only as much into Qt's picture as the tile shows: a photograph may have 200 megapixel.
void draw_photograph(QPainter& painter, const cv::Mat& picture, const QRectF& from, const QRectF& to) {
    const cv::Rect part =
        cv::Rect(static_cast<int>(std::floor(from.left())), static_cast<int>(std::floor(from.top())),
                 static_cast<int>(std::ceil(from.width())) + 1,
                 static_cast<int>(std::ceil(from.height())) + 1) &
        cv::Rect(0, 0, picture.cols, picture.rows);
    if (part.empty())
        return;
    const double scale = to.width() / from.width();
    const QRectF place(to.left() + scale * (part.x - from.left()), to.top() + scale * (part.y - from.top()),
                       scale * part.width, scale * part.height);
    // Areas averaged first where it shrinks: the painter alone would leave pixels out.
    const QImage image = to_image(not_larger_than(picture(part), std::max(2 * tile_px, 1)));
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(place, image);
}

void draw_contours(QPainter& painter, const Face& face, const QColor& colour, const QRectF& from,
                   const QRectF& to) {
    const double scale = to.width() / from.width();
    const auto place = [&](Vec2 px) {
        return QPointF(to.left() + scale * (px.x - from.left()), to.top() + scale * (px.y - from.top()));
    };
    for (const Contour& contour : face.contours) {
        const Polyline line = flatten(contour, {0.2, 5.0});
        if (line.points.empty())
            continue;
        QPainterPath path(place(line.points.front()));
        for (std::size_t k = 0; k < line.segment_count(); ++k)
            path.lineTo(place(line.segment_end(k)));
        painter.setPen(QPen(colour, 1.4));
        painter.drawPath(path);
    }
}

/// Why the photograph is here.
QString figure_of(const WildPhoto& photo) {
    if (!photo.face)
        return photo.mesh_face ? QStringLiteral("found by the mesh only")
                               : QStringLiteral("no face found by either");
    if (!photo.mesh_face)
        return QStringLiteral("found by ours only");
    std::size_t worst = 0;
    for (std::size_t i = 0; i < photo.off_percent.size(); ++i)
        if (photo.off_percent[i].value_or(0.0) > photo.off_percent[worst].value_or(0.0))
            worst = i;
    return QStringLiteral("%1 %2 % apart")
        .arg(QLatin1String(spoken(worst)), QString::number(photo.off_percent[worst].value_or(0.0), 'f', 1));
}

void draw_tile(QPainter& painter, const WildPhoto& photo, const QPoint& corner) {
    const QRectF to(corner.x(), corner.y(), tile_px, tile_px);
    painter.fillRect(to, QColor(70, 70, 76));
    QString said = photo.said.empty() ? QString() : QString::fromStdString(photo.said.front());
    if (const Result<cv::Mat> read = read_picture(photo.file)) {
        const cv::Mat picture = turned(*read, photo.turned_degrees);
        const QRectF from = shown(photo, picture);
        painter.save();
        painter.setClipRect(to);
        draw_photograph(painter, picture, from, to);
        if (photo.mesh_face)
            draw_contours(painter, *photo.mesh_face, mesh_colour, from, to);
        if (photo.face)
            draw_contours(painter, *photo.face, ours_colour, from, to);
        painter.restore();
    } else {
        said = QString::fromStdString(read.error()); // it was there when it was measured
    }
    painter.setPen(ink);
    QRectF below(to.left(), to.bottom() + 4, tile_px, line_px);
    const auto write = [&](const QString& words, Qt::TextElideMode shortened) {
        painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(words, shortened, tile_px));
        below.translate(0.0, line_px);
    };
    write(QString::fromStdString(photo.name), Qt::ElideLeft);
    write(figure_of(photo), Qt::ElideRight);
    below.setHeight(said_lines * line_px);
    painter.drawText(
        below, static_cast<int>(Qt::AlignLeft) | static_cast<int>(Qt::AlignTop) | Qt::TextWordWrap, said);
}

/// What the sheet shows and whose the colours are; `painter` writes in `text_px`.
void draw_head(QPainter& painter, const QString& title, int width) {
    const QFont plain = painter.font();
    QFont bold = plain;
    bold.setPixelSize(19);
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(ink);
    const int room = width - 2 * gap_px;
    painter.drawText(QRectF(gap_px, 8, room, 28), Qt::AlignLeft | Qt::AlignVCenter, title);
    painter.setFont(plain);
    painter.drawText(
        QRectF(gap_px, 38, room, 2 * line_px),
        static_cast<int>(Qt::AlignLeft) | static_cast<int>(Qt::AlignTop) | Qt::TextWordWrap,
        QStringLiteral("First those in which one of both found no face, then by the largest mean distance "
                       "between two contours, in percent of the distance between the eyes' outer corners."));
    int x = gap_px;
    for (const auto& [colour, name] : {std::pair(ours_colour, QStringLiteral("ours")),
                                       std::pair(mesh_colour, QStringLiteral("the face mesh alone"))}) {
        painter.setPen(QPen(colour, 3.0));
        painter.drawLine(x, 96, x + 34, 96);
        painter.setPen(ink);
        painter.drawText(QRectF(x + 42, 84, 200, 24), Qt::AlignLeft | Qt::AlignVCenter, name);
        x += 80 + painter.fontMetrics().horizontalAdvance(name);
    }
}

} // namespace

Result<std::filesystem::path> write_wild_sheet(const std::filesystem::path& folder,
                                               const std::vector<WildPhoto>& photos,
                                               const std::vector<std::size_t>& worst) {
    const int count = static_cast<int>(worst.size());
    const int columns = std::clamp(count, 2, across), rows = (count + columns - 1) / columns;
    const int step_x = tile_px + gap_px, step_y = tile_px + (2 + said_lines) * line_px + 2 * gap_px;
    QImage sheet(gap_px + columns * step_x, head_px + rows * step_y, QImage::Format_RGB32);
    sheet.fill(paper);
    QPainter painter(&sheet);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setPixelSize(text_px);
    painter.setFont(font);
    draw_head(painter, QStringLiteral("The %1 worst of %2 photographs").arg(count).arg(photos.size()),
              sheet.width());
    for (int i = 0; i < count; ++i)
        draw_tile(painter, photos[worst[static_cast<std::size_t>(i)]],
                  QPoint(gap_px + i % columns * step_x, head_px + i / columns * step_y));
    painter.end();
    return write_image(folder / "worst.png", sheet);
}

} // namespace tp
