// SPDX-License-Identifier: Apache-2.0
#include "app/pages/print/sheet_preview.hpp"

#include "app/photo/tactile/tactile_file.hpp"

#include <QBuffer>
#include <QByteArray>
#include <QColor>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

namespace tp {

namespace {
constexpr double preview_px_per_mm = 4.0;
} // namespace

QString sheet_preview(const TactileSheet& sheet) {
    QSvgRenderer renderer(QByteArray::fromStdString(tactile_svg(sheet)));
    QImage picture(qRound(preview_px_per_mm * sheet.width_mm), qRound(preview_px_per_mm * sheet.height_mm),
                   QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    renderer.render(&painter);
    painter.end();
    QByteArray png;
    QBuffer buffer(&png);
    picture.save(&buffer, "PNG");
    return "data:image/png;base64," + QString::fromLatin1(png.toBase64());
}

} // namespace tp
