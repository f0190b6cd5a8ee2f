// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_choices.hpp"
#include "app/pages/explore/explore_ear.hpp"
#include "app/pages/explore/explore_finger.hpp"
#include "app/pages/explore/explore_settings.hpp"
#include "app/pages/explore/explore_tour.hpp"
#include "app/pages/explore/explore_view.hpp"
#include "app/pages/explore/explore_words.hpp"
#include "app/pages/explore/sheet_place.hpp"
#include "app/parts/devices/device_connector.hpp"
#include "app/parts/finger/fault_watch.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/parts/finger/page_clock.hpp"
#include "core/servo/fault.hpp"

#include <QObject>
#include <QString>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <optional>
#include <string>

namespace tp {

/// What moves the finger: the force, and the device that gives it, found, opened and given back while the
/// page is in sight. Without a device the force is drawn.
///
/// |          | enter, engage | none is there | refused | opened | lost    | leave |
/// |----------|---------------|---------------|---------|--------|---------|-------|
/// | Away     | Expected (enter) |            |         |        |         |       |
/// | Expected |               | Awaited       | Awaited | InUse  |         | Away  |
/// | Awaited  | Expected      |               |         | InUse  |         | Away  |
/// | InUse    |               |               |         |        | Awaited | Away  |
class ExploreDevice final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    /// The force is on.
    Q_PROPERTY(bool engaged READ engaged NOTIFY changed)
    Q_PROPERTY(QString faultSentence READ faultSentence NOTIFY changed)
    /// The device that moves the finger; empty where it is only drawn.
    Q_PROPERTY(QString name READ name NOTIFY changed)
public:
    enum class State {
        Away,     ///< the page is out of sight: none is wanted
        Expected, ///< the person has just come or asked: one that is there gets the force at once
        Awaited,  ///< one that comes waits until the person lets its force in
        InUse     ///< it moves the finger
    };

    /// All must outlive this.
    ExploreDevice(FingerServo& servo, ExploreView& view, ExploreFinger& finger, ExploreTour& tour,
                  ExploreEar& ear, ExploreChoices& choices, ExploreWords& words,
                  const ExploreSettings& settings);

    State state() const { return state_; }
    bool here() const { return state_ != State::Away; }
    bool in_use() const { return state_ == State::InUse; }
    bool engaged() const { return servo_.engaged(); }
    QString faultSentence() const;
    QString name() const { return state_ == State::InUse ? about_ : QString(); }

    /// The page comes into sight: the force is as it was, a device is wanted.
    void enter();
    /// It goes out of sight: no force, no device.
    void leave();
    /// Lets the force in, and says so. Only where there is something to feel.
    Q_INVOKABLE void engage();
    void disengage();
    /// What is wrong with the servo now, at `now` seconds.
    void watch(Fault fault, double now);
    /// A person who has to know of it does.
    bool shows(Fault fault) const { return faults_.shown() == fault; }
    /// Where the sheet's top left corner lies on the screen, mm from the screen's (x right, y down), and how
    /// many real millimetres each of the sheet's is there. A calibrated device follows it once it lies still.
    Q_INVOKABLE void sheetLies(double left, double top, double scale);

signals:
    void changed();
    /// A device is about to move the finger, or does so no more.
    void in_use_changed();
    /// The person wants to feel.
    void engage_asked();
    /// A fault has switched the force off: everything that leads or sounds is to end.
    void disabled();

private:
    void want();
    void give_back();
    void look();
    void use(OpenDevice& open);
    void refuse(const QString& sentence);
    void lose();
    void follow_sheet();
    void let_in();

    FingerServo& servo_;
    ExploreView& view_;
    ExploreFinger& finger_;
    ExploreTour& tour_;
    ExploreEar& ear_;
    ExploreChoices& choices_;
    ExploreWords& words_;
    ServoSettings servo_settings_; ///< a device's
    State state_ = State::Awaited;
    FaultWatch faults_;
    bool force_wanted_ = true; ///< when the page comes back into sight
    QString about_;            ///< of the one in use
    std::string refused_;      ///< name of the one that could not be opened; it is not asked again by itself
    SheetPlace sheet_;
    std::optional<SheetPlace> device_sheet_; ///< as a calibrated device in use follows it
    QTimer sheet_settles_;                   ///< since it was last told to lie elsewhere
    DeviceConnector connector_;              ///< last: its work ends first
};

} // namespace tp
