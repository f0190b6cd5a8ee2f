// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/hid_haptics/model_haptic_pad.hpp"
#include "virtual_device.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace tp::vm {

/// A touch pad with haptics, and a finger that goes round on it. In its samples the force is how strongly it swings, and the handle
/// is the finger.
class VirtualHapticPad final : public VirtualDevice, public HidModel {
public:
    DeviceSample step() override;
    void silence(bool silent) override { silent_ = silent; }

    Identity identity() const override;
    void output(std::span<const std::uint8_t> report) override { model_.receive(report); }
    std::optional<Bytes> feature(std::uint8_t id) override;
    bool input(Bytes& report) override;

private:
    ModelHapticPad model_;
    double walked_ = 0.0; ///< rad
    bool silent_ = false;
};

} // namespace tp::vm
