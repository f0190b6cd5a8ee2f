// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_settings.hpp"
#include "app/pages/explore/explore_words.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "app/photo/scene/extra_features.hpp"
#include "core/touch/touch_loop.hpp"
#include "device/touch_output/touch_registry.hpp"

#include <QObject>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// What the person has chosen for the explore page: how strong the force is, what guides beside it, what is
/// felt. Kept in the preferences; the strongest force holds for the servo at once.
class ExploreChoices final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    /// N
    Q_PROPERTY(double maxForce READ maxForce WRITE setMaxForce NOTIFY changed)
    /// What guides where no force does: index into guideNames.
    Q_PROPERTY(int guide READ guide WRITE setGuide NOTIFY changed)
    Q_PROPERTY(QStringList guideNames READ guideNames NOTIFY changed)
public:
    /// All must outlive this; `settings` has what the program chose.
    ExploreChoices(Preferences& preferences, FingerServo& servo, ExploreWords& words,
                   const ExploreSettings& settings);

    double maxForce() const;
    void setMaxForce(double newtons);
    int guide() const { return static_cast<int>(preferences_.choices().guide); }
    void setGuide(int guide);
    QStringList guideNames() const;
    /// The next kind of guide, and says which.
    Q_INVOKABLE void nextGuide();

    /// The guide beeps, also in place of ticks where nothing can tick; it says clock directions.
    bool beeps() const;
    bool speaks() const;
    /// The guide ticks under the finger, where something there can.
    bool ticks() const;
    /// By key_of; the output that ticks.
    QString touch() const { return preferences_.choices().touch; }
    /// How that output ticks.
    TouchSettings touch_settings(const ListedTouchOutput& output) const;
    /// Which features are felt beside eyes, mouth and outline.
    ExtraFeatures extras() const;
    /// By key_of; the device that moves the finger.
    QString device() const { return preferences_.choices().device; }

signals:
    void changed();

private:
    Preferences& preferences_;
    FingerServo& servo_;
    ExploreWords& words_;
    ExtraFeatures more_;
    double strongest_; ///< N, that the servo allows
};

} // namespace tp
