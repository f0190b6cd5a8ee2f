// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/contours_item.hpp"

#include <QPainter>
#include <QPainterPath>

namespace tp {

namespace {

QPainterPath path_of(const Polyline& line, const SheetFrame& frame, double pixels_per_mm) {
    QPainterPath path;
    if (line.points.empty())
        return path;
    path.moveTo(pixels_per_mm * frame.from_surface(line.points.front()));
    for (std::size_t i = 0; i < line.segment_count(); ++i)
        path.lineTo(pixels_per_mm * frame.from_surface(line.segment_end(i)));
    return path;
}

QPen pen(const QColor& colour, double width) {
    return {colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

} // namespace

ContoursItem::ContoursItem(QQuickItem* parent) : QQuickPaintedItem(parent) {
    connect(this, &ContoursItem::changed, this, [this] { update(); });
}

void ContoursItem::setSession(ExploreSession* session) {
    if (session_ == session)
        return;
    if (session_) {
        disconnect(session_->view(), nullptr, this, nullptr);
        disconnect(session_->finger(), nullptr, this, nullptr);
    }
    session_ = session;
    if (session_) {
        connect(session_->view(), &ExploreView::sceneChanged, this, [this] { update(); });
        connect(session_->finger(), &ExploreFinger::featureChanged, this, [this] { update(); });
    }
    emit changed();
}

void ContoursItem::paint(QPainter* painter) {
    if (!session_)
        return;
    painter->setRenderHint(QPainter::Antialiasing);
    const std::vector<Polyline>& lines = session_->view()->felt().lines;
    const double thin = 2.0;
    QColor edge = edge_color_;
    edge.setAlpha(170);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool here = static_cast<int>(i) == session_->finger()->feature();
        const double width = here ? 2.0 * thin : thin;
        const QPainterPath path = path_of(lines[i], session_->view()->frame(), pixels_per_mm_);
        painter->strokePath(path, pen(edge, width + 3.0));
        painter->strokePath(path, pen(here ? highlight_color_ : line_color_, width));
    }
}

} // namespace tp
