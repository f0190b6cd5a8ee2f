// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/fault.hpp"

namespace tp {

/// Which of the servo's faults a person is told of. One that disables the device at once; one that heals by
/// itself only when it lasts, because a moment without force is over before its sentence has begun; and
/// neither again before it has been gone for a while.
class FaultWatch {
public:
    static constexpr double lasts_s = 0.5;
    static constexpr double gone_s = 3.0;

    /// Feeds what the servo says at `now` seconds; true where the fault must be told now.
    bool must_tell(Fault fault, double now);
    /// What a page shows: the fault that was told, as long as it is there.
    Fault shown() const { return shown_; }

private:
    Fault seen_ = Fault::none;
    double since_ = 0.0; ///< s, when `seen_` began
    Fault told_ = Fault::none;
    double last_there_ = 0.0; ///< s, when the told fault was last there
    Fault shown_ = Fault::none;
};

} // namespace tp
