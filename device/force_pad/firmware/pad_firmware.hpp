// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/force_pad/firmware/cables.hpp"
#include "device/force_pad/firmware/five_bar.hpp"
#include "device/force_pad/protocol/frame.hpp"

namespace tp::pad {

inline constexpr uint8_t most_corners = 8;
inline constexpr int most_motors = 4;

/// What one pad is made of, by default a cable pad without its frame. Lengths in mm, forces in N, torques in N·mm.
struct PadConfig {
    PadKind kind = PadKind::cables;
    CableFrame<float> cables;       ///< of a cable pad
    float drum_radius = 5;          ///< of a cable pad
    Vec<float> mark;                ///< where the knob of a cable pad stands when it is homed
    FiveBar<float> bars;            ///< of a pantograph
    float mark_angles[arm_count] = {}; ///< rad, of a pantograph's motors when it is homed
    float counts_per_turn = 4096;   ///< of every encoder
    float greatest_torque = 20;     ///< of every motor
    float greatest_residual = 0.5f; ///< beyond it the encoders are not believed
    float least_spread = 0.3f;      ///< of a pantograph; below it there is no force
    Vec<float> outline[most_corners];
    uint8_t corners = 0;
    float max_force = 1.2f;
    float continuous_force = 1;
    float max_force_rate = 100; ///< N/s; the computer keeps to 40
    uint32_t watchdog_us = 30000;
    int8_t hot = 70;  ///< °C: motors off from here on
    int8_t cool = 60; ///< °C: and only below this they may be armed again
    uint16_t greatest_current_ma = 800;
    uint16_t resolution_um = 8;
    uint16_t rate_hz = 1000;
    uint16_t delay_us = 1000;
    char serial[serial_size + 1] = {};
};

/// Four cables in a frame of 300 × 220 mm; the knob reaches 200 × 150 mm in its middle with 1.5 N in every
/// direction.
PadConfig cable_pad();
/// A pantograph with links of 70 and 90 mm and motors 38 mm apart; 120 × 60 mm, 1.2 N in every direction.
PadConfig pantograph_pad();

/// What the microcontroller measures before each step.
struct Sensors {
    uint32_t time_us = 0; ///< wraps
    int32_t counts[most_motors] = {};
    uint16_t current_ma[most_motors] = {};
    int8_t celsius = 20; ///< the hottest motor
    uint8_t buttons = 0;
};

/// What the motors do until the next step.
struct Drive {
    bool powered = false;                 ///< false: the bridges are open, whatever the torques say
    int32_t torque_unm[most_motors] = {}; ///< µN·m
};

/// The pad between its USB frames and its motors; ../PROTOCOL.md says what it promises. Call `receive` for
/// every frame that arrives and `step` a thousand times a second, from one thread. It keeps the limits of its
/// own configuration whatever the computer asks for.
class PadFirmware {
public:
    explicit PadFirmware(const PadConfig& config) : config_(config) {}

    /// Bytes of another length than a frame's are dropped before this.
    void receive(const Frame& frame);
    Drive step(const Sensors& sensors);
    /// The state after the last step, with the next sequence number.
    Frame state();
    /// True where an answer to a question is due, which is then in `frame`.
    bool answer(Frame& frame);

private:
    void take(const ForceFrame& force);
    void take(const CalibrateFrame& calibrate);
    void reply(const AskFrame& ask);
    Frame calibration() const;
    void find_place();
    bool inside_outline() const;
    bool may_be_armed() const;
    void limit_force(float seconds);
    Drive pull();
    Drive pull_cables();
    Drive turn_bars();
    int32_t torque(int motor, float newton_mm) const;

    PadConfig config_;
    Sensors sensors_;
    int32_t home_[most_motors] = {};
    uint16_t permille_[most_motors] = {1000, 1000, 1000, 1000};
    bool stepped_ = false;
    bool homed_ = false;
    bool armed_ = false;
    bool too_hot_ = false;
    uint16_t flags_ = 0;   ///< of this step
    uint16_t tripped_ = 0; ///< why the motors went off; forgotten when they are armed
    uint16_t heard_ = 0;
    uint32_t heard_at_us_ = 0;
    uint16_t sequence_ = 0;
    bool bad_frame_ = false;
    bool answer_due_ = false;
    Frame answer_{};
    Vec<float> place_;
    float residual_ = 0;
    FiveBarPose<float> pose_;
    Vec<float> asked_;   ///< N, by the last force frame
    Vec<float> allowed_; ///< N, after the pad's own limits
    Vec<float> made_;    ///< N
};

} // namespace tp::pad
