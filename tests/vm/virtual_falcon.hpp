// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/polyline.hpp"
#include "device/falcon/model_falcon.hpp"
#include "virtual_device.hpp"
#include "walking_hand.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tp::vm {

/// A Falcon's model with a power supply of its own, and a person who holds its grip: who pulls it out and
/// pushes it in when it asks to be homed, and then goes on along a way as long as its light is green.
class VirtualFalcon final : public VirtualDevice, public UsbModel {
public:
    /// `firmware` is the one that it can run.
    VirtualFalcon(std::vector<std::uint8_t> firmware, Polyline way);

    DeviceSample step() override;
    void silence(bool silent) override { silent_ = silent; }

    Descriptors descriptors() const override;
    std::optional<Bytes> control(std::span<const std::uint8_t, 8> setup,
                                 std::span<const std::uint8_t> sent) override;
    void output(unsigned endpoint, std::span<const std::uint8_t> bytes) override;
    bool input(unsigned endpoint, std::size_t most, Bytes& bytes) override;

private:
    ModelFalcon model_;
    WalkingHand hand_;
    int asked_to_home_ms_ = 0;
    bool silent_ = false;
};

} // namespace tp::vm
