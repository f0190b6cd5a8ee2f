// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/browse/stroke_gestures.hpp"

#include <QMouseEvent>
#include <QPointF>
#include <QQuickItem>
#include <QTouchEvent>
#include <QtQml/qqmlregistration.h>

#include <map>

namespace tp {

/// Hears gestures of fingers; the mouse is one finger.
class GestureArea : public QQuickItem {
    Q_OBJECT
    QML_ELEMENT
public:
    explicit GestureArea(QQuickItem* parent = nullptr);

signals:
    void tapped();
    void doubleTapped();
    void swipedLeft();
    void swipedRight();
    void swipedUp();
    void swipedDown();
    void twoFingerTapped();
    void twoFingerDoubleTapped();
    void drawnZ();
    void threeFingerTapped();

protected:
    void touchEvent(QTouchEvent* event) override;
    void touchUngrabEvent() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseUngrabEvent() override;

private:
    void look(qint64 now_ms);

    StrokeGestures gestures_;
    std::map<int, QPointF> fingers_; ///< that are down
};

} // namespace tp
