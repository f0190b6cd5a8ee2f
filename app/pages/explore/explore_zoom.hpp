// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_finger.hpp"
#include "app/pages/explore/explore_tour.hpp"
#include "app/pages/explore/explore_view.hpp"
#include "app/pages/explore/explore_words.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/parts/finger/page_clock.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// How much of a face fills the surface: step by step, by a place, by a face.
class ExploreZoom final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(bool zoomed READ zoomed NOTIFY changed)
public:
    /// All must outlive this.
    ExploreZoom(FingerServo& servo, ExploreView& view, ExploreFinger& finger, ExploreTour& tour,
                ExploreWords& words, const PageClock& now);

    bool zoomed() const { return view_.subject() != Subject{}; }

    /// The face under the finger, its eyes, its mouth, everything again (zoom_steps.hpp).
    Q_INVOKABLE void zoomIn();
    Q_INVOKABLE void zoomOut();
    /// To what lies at a place (sheet's frame); out where nothing does.
    Q_INVOKABLE void zoomHere(double x, double y);
    /// Fits one face into the surface; -1: all of them.
    Q_INVOKABLE void chooseFace(int index);
    /// All faces, the first, the second, …, all faces.
    Q_INVOKABLE void nextFace();

    /// A zoom is being told and the hand has rested since: what it is drawn to then is told afterwards.
    bool tells(double now) const;

signals:
    void changed();

private:
    bool ready();
    void zoom_to(const Subject& subject);
    QString sentence() const;

    FingerServo& servo_;
    ExploreView& view_;
    ExploreFinger& finger_;
    ExploreTour& tour_;
    ExploreWords& words_;
    const PageClock& now_;
    double zoomed_at_ = -1e9, told_at_ = -1e9; ///< s, the last zoom, and when its sentence has been spoken
    Vec2 zoomed_from_{0.0};                    ///< where the finger was then, surface frame
};

} // namespace tp
