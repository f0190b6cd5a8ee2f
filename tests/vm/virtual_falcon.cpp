// SPDX-License-Identifier: Apache-2.0
#include "virtual_falcon.hpp"

#include "device/falcon/ftdi.hpp"
#include "device/falcon/plane_force.hpp"

#include <utility>

namespace tp::vm {

namespace {

constexpr double walking_speed = 120.0; ///< mm/s, as one sweeps over a picture
constexpr int takes_the_grip_ms = 300;  ///< from the wish to be homed to the hand on the grip

constexpr unsigned in_endpoint = 1;
constexpr unsigned out_endpoint = 2;

FalconPlant held_grip() {
    FalconPlant plant;
    plant.hand_stiffness = 150.0;
    plant.hand_damping = 5.0;
    return plant;
}

falcon::Place in_the_plane(Vec2 mm) { return {1e-3 * mm.x, 1e-3 * mm.y, falcon::plane_z}; }

} // namespace

VirtualFalcon::VirtualFalcon(std::vector<std::uint8_t> firmware, Polyline way)
    : model_(std::move(firmware), held_grip()), hand_(std::move(way), Vec2(0.0), walking_speed) {}

DeviceSample VirtualFalcon::step() {
    const bool green = model_.firmware_runs() && (model_.command().leds & falcon::led::green) != 0;
    asked_to_home_ms_ = model_.firmware_runs() && model_.command().homing ? asked_to_home_ms_ + 1 : 0;
    if (asked_to_home_ms_ == takes_the_grip_ms)
        model_.pull_and_push();
    if (green)
        model_.move_hand(in_the_plane(hand_.step(0.001)));
    model_.step();
    DeviceSample sample;
    sample.force = {model_.force().x, model_.force().y};
    sample.handle = {1e3 * model_.grip().x, 1e3 * model_.grip().y};
    sample.motors = green;
    return sample;
}

UsbModel::Descriptors VirtualFalcon::descriptors() const {
    Descriptors all; // an FTDI bridge at full speed: one interface of its vendor's class, two bulk endpoints
    all.device = {18, 1, 0x10, 1, 0, 0, 0, 8, 0x03, 0x04, 0x48, 0xCB, 0x00, 0x04, 1, 2, 3, 1};
    all.configuration = {9, 2, 32, 0,    1, 1,  0, 0x80, 45,              //
                         9, 4, 0,  0,    2, 0xFF, 0xFF, 0xFF, 0,          //
                         7, 5, 0x80 | in_endpoint, 2, 64, 0, 0,           //
                         7, 5, out_endpoint, 2, 64, 0, 0};
    all.strings = {"Novint", "Falcon", "FTFALCON"};
    return all;
}

std::optional<UsbModel::Bytes> VirtualFalcon::control(std::span<const std::uint8_t, 8> setup,
                                                      std::span<const std::uint8_t>) {
    if (setup[0] != falcon::ftdi::request_type)
        return std::nullopt;
    model_.control({setup[1], static_cast<std::uint16_t>(setup[2] | setup[3] << 8)});
    return Bytes{};
}

void VirtualFalcon::output(unsigned endpoint, std::span<const std::uint8_t> bytes) {
    if (endpoint == out_endpoint)
        model_.send(bytes);
}

bool VirtualFalcon::input(unsigned endpoint, std::size_t most, Bytes& bytes) {
    UsbPacket packet;
    if (endpoint != in_endpoint || most < packet.bytes.size() || !model_.packet(packet) || silent_)
        return false;
    bytes.assign(packet.bytes.begin(), packet.bytes.begin() + static_cast<std::ptrdiff_t>(packet.size));
    return true;
}

} // namespace tp::vm
