// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/study/study_settings.hpp"
#include "app/parts/devices/device_connector.hpp"
#include "app/parts/finger/fault_watch.hpp"
#include "app/parts/finger/finger_servo.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "core/geometry/vec.hpp"
#include "core/servo/snapshot.hpp"

#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <string>

namespace tp {

/// The participant's finger: moved by a force device, or drawn, with mouse, touch and arrow keys as its hand. Nobody sees the
/// drawn one; it is set down where a trial begins, and the hand moves it from there, wherever the mouse is.
///
/// Force goes out only between `feel` or `bring` and `stop`, and only through the servo's safety chain. Places in the surface
/// frame, mm.
class StudyFinger final : public QObject {
    Q_OBJECT
public:
    /// All must outlive it.
    StudyFinger(const StudySettings& settings, Preferences& preferences);
    ~StudyFinger() override;

    /// Looks for devices while somebody may choose one.
    void look(bool on);
    /// The device that would be used, in the person's language; empty: none is there.
    QString found() const;

    /// What a study asks of the finger.
    struct Wish {
        Vec2 surface{0.0};          ///< its size, mm
        bool device = false;        ///< a device's; else a drawn one
        double pull_n = 0.0;        ///< the strongest pull that it asks for
        bool force_allowed = false; ///< the researcher consents to that pull, whatever the person's own limit
    };
    /// A finger on that surface. With `device` the one that was found is opened: `taken` or `refused` follows, at once where none is
    /// wanted.
    void take(const Wish& wish);
    /// The person's own limit, which holds where the researcher has not consented to more, N.
    double persons_limit_n() const;
    /// The strongest pull on the finger that was taken, N; and whether that is less than the study asks for.
    double limit_n() const { return limit_n_; }
    bool is_cut() const { return limit_n_ < wish_.pull_n - 1e-9; }
    /// The device is given back, and nothing ticks any more.
    void give_back();
    bool here() const { return servo_ != nullptr && !opening_; }
    bool real() const { return servo_ != nullptr && servo_->real(); }
    /// The device with its strongest force, or the mouse; in English, for the record.
    std::string about() const;
    /// Its calibration, for the record; empty: none is known.
    std::string calibration() const { return calibration_; }

    /// What is felt from now on, still without force; the sentence that says why not, or empty.
    std::string lay(FingerServo::Make make);
    /// Brings the finger there: a device leads it, the drawn one is set down.
    void bring(Vec2 place);
    /// It has come; the force is off again.
    bool brought();
    /// The force of what was laid is felt; a drawn finger is set down at `start`.
    void feel(Vec2 start);
    /// No force any more, at once.
    void stop();
    /// The hand of a drawn finger moves by so many millimetres, x right, y up.
    void move_by(Vec2 way);

    ServoSnapshot seen() const { return servo_->snapshot(); }
    Vec2 place() const { return servo_->finger(); }
    /// What is felt, for the researcher's own eyes.
    const FlatScene& felt() const { return servo_->felt(); }
    bool has_servo() const { return servo_ != nullptr; }
    /// Faults of the servo, at `now` seconds of any clock: tells them by `troubled`.
    void watch(double now);
    void pass(double seconds);

signals:
    /// What devices are there has changed.
    void changed();
    void taken();
    /// A sentence for a person, with what to do.
    void refused(const QString& sentence);
    /// Something is wrong; `ends`: the force has gone for good.
    void troubled(const QString& sentence, bool ends);

private:
    const ListedDevice* wanted() const;
    void use(OpenDevice& open);
    bool reaches(const OpenDevice& open) const;
    /// At most `device_n`, which is what the device gives, N.
    void choose_limit(double device_n);
    std::string recorded(QStringList about) const;

    const StudySettings& settings_;
    Preferences& preferences_;
    Wish wish_;
    double limit_n_ = 0.0;
    std::unique_ptr<FingerServo> servo_;
    FaultWatch faults_;
    std::string about_, calibration_; ///< of the device in use
    bool opening_ = false;
    bool looks_ = false;
    DeviceConnector connector_; ///< last: its work ends first
};

} // namespace tp
