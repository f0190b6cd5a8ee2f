// SPDX-License-Identifier: Apache-2.0
#include "app/pages/study/felt_trial.hpp"

namespace tp {

void FeltTrial::feed(const ServoSnapshot& seen, Vec2 place) {
    if (seen.ticks < from_ || too_long() || (began_s_ && seen.time <= newest_s_))
        return;
    if (!began_s_)
        began_s_ = seen.time;
    newest_s_ = seen.time;
    path_.push_back({seen.time - *began_s_, place.x, place.y, seen.fx, seen.fy});
    judge_.feed(seen.time, place);
}

TrialRecord FeltTrial::record(int participant, bool repeated) const {
    TrialRecord record = begun_record(next_, participant);
    record.error_mm = judge_.error_mm();
    record.time_s = judge_.time_s();
    record.repeated = repeated;
    return record;
}

} // namespace tp
