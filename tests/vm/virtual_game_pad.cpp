// SPDX-License-Identifier: Apache-2.0
#include "virtual_game_pad.hpp"

#include <array>
#include <cstddef>
#include <linux/input.h>

namespace tp::vm {

namespace {

// A game pad with two axes, eight buttons and the report that drives its motors.
constexpr std::array<std::uint8_t, 58> descriptor{
    0x05, 0x01, 0x09, 0x05, 0xA1, 0x01,                   // a game pad
    0x85, 0x01, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08, // report 1: bytes
    0x95, 0x02, 0x09, 0x30, 0x09, 0x31, 0x81, 0x02,       // x, y
    0x05, 0x09, 0x19, 0x01, 0x29, 0x08, 0x25, 0x01,       // buttons 1 … 8
    0x75, 0x01, 0x95, 0x08, 0x81, 0x02,                   //
    0x05, 0x0F, 0x09, 0x21, 0x85, 0x03, 0xA1, 0x02,       // report 3: an effect
    0x09, 0x97, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x08, // eight bytes
    0x91, 0x02, 0xC0, 0xC0,                               //
};

// The report of an effect, behind its id: which motors, four strengths of 100, duration, delay, repetitions.
constexpr std::uint8_t effect_report = 3;
constexpr std::size_t strong_byte = 4;
constexpr std::size_t weak_byte = 5;
constexpr double whole_strength = 100.0;

} // namespace

HidModel::Identity VirtualGamePad::identity() const {
    Identity pad;
    pad.bus = BUS_BLUETOOTH;
    pad.vendor = 0x045E;
    pad.product = 0x02FD;
    pad.name = "Wireless game pad";
    pad.serial_number = "GP-0001";
    pad.report_descriptor = descriptor;
    return pad;
}

void VirtualGamePad::output(std::span<const std::uint8_t> report) {
    if (report.size() > weak_byte && report[0] == effect_report)
        shakes_ = Vec2(report[strong_byte], report[weak_byte]) / whole_strength;
}

DeviceSample VirtualGamePad::step() {
    DeviceSample sample;
    sample.force = shakes_;
    sample.motors = true;
    return sample;
}

} // namespace tp::vm
