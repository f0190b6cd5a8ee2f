// SPDX-License-Identifier: Apache-2.0
#include "app/parts/finger/fault_watch.hpp"

namespace tp {

bool FaultWatch::must_tell(Fault fault, double now) {
    if (fault != seen_) {
        seen_ = fault;
        since_ = now;
    }
    if (fault == told_ && fault != Fault::none)
        last_there_ = now;
    else if (now - last_there_ > gone_s)
        told_ = Fault::none;
    if (fault != shown_)
        shown_ = fault == told_ ? fault : Fault::none;
    if (fault == Fault::motors_off && fault == told_ && now - told_at_ >= remind_s &&
        reminders_ < most_reminders) {
        ++reminders_;
        told_at_ = now;
        return true;
    }
    if (fault == Fault::none || fault == told_)
        return false;
    if (!disables(fault) && now - since_ < lasts_s)
        return false;
    told_ = shown_ = fault;
    last_there_ = told_at_ = now;
    reminders_ = 0;
    return true;
}

bool FaultWatch::must_tell_ready(double now) {
    if (told_ != Fault::motors_off || seen_ != Fault::none || now - since_ < lasts_s)
        return false;
    told_ = Fault::none; // off once more is told once more
    return true;
}

} // namespace tp
