// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/fault.hpp"

namespace tp {

/// Which of the servo's faults a person is told of. One that disables the device at once; one that heals by
/// itself only when it lasts, because a moment without force is over before its sentence has begun; and
/// neither again before it has been gone for a while. Motors that are off wait for what a person does, such as
/// homing the handle: that is told again a few times, and so is that they obey.
class FaultWatch {
public:
    static constexpr double lasts_s = 0.5;
    static constexpr double gone_s = 3.0;
    static constexpr double remind_s = 15.0;
    static constexpr int most_reminders = 4;

    /// Feeds what the servo says at `now` seconds; true where the fault must be told now.
    bool must_tell(Fault fault, double now);
    /// Asked after that: true once where the person must be told that the motors, which were off, obey again.
    bool must_tell_ready(double now);
    /// What a page shows: the fault that was told, as long as it is there.
    Fault shown() const { return shown_; }

private:
    Fault seen_ = Fault::none;
    double since_ = 0.0; ///< s, when `seen_` began
    Fault told_ = Fault::none;
    double last_there_ = 0.0; ///< s, when the told fault was last there
    double told_at_ = 0.0;    ///< s
    int reminders_ = 0;       ///< of the told fault
    Fault shown_ = Fault::none;
};

} // namespace tp
