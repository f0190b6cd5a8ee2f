// SPDX-License-Identifier: Apache-2.0
#include "device/hid_pid/simulated_joystick_link.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace tp {

namespace {

PidTransport::Got given(const std::vector<std::uint8_t>& bytes, hid::Report& report) {
    report.size = std::min(bytes.size(), report.bytes.size());
    std::copy_n(bytes.begin(), report.size, report.bytes.begin());
    return PidTransport::Got::report;
}

} // namespace

bool SimulatedJoystickLink::happens(double share) {
    return share > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(random_) < share;
}

bool SimulatedJoystickLink::is_force(std::span<const std::uint8_t> report) const {
    return report.size() > 1 && report[0] == joystick_.wire().constant_force;
}

unsigned SimulatedJoystickLink::silent_ms() const {
    return std::max(silent_ms_, *std::max_element(lacks_ms_.begin(), lacks_ms_.end()));
}

void SimulatedJoystickLink::advance() {
    constexpr std::size_t most_waiting = 64; // as the system keeps of reports that nobody reads
    ++now_;
    ++silent_ms_;
    for (unsigned& lacks : lacks_ms_)
        lacks += lacks > 0 ? 1 : 0;
    while (!to_joystick_.empty() && to_joystick_.front().due <= now_) {
        joystick_.receive(to_joystick_.front().bytes);
        if (const auto& bytes = to_joystick_.front().bytes; is_force(bytes)) {
            silent_ms_ = 0;
            lacks_ms_[bytes[1]] = 0;
        }
        to_joystick_.pop_front();
    }
    joystick_.step();
    std::vector<std::uint8_t> bytes;
    while (joystick_.report(bytes)) {
        if (troubles.mute || troubles.unplugged || happens(troubles.drop))
            continue;
        if (happens(troubles.garble))
            for (unsigned i = 0; i < 1 + random_() % 4; ++i)
                bytes[random_() % bytes.size()] = static_cast<std::uint8_t>(random_());
        if (happens(troubles.cut))
            bytes.resize(1 + random_() % bytes.size());
        from_joystick_.push_back({now_ + delay_ms_, bytes});
        if (from_joystick_.size() > most_waiting)
            from_joystick_.pop_front();
    }
}

std::vector<std::uint8_t> SimulatedJoystickLink::descriptor() {
    return {joystick_.wire().descriptor.begin(), joystick_.wire().descriptor.end()};
}

PidTransport::Got SimulatedJoystickLink::read(hid::Report& report, int wait_ms) noexcept {
    for (;; --wait_ms) {
        if (troubles.unplugged)
            return Got::lost;
        if (!from_joystick_.empty() && from_joystick_.front().due <= now_) {
            const std::vector<std::uint8_t> bytes = std::move(from_joystick_.front().bytes);
            from_joystick_.pop_front();
            return given(bytes, report);
        }
        if (wait_ms <= 0)
            return Got::nothing;
        advance();
    }
}

PidTransport::Got SimulatedJoystickLink::input_now(hid::Report& report) noexcept {
    if (troubles.no_input_now || report.bytes[0] != joystick_.wire().axes)
        return Got::nothing;
    return given(joystick_.axes_report(), report);
}

bool SimulatedJoystickLink::write(const hid::Report& report) noexcept {
    if (troubles.unplugged)
        return false;
    if (!troubles.deaf)
        to_joystick_.push_back(
            {now_ + 1 + delay_ms_,
             {report.bytes.begin(), report.bytes.begin() + static_cast<std::ptrdiff_t>(report.size)}});
    else if (is_force(report.all()) && lacks_ms_[report.bytes[1]] == 0)
        lacks_ms_[report.bytes[1]] = 1;
    return true;
}

bool SimulatedJoystickLink::set_feature(const hid::Report& report) noexcept {
    while (!to_joystick_.empty() || delay_ms_ > 0) { // a feature report waits for what was sent before
        advance();
        if (to_joystick_.empty())
            break;
    }
    return !troubles.unplugged && joystick_.set_feature(report.all());
}

bool SimulatedJoystickLink::get_feature(hid::Report& report) noexcept {
    std::vector<std::uint8_t> bytes;
    if (troubles.unplugged || troubles.block_load_late-- > 0 ||
        !joystick_.get_feature(report.bytes[0], bytes))
        return false;
    given(bytes, report);
    return true;
}

Result<std::unique_ptr<ForceGuard>> SimulatedJoystickLink::guard(std::span<const hid::Report> no_force,
                                                                 std::span<const hid::Report> at_the_end) {
    if (troubles.no_guard)
        return Error{"The device stays off, because nothing would watch over its motors on this system."};
    guard_takes_away.assign(no_force.begin(), no_force.end());
    guard_leaves.assign(at_the_end.begin(), at_the_end.end());
    return std::unique_ptr<ForceGuard>(std::make_unique<SimulatedGuard>(diary));
}

} // namespace tp
