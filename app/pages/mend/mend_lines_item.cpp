// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_lines_item.hpp"

#include <QLineF>
#include <QPainterPath>
#include <QPen>

namespace tp {

namespace {

const QColor dark(8, 12, 18, 190);

QPen mend_pen(const QColor& colour, double width) {
    return {colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

QPainterPath mend_path(const MendContour& contour, const MendView& view) {
    QPainterPath path;
    const Contour drawn = contour_of(contour);
    for (const Piece& piece : drawn.pieces) {
        if (path.elementCount() == 0)
            path.moveTo(view.to_window(start_of(piece)));
        if (const auto* q = std::get_if<Quadratic>(&piece))
            path.quadTo(view.to_window(q->control), view.to_window(q->b));
        else if (const auto* c = std::get_if<Cubic>(&piece))
            path.cubicTo(view.to_window(c->control_a), view.to_window(c->control_b), view.to_window(c->b));
        else
            path.lineTo(view.to_window(end_of(piece)));
    }
    return path;
}

} // namespace

MendLinesItem::MendLinesItem(QQuickItem* parent) : QQuickPaintedItem(parent) {
    connect(this, &MendLinesItem::changed, this, [this] { update(); });
}

void MendLinesItem::setSession(MendSession* session) {
    if (session_ == session)
        return;
    if (session_) {
        disconnect(session_->view(), nullptr, this, nullptr);
        disconnect(session_->selection(), nullptr, this, nullptr);
    }
    session_ = session;
    if (session_) {
        const auto draw = [this] { update(); };
        connect(session_->view(), &MendView::changed, this, draw);
        connect(session_->selection(), &MendSelection::changed, this, draw);
    }
    emit changed();
}

void MendLinesItem::paint_line(QPainter& painter, const MendContour& contour, const QColor& colour,
                               double width) const {
    const QPainterPath path = mend_path(contour, *session_->view());
    painter.strokePath(path, mend_pen(dark, width + 3.0));
    painter.strokePath(path, mend_pen(colour, width));
}

void MendLinesItem::paint_handles(QPainter& painter, const MendContour& contour) const {
    const MendView& view = *session_->view();
    const MendSelection& selection = *session_->selection();
    const std::size_t count = contour.nodes.size();
    for (std::size_t i = 0; i < count; ++i) { // stalks first, under every point
        if (contour.nodes[i].on_curve())
            continue;
        for (const std::size_t beside : {(i + count - 1) % count, (i + 1) % count}) {
            const QLineF stalk(view.to_window(contour.nodes[i].at), view.to_window(contour.nodes[beside].at));
            painter.setPen(mend_pen(dark, 3.0));
            painter.drawLine(stalk);
            painter.setPen(mend_pen(QColor(255, 255, 255, 200), 1.0));
            painter.drawLine(stalk);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const QPointF at = view.to_window(contour.nodes[i].at);
        const bool held = static_cast<int>(i) == selection.handle() || selection.wholeFeature();
        const double size = held ? 9.0 : 6.5;
        painter.setPen(mend_pen(dark, held ? 3.0 : 2.0));
        painter.setBrush(held ? highlight_color_ : QColor(Qt::white));
        if (contour.nodes[i].kind == MendNode::Kind::corner) {
            painter.drawRect(QRectF(at - QPointF(size, size), at + QPointF(size, size)));
        } else if (contour.nodes[i].kind == MendNode::Kind::smooth) {
            painter.drawEllipse(at, size, size);
        } else {
            painter.drawEllipse(at, 0.8 * size, 0.8 * size);
            painter.setBrush(dark);
            painter.drawEllipse(at, 0.3 * size, 0.3 * size);
        }
    }
}

void MendLinesItem::paint(QPainter* painter) {
    if (!session_)
        return;
    painter->setRenderHint(QPainter::Antialiasing);
    const MendContour* in_hand = session_->selection()->line();
    for (const MendFace& face : session_->photo()->work().faces)
        for (const MendFeature& feature : face.features)
            if (feature.line && &*feature.line != in_hand)
                paint_line(*painter, *feature.line, line_color_, 1.5);
    if (in_hand) {
        paint_line(*painter, *in_hand, highlight_color_, 2.5);
        paint_handles(*painter, *in_hand);
    }
}

} // namespace tp
