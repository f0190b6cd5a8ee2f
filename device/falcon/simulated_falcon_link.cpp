// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/simulated_falcon_link.hpp"

#include <cstddef>

namespace tp {

bool SimulatedFalconLink::happens(double share) {
    return share > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(random_) < share;
}

void SimulatedFalconLink::garble(std::span<std::uint8_t> bytes) {
    if (bytes.empty())
        return;
    for (unsigned i = 0; i < 1 + random_() % 4; ++i)
        bytes[random_() % bytes.size()] = static_cast<std::uint8_t>(random_());
}

void SimulatedFalconLink::advance() {
    constexpr std::size_t most_waiting = 64; // as the transport keeps of packets that nobody reads
    ++now_;
    each_ms();
    while (!to_falcon_.empty() && to_falcon_.front().due <= now_) {
        model_.send(to_falcon_.front().bytes);
        to_falcon_.pop_front();
    }
    model_.step();
    UsbPacket packet;
    while (model_.packet(packet)) {
        if (troubles.mute || troubles.unplugged || happens(troubles.drop))
            continue;
        if (happens(troubles.cut))
            packet.size = random_() % packet.size;
        if (happens(troubles.garble))
            garble(std::span(packet.bytes).first(packet.size));
        to_computer_.push_back({now_ + delay_ms_, packet});
        if (to_computer_.size() > most_waiting)
            to_computer_.pop_front();
    }
}

bool SimulatedFalconLink::control(const falcon::ftdi::Request& request) noexcept {
    if (troubles.unplugged)
        return false;
    model_.control(request);
    return true;
}

UsbGot SimulatedFalconLink::read(UsbPacket& packet, int wait_ms) noexcept {
    for (;; --wait_ms) {
        if (troubles.unplugged)
            return UsbGot::lost;
        if (!troubles.stalled && !to_computer_.empty() && to_computer_.front().due <= now_) {
            packet = to_computer_.front().packet;
            to_computer_.pop_front();
            return UsbGot::packet;
        }
        if (wait_ms <= 0)
            return UsbGot::nothing;
        advance();
    }
}

bool SimulatedFalconLink::write(std::span<const std::uint8_t> bytes) noexcept {
    if (troubles.unplugged)
        return false;
    if (troubles.deaf || happens(troubles.drop))
        return true;
    to_falcon_.push_back({now_ + 1 + delay_ms_, std::vector<std::uint8_t>(bytes.begin(), bytes.end())});
    return true;
}

Result<std::unique_ptr<ForceGuard>> SimulatedFalconLink::guard(std::span<const std::uint8_t> no_force) {
    if (troubles.no_guard)
        return Error{"The device stays off, because nothing would watch over its motors on this system."};
    guard_takes_away.assign(no_force.begin(), no_force.end());
    return std::unique_ptr<ForceGuard>(std::make_unique<SimulatedGuard>(diary));
}

} // namespace tp
