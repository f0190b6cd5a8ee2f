// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_ear.hpp"
#include "app/pages/explore/explore_finger.hpp"
#include "app/pages/explore/explore_tour.hpp"
#include "app/pages/explore/explore_view.hpp"
#include "app/pages/explore/explore_words.hpp"
#include "app/pages/explore/touch_gestures.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/parts/finger/page_clock.hpp"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// What mouse, screen and keys do to the finger, and what several fingers mean. Places are in the sheet's
/// frame (see SheetFrame). Where a device moves the finger, none of them does.
class ExploreHand final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")
public:
    /// All must outlive this.
    ExploreHand(FingerServo& servo, ExploreView& view, ExploreFinger& finger, ExploreTour& tour,
                ExploreEar& ear, ExploreWords& words, const PageClock& now);

    /// The hand comes in there (mouse).
    Q_INVOKABLE void touchDown(double x, double y);
    /// The hand is there now; the same place again is no movement.
    Q_INVOKABLE void moveTo(double x, double y);
    /// The mouse is off the surface.
    Q_INVOKABLE void handGone();
    /// The hand moves by so many millimetres (arrow keys).
    Q_INVOKABLE void nudge(double dx, double dy);
    /// Fingers on a touchscreen; `id` tells them apart. One explores, several make gestures (TouchGestures).
    Q_INVOKABLE void fingerDown(int id, double x, double y);
    Q_INVOKABLE void fingerMoved(int id, double x, double y);
    Q_INVOKABLE void fingerUp(int id);
    Q_INVOKABLE void fingersCancelled();

    /// To the next (+1) or previous (-1) feature; false where there is none left, so that the keyboard's
    /// focus may leave the surface.
    Q_INVOKABLE bool stepFeature(int step);
    /// Sets the finger down on that feature; where a device moves it, tells the way.
    Q_INVOKABLE void goToFeature(int index);

signals:
    /// Fingers that were lifted meant something.
    void meant(tp::TouchGestures::Gesture gesture);

private:
    void set_down(QPointF place);
    void move_to(QPointF place);
    void lift();
    void tell_way_to(int feature);

    FingerServo& servo_;
    ExploreView& view_;
    ExploreFinger& finger_;
    ExploreTour& tour_;
    ExploreEar& ear_;
    ExploreWords& words_;
    const PageClock& now_;
    TouchGestures gestures_;
};

} // namespace tp
