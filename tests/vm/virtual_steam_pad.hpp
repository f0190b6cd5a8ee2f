// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/steam_pad/model_steam_pad.hpp"
#include "virtual_device.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace tp::vm {

/// A Steam Deck's controller or a Steam Controller, and a thumb that goes round on its left pad. In its samples the force is how
/// strongly the left and the right pad swing, the handle is the thumb, and the motors are on while no mouse is imitated.
class VirtualSteamPad final : public VirtualDevice, public HidModel {
public:
    explicit VirtualSteamPad(steam::Kind kind) : model_(kind) {}

    DeviceSample step() override;
    void silence(bool silent) override { silent_ = silent; }

    Identity identity() const override;
    void output(std::span<const std::uint8_t>) override {}
    std::optional<Bytes> feature(std::uint8_t id) override;
    /// Of any length, as the kernel's driver sends them.
    bool set_feature(std::span<const std::uint8_t> report) override;
    bool input(Bytes& report) override;

private:
    ModelSteamPad model_;
    double walked_ = 0.0; ///< rad
    bool silent_ = false;
};

} // namespace tp::vm
