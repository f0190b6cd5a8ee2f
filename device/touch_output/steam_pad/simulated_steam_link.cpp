// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/steam_pad/simulated_steam_link.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace tp {

bool SimulatedSteamLink::happens(double share) {
    return share > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(random_) < share;
}

void SimulatedSteamLink::advance() {
    constexpr std::size_t most_waiting = 64; // as the system keeps of reports that nobody reads
    ++now_;
    while (!to_pads_.empty() && to_pads_.front().due <= now_) {
        pads_.receive(to_pads_.front().bytes);
        to_pads_.pop_front();
    }
    pads_.step();
    std::vector<std::uint8_t> bytes;
    while (pads_.report(bytes)) {
        if (troubles.mute || troubles.unplugged || happens(troubles.drop))
            continue;
        if (happens(troubles.garble))
            for (unsigned i = 0; i < 1 + random_() % 4; ++i)
                bytes[random_() % bytes.size()] = static_cast<std::uint8_t>(random_());
        if (happens(troubles.cut))
            bytes.resize(1 + random_() % bytes.size());
        from_pads_.push_back({now_ + delay_ms_, bytes});
        if (from_pads_.size() > most_waiting)
            from_pads_.pop_front();
    }
}

SteamTransport::Got SimulatedSteamLink::read(Input& report, int wait_ms) noexcept {
    for (;; --wait_ms) {
        if (troubles.unplugged)
            return Got::lost;
        if (!from_pads_.empty() && from_pads_.front().due <= now_) {
            const std::vector<std::uint8_t> bytes = std::move(from_pads_.front().bytes);
            from_pads_.pop_front();
            report.size = std::min(bytes.size(), report.bytes.size());
            std::copy_n(bytes.begin(), report.size, report.bytes.begin());
            return Got::report;
        }
        if (wait_ms <= 0)
            return Got::nothing;
        advance();
    }
}

bool SimulatedSteamLink::send(const steam::Feature& report) noexcept {
    ++sends_;
    constexpr std::uint8_t asks_the_receiver = 0xB4;
    if (troubles.unplugged || happens(troubles.refuse) || (!pads_.on() && report[1] != asks_the_receiver))
        return false;
    if (!troubles.deaf)
        to_pads_.push_back({now_ + 1 + delay_ms_, {report.begin(), report.end()}});
    return true;
}

} // namespace tp
