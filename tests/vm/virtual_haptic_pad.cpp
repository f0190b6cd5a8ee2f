// SPDX-License-Identifier: Apache-2.0
#include "virtual_haptic_pad.hpp"

#include <cmath>

namespace tp::vm {

DeviceSample VirtualHapticPad::step() {
    constexpr double radius = 20.0;       // mm
    constexpr double walking_speed = 1.0; // rad/s, 20 mm/s
    walked_ += 0.001 * walking_speed;
    const Vec2 finger = radius * Vec2(std::cos(walked_), std::sin(walked_));
    model_.touch(0, finger);
    model_.step();
    DeviceSample sample;
    sample.force = {model_.felt(), 0.0};
    sample.handle = finger;
    return sample;
}

HidModel::Identity VirtualHapticPad::identity() const {
    return {0x1209, 0x0003, "touch pad with haptics", "HP-0001", ModelHapticPad::descriptor()};
}

std::optional<HidModel::Bytes> VirtualHapticPad::feature(std::uint8_t id) {
    Bytes report = model_.feature(id);
    if (report.empty())
        return std::nullopt;
    report.insert(report.begin(), id);
    return report;
}

bool VirtualHapticPad::input(Bytes& report) {
    while (model_.report(report))
        if (!silent_)
            return true;
    return false;
}

} // namespace tp::vm
