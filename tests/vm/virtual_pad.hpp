// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/polyline.hpp"
#include "device/force_pad/model_pad.hpp"
#include "virtual_device.hpp"
#include "walking_hand.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <span>

namespace tp::vm {

/// The force pad's firmware in its model of a pad with a supply of its own, and a hand on the knob that goes
/// on along a way as long as the motors are on.
class VirtualPad final : public VirtualDevice {
public:
    explicit VirtualPad(Polyline way);

    DeviceSample step() override;
    void silence(bool silent) override { silent_ = silent; }

    /// A packet or report of any length.
    void hear(std::span<const std::uint8_t> bytes);
    /// What it has to say next, in order.
    std::optional<pad::Frame> say();

private:
    ModelPad model_;
    WalkingHand hand_;
    std::deque<pad::Frame> unsaid_;
    bool motors_ = false;
    bool silent_ = false;
};

/// Its HID interface, PROTOCOL.md.
class PadOverHid final : public HidModel {
public:
    explicit PadOverHid(VirtualPad& pad) : pad_(pad) {}
    Identity identity() const override;
    void output(std::span<const std::uint8_t> report) override;
    bool input(Bytes& report) override;

private:
    VirtualPad& pad_;
};

/// Its bulk interface alone, as a system sees a pad that keeps HID from programs.
class PadOverBulk final : public UsbModel {
public:
    explicit PadOverBulk(VirtualPad& pad) : pad_(pad) {}
    Descriptors descriptors() const override;
    void output(unsigned endpoint, std::span<const std::uint8_t> bytes) override;
    bool input(unsigned endpoint, std::size_t most, Bytes& bytes) override;

private:
    VirtualPad& pad_;
};

} // namespace tp::vm
