// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/steam_pad/simulated_steam_link.hpp"

#include <cstdint>
#include <vector>

namespace tp {

void SimulatedSteamLink::advance() {
    cable_.pass();
    while (const auto report = cable_.at_device())
        pads_.receive(*report);
    pads_.step();
    std::vector<std::uint8_t> bytes;
    while (pads_.report(bytes))
        cable_.to_computer(bytes, troubles);
}

SteamTransport::Got SimulatedSteamLink::read(Input& report, int wait_ms) noexcept {
    return cable_.read<Got>(report, wait_ms, troubles, [this] { advance(); });
}

bool SimulatedSteamLink::send(const steam::Feature& report) noexcept {
    ++sends_;
    constexpr std::uint8_t asks_the_receiver = 0xB4;
    if (troubles.unplugged || cable_.happens(troubles.refuse) ||
        (!pads_.on() && report[1] != asks_the_receiver))
        return false;
    if (!troubles.deaf)
        cable_.to_device({report.begin(), report.end()});
    return true;
}

} // namespace tp
