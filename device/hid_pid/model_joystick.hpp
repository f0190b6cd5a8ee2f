// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/handle_body.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace tp {

/// Where a model stick has what in its reports, written down by hand and not read from its descriptor, so
/// that the model does not share the mistakes of who reads that. Bytes count from the one behind the report
/// id.
struct JoystickWire {
    std::span<const std::uint8_t> descriptor;
    std::uint8_t set_effect = 0x01; ///< output ids
    std::uint8_t constant_force = 0x05;
    std::uint8_t operation = 0x0A;
    std::uint8_t free = 0x0B;
    std::uint8_t control = 0x0C;
    std::uint8_t create = 0x11; ///< feature ids
    std::uint8_t block_load = 0x12;
    std::uint8_t axes = 0x01; ///< input ids
    std::uint8_t state = 0x02;

    std::size_t effect_bytes = 21;
    std::size_t enable_byte = 12; ///< bits 0, 1 axes, 2 direction
    std::size_t direction_byte = 13;
    int direction_bytes = 2;
    int whole_turn = 36000;
    int magnitude_full = 32767; ///< 16 bits
    std::size_t axes_bytes = 12;
    std::size_t x_byte = 8;
    std::size_t y_byte = 10;
    int axis_most = 32767;     ///< at the right, and towards the person
    bool control_bits = false; ///< a bit for each command instead of its number
    bool has_state = true;
    std::size_t state_bytes = 1; ///< bits 1, 2: actuators enabled, safety switch
    unsigned power_bit = 3;
};

/// A controller as people build them: 16-bit directions, numbered commands.
JoystickWire open_controller();
/// The same, with a bit for each command, no start delay and no report of its state.
JoystickWire plain_controller();

/// A PID stick without hardware: bytes in, bytes out, a lever with a grip between. One step is a millisecond.
class ModelJoystick {
public:
    explicit ModelJoystick(const JoystickWire& wire, const HandlePlant& plant = {});

    /// An output report; its id leads.
    void receive(std::span<const std::uint8_t> report);
    /// A feature report; its id leads. False where it has none of that id.
    bool set_feature(std::span<const std::uint8_t> report);
    bool get_feature(std::uint8_t id, std::vector<std::uint8_t>& report);
    void step();
    /// The next input report; false when all is said. It says what has changed, or where the axes are at each step.
    bool report(std::vector<std::uint8_t>& bytes);
    /// The report of its axes as it is now.
    std::vector<std::uint8_t> axes_report() const;

    void place_grip(Vec2 place) { body_.put(place); }
    void move_hand(Vec2 place) { body_.hand = place; }
    /// A hand takes the grip where it is: N/mm and N·s/m between the two.
    void hold(double stiffness, double damping) {
        body_.hand = body_.place;
        plant_.hand_stiffness = stiffness;
        plant_.hand_damping = damping;
    }
    Vec2 grip() const { return body_.place; }
    /// N, what its motors do to the grip in truth; x to the right, y away from the person.
    Vec2 force() const { return force_; }
    bool motors_on() const { return enabled_ && !troubles.safety_switch && !troubles.no_power; }
    const JoystickWire& wire() const { return wire_; }
    std::size_t effects() const; ///< that it holds

    double newtons_at_full = 8.0;
    /// Which way a positive magnitude pulls; PID 1.0: from the direction.
    Vec2 sign{-1.0, -1.0};
    double lever_mm = 60.0;
    bool speaks_at_rest = false; ///< it reports its axes at each step, changed or not

    /// What can go wrong with it.
    struct Troubles {
        std::size_t room = 40;          ///< effects it can hold
        bool keeps_after_reset = false; ///< a reset does not empty its memory; only freeing does
        bool expires = true;            ///< an endless effect ends after 65.535 s
        bool safety_switch = false;     ///< released: no motors
        bool no_power = false;
        bool refuses = false; ///< block load says error
    };
    Troubles troubles;
    /// What another program left on it.
    void leave_effects(std::size_t count);
    /// Its motors go off by themselves, until they are enabled again.
    void disable() { enabled_ = false; }
    int last_duration = -1; ///< of Set Effect, ms

private:
    struct Effect {
        bool held = false;
        bool constant = false;
        bool playing = false;
        bool x = false, y = false, turned = false;
        double degrees = 0.0;
        int duration = 0; ///< ms; 65535: endless
        int magnitude = 0;
        double left_ms = 0.0;
    };
    Effect* effect(std::uint8_t block);
    void obey(unsigned command);
    Vec2 pull() const;
    std::vector<std::uint8_t> state_report() const;

    JoystickWire wire_;
    HandlePlant plant_;
    HandleBody body_;
    std::array<Effect, 64> effects_{};
    std::uint8_t loaded_ = 0;
    std::uint8_t load_status_ = 3;
    bool enabled_ = true;
    Vec2 force_{0.0};
    std::vector<std::uint8_t> told_axes_;
    std::vector<std::uint8_t> told_state_;
    std::deque<std::vector<std::uint8_t>> to_tell_;
};

} // namespace tp
