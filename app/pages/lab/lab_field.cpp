// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_field.hpp"

#include "app/photo/picture/field_picture.hpp"

#include <QColor>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {

void LabField::show(std::shared_ptr<const HapticScene> scene) {
    scene_ = std::move(scene);
    paint();
}

void LabField::set_scale(double pixels_per_mm) {
    const double scale = std::clamp(pixels_per_mm, 0.5, 16.0);
    if (std::abs(scale - scale_) < 1e-6)
        return;
    scale_ = scale;
    paint();
}

void LabField::take(const QImage& image) {
    image_ = image;
    painted_();
}

/// A coarse picture first, because the published law takes its time over many vertices.
void LabField::paint() {
    if (scene_ == nullptr)
        return;
    if (scale_ < 2.0)
        return paint_finely();
    work_.ask([this, scene = scene_, area = surface_,
               scale = scale_](const std::stop_token& stop) -> LatestTask::Answer {
        const QImage coarse = draw_force_field(*scene, area, 0.25 * scale, {}, stop);
        QImage image(static_cast<int>(std::lround(area.width() * scale)),
                     static_cast<int>(std::lround(area.height() * scale)) + legend_pixels,
                     QImage::Format_RGB32);
        image.fill(QColor(12, 12, 18));
        QPainter painter(&image);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(image.rect().adjusted(0, 0, 0, -legend_pixels), coarse,
                          coarse.rect().adjusted(0, 0, 0, -legend_pixels));
        painter.end();
        return [this, image] {
            take(image);
            paint_finely();
        };
    });
}

void LabField::paint_finely() {
    work_.ask([this, scene = scene_, area = surface_,
               scale = scale_](const std::stop_token& stop) -> LatestTask::Answer {
        const QImage image = draw_force_field(*scene, area, scale, {}, stop);
        return [this, image] { take(image); };
    });
}

} // namespace tp
