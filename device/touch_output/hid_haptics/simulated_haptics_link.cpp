// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/hid_haptics/simulated_haptics_link.hpp"

#include <algorithm>
#include <cstddef>

namespace tp {

void SimulatedHapticsLink::advance() {
    cable_.pass();
    while (const auto report = cable_.at_device())
        pad_.receive(*report);
    pad_.step();
    std::vector<std::uint8_t> bytes;
    while (pad_.report(bytes))
        cable_.to_computer(bytes, troubles);
}

HapticsTransport::Got SimulatedHapticsLink::read(Input& report, int wait_ms) noexcept {
    return cable_.read<Got>(report, wait_ms, troubles, [this] { advance(); });
}

bool SimulatedHapticsLink::send(const haptics::Output& report) noexcept {
    ++sends_;
    if (troubles.unplugged || cable_.happens(troubles.refuse))
        return false;
    if (!troubles.deaf)
        cable_.to_device({report.all().begin(), report.all().end()});
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
