// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/hid_haptics/simulated_haptics_link.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace tp {

bool SimulatedHapticsLink::happens(double share) {
    return share > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(random_) < share;
}

void SimulatedHapticsLink::advance() {
    constexpr std::size_t most_waiting = 64; // as the system keeps of reports that nobody reads
    ++now_;
    while (!to_pad_.empty() && to_pad_.front().due <= now_) {
        pad_.receive(to_pad_.front().bytes);
        to_pad_.pop_front();
    }
    pad_.step();
    std::vector<std::uint8_t> bytes;
    while (pad_.report(bytes)) {
        if (troubles.mute || troubles.unplugged || happens(troubles.drop))
            continue;
        if (happens(troubles.garble))
            for (unsigned i = 0; i < 1 + random_() % 4; ++i)
                bytes[random_() % bytes.size()] = static_cast<std::uint8_t>(random_());
        if (happens(troubles.cut))
            bytes.resize(1 + random_() % bytes.size());
        from_pad_.push_back({now_ + delay_ms_, bytes});
        if (from_pad_.size() > most_waiting)
            from_pad_.pop_front();
    }
}

HapticsTransport::Got SimulatedHapticsLink::read(Input& report, int wait_ms) noexcept {
    for (;; --wait_ms) {
        if (troubles.unplugged)
            return Got::lost;
        if (!from_pad_.empty() && from_pad_.front().due <= now_) {
            const std::vector<std::uint8_t> bytes = std::move(from_pad_.front().bytes);
            from_pad_.pop_front();
            report.size = std::min(bytes.size(), report.bytes.size());
            std::copy_n(bytes.begin(), report.size, report.bytes.begin());
            return Got::report;
        }
        if (wait_ms <= 0)
            return Got::nothing;
        advance();
    }
}

bool SimulatedHapticsLink::send(const haptics::Output& report) noexcept {
    ++sends_;
    if (troubles.unplugged || happens(troubles.refuse))
        return false;
    if (!troubles.deaf)
        to_pad_.push_back({now_ + 1 + delay_ms_, {report.all().begin(), report.all().end()}});
    return true;
}

std::vector<std::uint8_t> SimulatedHapticsLink::descriptor() {
    return troubles.lie.empty() ? std::vector<std::uint8_t>(ModelHapticPad::descriptor().begin(),
                                                            ModelHapticPad::descriptor().end())
                                : troubles.lie;
}

std::vector<std::uint8_t> SimulatedHapticsLink::feature(std::uint8_t id, std::size_t bytes) {
    if (troubles.unplugged || troubles.deaf || troubles.mute)
        return {};
    std::vector<std::uint8_t> report = pad_.feature(id);
    report.resize(std::min(report.size(), bytes));
    return report;
}

} // namespace tp
