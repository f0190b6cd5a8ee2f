// SPDX-License-Identifier: Apache-2.0
#include "app/photo/picture/overlay.hpp"

#include "app/photo/picture/colour_map.hpp"
#include "core/geometry/flatten.hpp"

#include <QPainter>
#include <QPainterPath>
#include <QPointF>

#include <algorithm>

namespace tp {

QImage to_image(const cv::Mat& picture) {
    if (picture.empty() || picture.type() != CV_8UC3)
        return {};
    return QImage(picture.data, picture.cols, picture.rows, static_cast<qsizetype>(picture.step),
                  QImage::Format_BGR888)
        .convertToFormat(QImage::Format_RGB32);
}

QImage draw_overlay(const cv::Mat& picture, const Extraction& extraction, int longest_px) {
    QImage image = to_image(picture);
    const double full = std::max(image.width(), image.height());
    if (full > longest_px)
        image = image.scaled(longest_px, longest_px, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    if (image.isNull())
        return image;
    const double scale = image.width() / static_cast<double>(picture.cols);
    const double width = std::max(1.5, std::max(image.width(), image.height()) / 500.0);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Face& face : extraction.faces)
        for (std::size_t i = 0; i < face.contours.size(); ++i) {
            const Polyline line = flatten(face.contours[i], {0.1, 5.0});
            if (line.points.empty())
                continue;
            const auto place = [&](Vec2 px) { return scale * QPointF(px.x, px.y); };
            QPainterPath path(place(line.points.front()));
            for (std::size_t k = 0; k < line.segment_count(); ++k)
                path.lineTo(place(line.segment_end(k)));
            painter.setPen(QPen(QColor(0, 0, 0, 120), 2.0 * width));
            painter.drawPath(path);
            painter.setPen(QPen(line_colour(static_cast<int>(i)), width));
            painter.drawPath(path);
        }
    return image;
}

} // namespace tp
