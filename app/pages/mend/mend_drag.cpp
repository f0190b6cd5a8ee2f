// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_drag.hpp"

#include <QPointF>
#include <QString>

#include <utility>

namespace tp {

MendDrag::MendDrag(const MendedPhoto& photo, const MendView& view, MendSelection& selection,
                   MendHistory& history, Narrator& narrator)
    : photo_(photo), view_(view), selection_(selection), history_(history), narrator_(narrator) {
    connect(&photo, &MendedPhoto::replaced, this, [this] { state_ = State::Free; });
    connect(&selection, &MendSelection::leavingFeature, this, &MendDrag::cancel);
    connect(&history, &MendHistory::turning, this, &MendDrag::cancel);
}

bool MendDrag::grab(double x, double y, double reach) {
    if (!photo_.ready() || !selection_.line())
        return false;
    const auto handle = selection_.handle_at({x, y}, reach);
    if (!handle && !(selection_.wholeFeature() && selection_.line_at({x, y}, reach) == selection_.feature()))
        return false;
    history_.end_run();
    if (handle)
        selection_.take_handle(*handle);
    last_ = view_.to_photo({x, y});
    offset_ = handle ? selection_.line()->nodes[selection_.node()].at - last_ : Vec2(0.0);
    state_ = State::Held;
    return true;
}

void MendDrag::dragTo(double x, double y) {
    const bool whole = selection_.wholeFeature();
    if (state_ == State::Free || !selection_.line() || (!whole && selection_.handle() < 0))
        return;
    const Vec2 hand = view_.to_photo({x, y});
    if (hand == last_)
        return;
    state_ = State::Moving;
    const Vec2 before = std::exchange(last_, hand);
    const QString name = selection_.featureName();
    history_.step(
        whole ? tr("the %1 was moved").arg(name) : tr("a point of the %1 was moved").arg(name),
        [&](MendWork& work) {
            MendFeature& feature = selection_.own_in(work);
            feature.mended = true;
            if (whole)
                move_all(*feature.line, hand - before);
            else
                move_node(*feature.line, selection_.node(), hand + offset_);
        },
        QStringLiteral("drag"));
}

void MendDrag::drop() {
    const State was = std::exchange(state_, State::Free);
    if (was == State::Free)
        return;
    history_.end_run();
    if (was == State::Moving && selection_.wholeFeature())
        narrator_.tell(tr("%1 moved.").arg(selection_.featureName()), Priority::touch);
    else
        selection_.tell_handle();
}

bool MendDrag::cancel() {
    const State was = std::exchange(state_, State::Free);
    if (was == State::Moving) {
        history_.forget_newest();
        narrator_.tell(tr("Put back."), Priority::touch);
    }
    return was != State::Free;
}

} // namespace tp
