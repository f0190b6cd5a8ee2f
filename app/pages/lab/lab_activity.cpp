// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_activity.hpp"

namespace tp {

void LabActivity::become(State state) {
    if (state == state_)
        return;
    state_ = state;
    emit changed();
}

bool LabActivity::refuses_change() {
    if (recording())
        teller_.tell(tr("Nothing can be changed during a recording. Escape ends it."));
    else if (state_ == Replaying)
        teller_.tell(tr("Nothing can be changed during a replay. Escape ends it."));
    return fixed();
}

} // namespace tp
