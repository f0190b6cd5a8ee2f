// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_activity.hpp"
#include "app/pages/lab/lab_scene.hpp"
#include "app/pages/lab/lab_teller.hpp"
#include "core/geometry/vec.hpp"

#include <QObject>
#include <QPointF>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// The hand that the mouse or the keys move, the finger on the device, and the force on it.
///
/// A page's places are millimetres from the surface's top left corner, y down, as they are drawn; forces in
/// newtons likewise. The others have the surface's middle at 0, y up.
class LabHand final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(QPointF pointer READ pointer NOTIFY moved)
    Q_PROPERTY(QPointF finger READ finger NOTIFY moved)
    Q_PROPERTY(QPointF force READ force NOTIFY moved)
    Q_PROPERTY(double newtons READ newtons NOTIFY moved)
public:
    /// All must outlive it.
    LabHand(const LabScene& scene, const LabActivity& activity, LabTeller& teller);

    QPointF pointer() const { return to_sheet(pointer_); }
    QPointF finger() const { return to_sheet(finger_); }
    QPointF force() const { return {force_.x, -force_.y}; }
    double newtons() const { return length(force_); }
    Vec2 place() const { return pointer_; }

    Q_INVOKABLE void touchDown(double x, double y);
    Q_INVOKABLE void moveTo(double x, double y);
    Q_INVOKABLE void nudge(double dx, double dy);
    Q_INVOKABLE void whereAmI();

    /// Where a device has the finger, and what it exerts.
    void show(Vec2 finger, Vec2 force);
    /// The same of a recording, whose hand is not known.
    void replay(Vec2 finger, Vec2 force);
    /// Nothing pulls any more.
    void release();

signals:
    void moved();
    /// The hand is there now, with the finger under it, or leading it.
    void placed(tp::Vec2 place);
    void led(tp::Vec2 place);

private:
    QPointF to_sheet(Vec2 p) const;
    Vec2 to_surface(QPointF p) const;
    void go(double x, double y);

    const LabScene& scene_;
    const LabActivity& activity_;
    LabTeller& teller_;
    Vec2 pointer_{0.0}, finger_{0.0}, force_{0.0};
};

} // namespace tp
