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
    if (session_) {
        disconnect(session_->photo(), nullptr, this, nullptr);
        disconnect(session_->view(), nullptr, this, nullptr);
        disconnect(session_->preview(), nullptr, this, nullptr);
    }
    session_ = session;
    if (session_) {
        const auto draw = [this] { update(); };
        connect(session_->photo(), &MendedPhoto::stateChanged, this, draw);
        connect(session_->view(), &MendView::changed, this, draw);
        connect(session_->preview(), &MendPreview::shownChanged, this, draw);
        connect(session_->preview(), &MendPreview::changed, this, [this] {
            if (session_->preview()->forceShown())
                update();
        });
    }
    update();
    emit changed();
}

void MendPictureItem::paint(QPainter* painter) {
    if (!session_)
        return;
    const MendView& view = *session_->view();
    const QRectF window(0.0, 0.0, width(), height());
    painter->setRenderHint(QPainter::SmoothPixmapTransform, view.scale() < 8.0);
    draw_seen(*painter, session_->photo()->picture(), view.photo_rect(), window);
    const FeltChange& felt = session_->preview()->felt();
    if (!session_->preview()->forceShown() || felt.field.isNull())
        return;
    const auto corner = [&](QPointF p) { return view.to_window({p.x(), p.y()}); };
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    draw_seen(*painter, felt.field, {corner(felt.place.topLeft()), corner(felt.place.bottomRight())}, window);
}

} // namespace tp
