// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/devices/joystick_trial.hpp"
#include "core/base/result.hpp"
#include "core/servo/force_device.hpp"
#include "core/servo/servo_loop.hpp"

#include <QCoreApplication>
#include <QString>

#include <memory>
#include <optional>

namespace tp {

/// A line beside the finger whose tent has `newtons` as its peak, where the finger is: as strong as it says, and the
/// finger settles on the line, `reach_mm` away in the direction of the unit vector `toward`.
std::unique_ptr<HapticScene> line_that_pulls(Vec2 finger, Vec2 toward, double newtons, double reach_mm);

/// A `JoystickTrial` with the stick whose pulls it wants: they go through the loop and its safety chain. The device frame is
/// the loop's surface frame.
class JoystickMeasuring {
    Q_DECLARE_TR_FUNCTIONS(JoystickMeasuring)
public:
    /// Device and loop must outlive it; the device lets itself be assumed (ForceDevice::assume).
    JoystickMeasuring(ForceDevice& device, ServoLoop& loop) : device_(device), loop_(loop) {}

    const JoystickTrial& trial() const { return trial_; }
    /// What a person is told as a step begins, or that it failed and what to do.
    QString words() const;
    /// Asked about every 16 ms. True where a step has ended, or all failed.
    bool poll(double now);
    /// What the scale shows while the stick pulls; as JoystickTrial::weighed.
    Result<bool> weighed(double grams, double now);

private:
    void want(double now);
    void draw(Vec2 finger);

    ForceDevice& device_;
    ServoLoop& loop_;
    JoystickTrial trial_;
    std::optional<double> pulls_at_; ///< s; the force before it is gone by then
    std::optional<Vec2> drawn_at_;   ///< where the grip was when the line was drawn
};

} // namespace tp
