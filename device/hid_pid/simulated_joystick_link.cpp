// SPDX-License-Identifier: Apache-2.0
#include "device/hid_pid/simulated_joystick_link.hpp"

#include <algorithm>
#include <cstddef>

namespace tp {

bool SimulatedJoystickLink::is_force(std::span<const std::uint8_t> report) const {
    return report.size() > 1 && report[0] == joystick_.wire().constant_force;
}

unsigned SimulatedJoystickLink::silent_ms() const {
    return std::max(silent_ms_, *std::max_element(lacks_ms_.begin(), lacks_ms_.end()));
}

void SimulatedJoystickLink::advance() {
    cable_.pass();
    ++silent_ms_;
    for (unsigned& lacks : lacks_ms_)
        lacks += lacks > 0 ? 1 : 0;
    while (const auto report = cable_.at_device()) {
        joystick_.receive(*report);
        if (is_force(*report)) {
            silent_ms_ = 0;
            lacks_ms_[(*report)[1]] = 0;
        }
    }
    joystick_.step();
    std::vector<std::uint8_t> bytes;
    while (joystick_.report(bytes))
        cable_.to_computer(bytes, troubles);
}

std::vector<std::uint8_t> SimulatedJoystickLink::descriptor() {
    return {joystick_.wire().descriptor.begin(), joystick_.wire().descriptor.end()};
}

PidTransport::Got SimulatedJoystickLink::read(hid::Report& report, int wait_ms) noexcept {
    return cable_.read<Got>(report, wait_ms, troubles, [this] { advance(); });
}

PidTransport::Got SimulatedJoystickLink::input_now(hid::Report& report) noexcept {
    if (troubles.no_input_now || report.bytes[0] != joystick_.wire().axes)
        return Got::nothing;
    ReportCable::fill(report, joystick_.axes_report());
    return Got::report;
}

bool SimulatedJoystickLink::write(const hid::Report& report) noexcept {
    if (troubles.unplugged)
        return false;
    if (!troubles.deaf)
        cable_.to_device(
            {report.bytes.begin(), report.bytes.begin() + static_cast<std::ptrdiff_t>(report.size)});
    else if (is_force(report.all()) && lacks_ms_[report.bytes[1]] == 0)
        lacks_ms_[report.bytes[1]] = 1;
    return true;
}

bool SimulatedJoystickLink::set_feature(const hid::Report& report) noexcept {
    // A feature report waits for what was sent before.
    while (!cable_.all_at_device() || cable_.delay_ms() > 0) {
        advance();
        if (cable_.all_at_device())
            break;
    }
    return !troubles.unplugged && joystick_.set_feature(report.all());
}

bool SimulatedJoystickLink::get_feature(hid::Report& report) noexcept {
    std::vector<std::uint8_t> bytes;
    if (troubles.unplugged || troubles.block_load_late-- > 0 ||
        !joystick_.get_feature(report.bytes[0], bytes))
        return false;
    ReportCable::fill(report, bytes);
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
