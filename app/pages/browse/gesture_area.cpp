// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/gesture_area.hpp"

#include <QEvent>
#include <QEventPoint>

#include <vector>

namespace tp {

namespace {
constexpr int mouse_id = -1;
}

GestureArea::GestureArea(QQuickItem* parent) : QQuickItem(parent) {
    setAcceptTouchEvents(true);
    setAcceptedMouseButtons(Qt::LeftButton);
}

void GestureArea::touchEvent(QTouchEvent* event) {
    if (event->type() == QEvent::TouchCancel) {
        touchUngrabEvent();
        return;
    }
    for (const QEventPoint& point : event->points())
        fingers_[point.id()] = point.position();
    look(static_cast<qint64>(event->timestamp()));
    for (const QEventPoint& point : event->points())
        if (point.state() == QEventPoint::Released)
            fingers_.erase(point.id());
    look(static_cast<qint64>(event->timestamp()));
    event->accept();
}

void GestureArea::touchUngrabEvent() {
    if (fingers_.empty())
        return; // it also comes when the last finger was lifted
    fingers_.clear();
    gestures_.cancel();
}

void GestureArea::mousePressEvent(QMouseEvent* event) {
    fingers_[mouse_id] = event->position();
    look(static_cast<qint64>(event->timestamp()));
}

void GestureArea::mouseMoveEvent(QMouseEvent* event) {
    fingers_[mouse_id] = event->position();
    look(static_cast<qint64>(event->timestamp()));
}

void GestureArea::mouseReleaseEvent(QMouseEvent* event) {
    fingers_.erase(mouse_id);
    look(static_cast<qint64>(event->timestamp()));
}

void GestureArea::mouseUngrabEvent() { touchUngrabEvent(); }

void GestureArea::look(qint64 now_ms) {
    std::vector<QPointF> places;
    for (const auto& [id, place] : fingers_)
        places.push_back(place);
    const std::optional<Gesture> gesture = gestures_.fingers(places, now_ms);
    if (!gesture)
        return;
    switch (*gesture) {
    case Gesture::tap:
        emit tapped();
        break;
    case Gesture::double_tap:
        emit doubleTapped();
        break;
    case Gesture::swipe_left:
        emit swipedLeft();
        break;
    case Gesture::swipe_right:
        emit swipedRight();
        break;
    case Gesture::swipe_up:
        emit swipedUp();
        break;
    case Gesture::swipe_down:
        emit swipedDown();
        break;
    case Gesture::two_finger_tap:
        emit twoFingerTapped();
        break;
    case Gesture::two_finger_double_tap:
        emit twoFingerDoubleTapped();
        break;
    case Gesture::two_finger_z:
        emit drawnZ();
        break;
    case Gesture::three_finger_tap:
        emit threeFingerTapped();
        break;
    }
}

} // namespace tp
