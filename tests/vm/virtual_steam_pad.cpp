// SPDX-License-Identifier: Apache-2.0
#include "virtual_steam_pad.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace tp::vm {

namespace {

constexpr double radius = 10.0;       ///< mm
constexpr double walking_speed = 2.0; ///< rad/s, 20 mm/s

/// 64 bytes each way, without a number.
constexpr std::array<std::uint8_t, 25> descriptor{0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x15, 0x00,
                                                  0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x40, 0x09, 0x01,
                                                  0x81, 0x02, 0x09, 0x01, 0xB1, 0x02, 0xC0};

} // namespace

DeviceSample VirtualSteamPad::step() {
    walked_ += 0.001 * walking_speed;
    const Vec2 thumb = radius * Vec2(std::cos(walked_), std::sin(walked_));
    model_.touch(steam::Side::left, thumb);
    model_.step();
    DeviceSample sample;
    sample.force = {model_.felt(steam::Side::left), model_.felt(steam::Side::right)};
    sample.handle = thumb;
    sample.motors = !model_.imitates();
    return sample;
}

HidModel::Identity VirtualSteamPad::identity() const {
    if (model_.kind() == steam::Kind::deck)
        return {0x28DE, 0x1205, "Steam Deck Controller", "SD-0001", descriptor};
    return {0x28DE, 0x1102, "Steam Controller", "SC-0001", descriptor};
}

/// The answer to the kernel's driver, which asks who it is.
std::optional<HidModel::Bytes> VirtualSteamPad::feature(std::uint8_t id) {
    if (id != 0)
        return std::nullopt;
    constexpr std::string_view serial = "SC00000001";
    Bytes report(65);
    report[1] = 0xAE;
    report[2] = 0x15;
    report[3] = 0x01;
    std::copy(serial.begin(), serial.end(), report.begin() + 4);
    return report;
}

bool VirtualSteamPad::set_feature(std::span<const std::uint8_t> report) {
    std::array<std::uint8_t, 65> whole{};
    std::copy_n(report.begin(), std::min(report.size(), whole.size()), whole.begin());
    return model_.receive(whole);
}

bool VirtualSteamPad::input(Bytes& report) {
    while (model_.report(report))
        if (!silent_)
            return true;
    return false;
}

} // namespace tp::vm
