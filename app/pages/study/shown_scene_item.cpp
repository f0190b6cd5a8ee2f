// SPDX-License-Identifier: Apache-2.0
#include "app/pages/study/shown_scene_item.hpp"

#include <QPainterPath>
#include <QPointF>

namespace tp {

namespace {
constexpr double line_px = 3.0;
constexpr double finger_px = 9.0; ///< radius
} // namespace

ShownSceneItem::ShownSceneItem(QQuickItem* parent) : QQuickPaintedItem(parent) {
    connect(this, &ShownSceneItem::changed, this, [this] { update(); });
}

void ShownSceneItem::setRun(StudyRun* run) {
    if (run_ == run)
        return;
    if (run_)
        disconnect(run_, nullptr, this, nullptr);
    run_ = run;
    if (run_) {
        connect(run_, &StudyRun::changed, this, [this] { update(); });
        connect(run_, &StudyRun::felt, this, [this] { update(); });
    }
    emit changed();
}

QPointF ShownSceneItem::on_item(Vec2 place) const {
    return {0.5 * width() + pixels_per_mm_ * place.x, 0.5 * height() - pixels_per_mm_ * place.y};
}

void ShownSceneItem::paint(QPainter* painter) {
    const FlatScene* const scene = run_ ? run_->shown() : nullptr;
    if (scene == nullptr)
        return;
    painter->setRenderHint(QPainter::Antialiasing);
    for (const Polyline& line : scene->lines) {
        if (line.points.empty())
            continue;
        QPainterPath path(on_item(line.points.front()));
        for (std::size_t i = 0; i < line.segment_count(); ++i)
            path.lineTo(on_item(line.segment_end(i)));
        painter->strokePath(path, {line_color_, line_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin});
    }
    painter->setPen(Qt::NoPen);
    painter->setBrush(finger_color_);
    painter->drawEllipse(on_item(run_->shown_finger()), finger_px, finger_px);
}

} // namespace tp
