// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_picture_item.hpp"

namespace tp {

namespace {

/// Draws the part of `image` that is seen; all of it would lie in `place`.
void draw_seen(QPainter& painter, const QImage& image, const QRectF& place, const QRectF& window) {
    const QRectF seen = place & window;
    if (image.isNull() || seen.isEmpty())
        return;
    const double across = image.width() / place.width(), down = image.height() / place.height();
    painter.drawImage(seen, image,
                      {(seen.x() - place.x()) * across, (seen.y() - place.y()) * down, seen.width() * across,
                       seen.height() * down});
}

} // namespace

void MendPictureItem::setSession(MendSession* session) {
    if (session_ == session)
        return;
    if (session_)
        disconnect(session_, nullptr, this, nullptr);
    session_ = session;
    if (session_) {
        const auto draw = [this] { update(); };
        connect(session_, &MendSession::photoChanged, this, draw);
        connect(session_, &MendSession::viewChanged, this, draw);
        connect(session_, &MendSession::modeChanged, this, draw);
        connect(session_, &MendSession::fieldChanged, this, [this] {
            if (session_->forceShown())
                update();
        });
    }
    emit changed();
}

void MendPictureItem::paint(QPainter* painter) {
    if (!session_)
        return;
    const QRectF window(0.0, 0.0, width(), height());
    painter->setRenderHint(QPainter::SmoothPixmapTransform, session_->viewScale() < 8.0);
    draw_seen(*painter, session_->photo(), session_->photoRect(), window);
    const FeltChange& felt = session_->felt();
    if (!session_->forceShown() || felt.field.isNull())
        return;
    const auto corner = [&](QPointF p) { return session_->view().to_window({p.x(), p.y()}); };
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    draw_seen(*painter, felt.field, {corner(felt.place.topLeft()), corner(felt.place.bottomRight())}, window);
}

} // namespace tp
