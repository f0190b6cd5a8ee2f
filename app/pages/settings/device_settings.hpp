// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/devices/calibration_steps.hpp"
#include "app/parts/devices/device_connector.hpp"
#include "app/parts/devices/joystick_measuring.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "core/servo/servo_loop.hpp"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace tp {

/// The force devices on the settings page: which there are, a try-out of the strongest force, the calibration of one that lies
/// on the screen, and the measuring of a stick. What is done with one:
///
/// |                      | asked for           | open, homed        | spoken        | polled                                 |
/// |----------------------|---------------------|--------------------|---------------|----------------------------------------|
/// | nothing              | homing, opening_to… |                    |               |                                        |
/// | homing               |                     | nothing            |               |                                        |
/// | opening_to_try       |                     | announcing_trial   |               |                                        |
/// | announcing_trial     |                     |                    | about_to_pull |                                        |
/// | about_to_pull        |                     |                    |               | pulling_right                          |
/// | pulling_right        |                     |                    |               | pulling_left after pull_s              |
/// | pulling_left         |                     |                    |               | nothing after pull_s                   |
/// | opening_to_calibrate |                     | calibrating        |               |                                        |
/// | calibrating          |                     |                    |               | nothing after the last corner          |
/// | opening_to_measure   |                     | announcing_measure |               |                                        |
/// | announcing_measure   |                     |                    | measuring     |                                        |
/// | measuring            |                     |                    |               | nothing where it failed, or is weighed |
///
/// Escape, a page that is left, a fault that lasts and a refusal lead from each to nothing, and nothing has no force.
class DeviceSettings final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    /// None first, then what is plugged in with how each is reached, then a chosen one that is not.
    Q_PROPERTY(QStringList names READ names NOTIFY changed)
    Q_PROPERTY(int current READ current NOTIFY changed)
    /// One that is plugged in serves the person.
    Q_PROPERTY(bool there READ there NOTIFY changed)
    /// Whether it is calibrated and how well, in a sentence.
    Q_PROPERTY(QString calibration READ calibration NOTIFY changed)
    Q_PROPERTY(bool calibrating READ calibrating NOTIFY changed)
    /// It is a stick whose strength a person can measure; it is being measured; its pull waits to be weighed.
    Q_PROPERTY(bool measurable READ measurable NOTIFY changed)
    Q_PROPERTY(bool measuring READ measuring NOTIFY changed)
    Q_PROPERTY(bool weighing READ weighing NOTIFY changed)
    /// The corner to be touched (CalibrationSteps::Mark), and the words for what is to be done now.
    Q_PROPERTY(int mark READ mark NOTIFY changed)
    Q_PROPERTY(QString instruction READ instruction NOTIFY changed)
public:
    struct Setup {
        DeviceAccess access;
        ServoSettings servo;
        std::function<double()> now; ///< seconds; empty: real time
    };
    static constexpr double pull_s = 1.25; ///< of each of the try-out's two pulls

    /// Narrator and preferences must outlive it.
    DeviceSettings(Narrator& narrator, Preferences& preferences, Setup setup);

    QStringList names() const;
    int current() const;
    bool there() const { return serving() != nullptr; }
    QString calibration() const;
    bool calibrating() const { return doing_ == Doing::calibrating; }
    bool measurable() const { return there() && !serving()->scale_key.empty(); }
    bool measuring() const { return measuring_.has_value(); }
    bool weighing() const { return measuring_ && measuring_->trial().step() == JoystickTrial::Step::weigh; }
    int mark() const { return steps_ ? steps_->mark() : CalibrationSteps::top_left; }
    QString instruction() const;
    /// What the choice of the one with that index in `names` is remembered by; nothing where there is none.
    std::optional<QString> key_at(int index) const;

    /// Where calibrations are kept.
    const std::filesystem::path& calibrations() const { return setup_.access.calibrations; }

    /// The page comes into sight and goes out of it: nothing of a device is held behind it.
    void enter();
    void leave();

    /// Pulls the finger with the strongest force to the right, then to the left, 2.5 s in all.
    Q_INVOKABLE void tryForce();
    Q_INVOKABLE void calibrate();
    Q_INVOKABLE void measure();
    /// What the scale shows while the stick pulls, in grams as a person writes them.
    Q_INVOKABLE void weighed(const QString& grams);
    /// The handle stands on its mark: the device counts from there.
    Q_INVOKABLE void home();
    /// Where the area to be touched lies on the screen, mm from its top left corner, x right, y down.
    Q_INVOKABLE void areaLies(double left, double top, double width, double height);
    /// A finger is there, in the same frame.
    Q_INVOKABLE void touched(double x, double y);
    Q_INVOKABLE void lifted();
    /// Ends try-out and calibration; false where there was none.
    Q_INVOKABLE bool stop();

signals:
    void changed();

private:
    enum class Doing {
        nothing,
        homing,
        opening_to_try,
        announcing_trial,
        about_to_pull,
        pulling_right,
        pulling_left,
        opening_to_calibrate,
        calibrating,
        opening_to_measure,
        announcing_measure,
        measuring,
    };

    double now() const;
    const ListedDevice* serving() const;
    QString name_of(const ListedDevice& device) const;
    void begin(Doing what);
    void opened(OpenDevice& open);
    void announce();
    void poll();
    bool tells_fault(const ServoSnapshot& seen, double time);
    void pull(Doing which);
    void sample(Vec2 device);
    void poll_measuring();
    void finish();
    QString result();
    void end(const QString& sentence, Priority priority = Priority::message);

    Narrator& narrator_;
    Preferences& preferences_;
    Setup setup_;
    QElapsedTimer clock_;
    QTimer timer_;
    Doing doing_ = Doing::nothing;
    std::unique_ptr<DeviceDrive> drive_;
    QString key_;                    ///< of the open device
    std::string scale_key_;          ///< of the open stick
    double pulls_since_ = 0.0;       ///< s, in the pulling states
    double faulty_from_ = -1.0; ///< s; negative: no fault
    std::optional<CalibrationSteps> steps_;
    std::optional<Vec2> touch_;               ///< screen frame
    std::optional<JoystickMeasuring> measuring_; ///< goes before the drive it uses
    DeviceConnector connector_;                  ///< last: its work ends first
};

} // namespace tp
