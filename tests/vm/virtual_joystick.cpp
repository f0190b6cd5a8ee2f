// SPDX-License-Identifier: Apache-2.0
#include "virtual_joystick.hpp"

#include "device/hid_pid/joystick_scale.hpp"

#include <utility>

namespace tp::vm {

namespace {

constexpr double walking_speed = 120.0; ///< mm/s, as one sweeps over a picture

HandlePlant held_grip() {
    HandlePlant plant;
    plant.hand_stiffness = 0.15;
    plant.hand_damping = 5.0;
    return plant;
}

} // namespace

VirtualJoystick::VirtualJoystick(Polyline way)
    : model_(open_controller(), held_grip()), hand_(std::move(way), model_.grip(), walking_speed) {
    model_.newtons_at_full =
        JoystickScale{}.newtons_at_full; // what a stick counts as that nobody has measured
}

DeviceSample VirtualJoystick::step() {
    if (model_.effects() > 0)
        model_.move_hand(hand_.step(0.001));
    model_.step();
    DeviceSample sample;
    sample.force = model_.force();
    sample.handle = model_.grip();
    sample.motors = model_.motors_on();
    return sample;
}

HidModel::Identity VirtualJoystick::identity() const {
    return {0x1209, 0x0002, "force stick", "FS-0001", model_.wire().descriptor};
}

std::optional<HidModel::Bytes> VirtualJoystick::feature(std::uint8_t id) {
    Bytes report;
    if (!model_.get_feature(id, report))
        return std::nullopt;
    return report;
}

std::optional<HidModel::Bytes> VirtualJoystick::input_now(std::uint8_t id) {
    if (id != model_.wire().axes)
        return std::nullopt;
    return model_.axes_report();
}

bool VirtualJoystick::input(Bytes& report) {
    while (model_.report(report))
        if (!silent_)
            return true;
    return false;
}

} // namespace tp::vm
