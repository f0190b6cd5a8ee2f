// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/polyline.hpp"
#include "device/hid_pid/model_joystick.hpp"
#include "virtual_device.hpp"
#include "walking_hand.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace tp::vm {

/// A force stick's model, and a hand on its grip that goes on along a way as long as something plays.
class VirtualJoystick final : public VirtualDevice, public HidModel {
public:
    explicit VirtualJoystick(Polyline way);

    DeviceSample step() override;
    void silence(bool silent) override { silent_ = silent; }

    Identity identity() const override;
    void output(std::span<const std::uint8_t> report) override { model_.receive(report); }
    std::optional<Bytes> feature(std::uint8_t id) override;
    bool set_feature(std::span<const std::uint8_t> report) override { return model_.set_feature(report); }
    std::optional<Bytes> input_now(std::uint8_t id) override;
    bool input(Bytes& report) override;

private:
    ModelJoystick model_;
    WalkingHand hand_;
    bool silent_ = false;
};

} // namespace tp::vm
