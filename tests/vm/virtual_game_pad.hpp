// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "virtual_device.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tp::vm {

/// A game pad with two motors, as the kernel's hid-microsoft knows it on Bluetooth: it shakes for as long as it is not told to
/// stop, which is the kernel's to do (ff-memless). In its samples `force` is how strongly the slow and the fast motor shake,
/// 0 … 1.
class VirtualGamePad final : public VirtualDevice, public HidModel {
public:
    DeviceSample step() override;
    void silence(bool) override {}

    Identity identity() const override;
    void output(std::span<const std::uint8_t> report) override;
    bool input(Bytes&) override { return false; }

private:
    Vec2 shakes_{0.0};
};

} // namespace tp::vm
