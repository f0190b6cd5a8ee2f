// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"
#include "device/force_pad/firmware/pad_firmware.hpp"
#include "device/handle_body.hpp"

#include <array>
#include <cstdint>

namespace tp {

/// The knob of a pad and the hand that may hold it.
using PadPlant = HandlePlant;

/// A force pad without hardware: the firmware that a real one runs, with true encoders, drums and links
/// around it and a body for a knob. One step is a millisecond of its own time.
class ModelPad {
public:
    explicit ModelPad(const pad::PadConfig& config, const PadPlant& plant = {});

    void receive(const pad::Frame& frame) { firmware_.receive(frame); }
    void step();
    /// The next answer or, after each step, state; false when all is said.
    bool report(pad::Frame& frame);
    /// As after switching it off and on: not homed, numbers anew.
    void restart() { firmware_ = pad::PadFirmware(config_); }

    /// Puts the knob there, at rest, mm; the hand follows.
    void place_knob(Vec2 place) { knob_.put(place); }
    void move_hand(Vec2 place) { knob_.hand = place; }
    Vec2 knob() const { return knob_.place; }
    /// N, what the motors' torques do to the knob in truth.
    Vec2 force() const { return force_; }

    /// What can go wrong with it.
    struct Troubles {
        std::array<double, pad::most_motors> slip_mm{}; ///< of each drum on its encoder, or a slack cable's
        signed char celsius = 25;
        unsigned short current_ma = 100;
    };
    Troubles troubles;

private:
    pad::Sensors sensors();
    Vec2 force_of(const pad::Drive& drive, Vec2 place) const;

    pad::PadConfig config_;
    PadPlant plant_;
    pad::PadFirmware firmware_;
    std::uint32_t time_us_ = 0;
    HandleBody knob_;
    Vec2 force_{0.0};
    bool state_due_ = false;
};

} // namespace tp
