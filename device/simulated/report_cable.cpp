// SPDX-License-Identifier: Apache-2.0
#include "device/simulated/report_cable.hpp"

#include <cstddef>

namespace tp {

bool ReportCable::happens(double share) {
    return share > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(random_) < share;
}

void ReportCable::to_computer(Report report, const CableTroubles& troubles) {
    constexpr std::size_t most_waiting = 64; // as the system keeps of reports that nobody reads
    if (troubles.mute || troubles.unplugged || happens(troubles.drop))
        return;
    if (happens(troubles.garble))
        for (unsigned i = 0; i < 1 + random_() % 4; ++i)
            report[random_() % report.size()] = static_cast<std::uint8_t>(random_());
    if (happens(troubles.cut))
        report.resize(1 + random_() % report.size());
    to_computer_.push_back({now_ + delay_ms_, std::move(report)});
    if (to_computer_.size() > most_waiting)
        to_computer_.pop_front();
}

std::optional<ReportCable::Report> ReportCable::arrived(std::deque<UnderWay>& reports) const {
    if (reports.empty() || reports.front().due > now_)
        return std::nullopt;
    std::optional<Report> bytes = std::move(reports.front().bytes);
    reports.pop_front();
    return bytes;
}

} // namespace tp
