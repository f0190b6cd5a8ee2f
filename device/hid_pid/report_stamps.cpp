// SPDX-License-Identifier: Apache-2.0
#include "device/hid_pid/report_stamps.hpp"

#include <algorithm>

namespace tp {

void ReportStamps::reported(const hid::Report& report, double now) noexcept {
    const bool same = said_at_ && now - *said_at_ <= rest_gap && report.size == said_.size &&
                      std::equal(report.all().begin(), report.all().end(), said_.all().begin());
    if (!same)
        same_since_ = now;
    speaks_at_rest_ = speaks_at_rest_ || now - same_since_ >= rest_known_after;
    said_ = report;
    said_at_ = now;
}

std::optional<double> ReportStamps::next(double taken_at) noexcept {
    const double alive_at = speaks_at_rest_ ? *said_at_ : std::max(said_at_.value_or(taken_at), taken_at);
    if (last_ && !(alive_at > *last_))
        return std::nullopt;
    return last_ = alive_at;
}

} // namespace tp
