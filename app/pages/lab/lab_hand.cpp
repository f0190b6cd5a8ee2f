// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_hand.hpp"

#include "app/pages/lab/lab_words.hpp"

#include <QLocale>
#include <QString>

#include <cstddef>

namespace tp {

LabHand::LabHand(const LabScene& scene, const LabActivity& activity, LabTeller& teller)
    : scene_(scene), activity_(activity), teller_(teller) {}

QPointF LabHand::to_sheet(Vec2 p) const {
    const Rect area = scene_.surface();
    return {p.x - area.min.x, area.max.y - p.y};
}

Vec2 LabHand::to_surface(QPointF p) const {
    const Rect area = scene_.surface();
    return glm::clamp(Vec2(p.x() + area.min.x, area.max.y - p.y()), area.min, area.max);
}

void LabHand::go(double x, double y) {
    pointer_ = to_surface({x, y});
    if (activity_.stopped())
        finger_ = pointer_;
}

void LabHand::touchDown(double x, double y) {
    go(x, y);
    emit placed(pointer_);
    emit moved();
}

void LabHand::moveTo(double x, double y) {
    go(x, y);
    emit led(pointer_);
    emit moved();
}

void LabHand::nudge(double dx, double dy) {
    const QPointF to = pointer() + QPointF(dx, dy);
    moveTo(to.x(), to.y());
}

void LabHand::show(Vec2 finger, Vec2 force) {
    finger_ = finger;
    force_ = force;
    emit moved();
}

void LabHand::replay(Vec2 finger, Vec2 force) {
    pointer_ = finger;
    show(finger, force);
}

void LabHand::release() {
    force_ = Vec2(0.0);
    emit moved();
}

void LabHand::whereAmI() {
    const HapticScene& felt = scene_.felt();
    const Guidance guidance = felt.law->at(finger_);
    QString sentence = tr("The finger is %1. ").arg(middle_words(finger_));
    if (guidance.contour < 0 || !(guidance.distance < felt.profile.band()))
        sentence += tr("No line pulls there.");
    else
        sentence +=
            tr("%1 mm from %2; the law pulls with %3 newtons.")
                .arg(QLocale().toString(guidance.distance, 'f', 1),
                     QString::fromStdString(felt.flat.names[static_cast<std::size_t>(guidance.contour)]),
                     QLocale().toString(length(guidance.force), 'f', 2));
    teller_.tell(sentence);
}

} // namespace tp
