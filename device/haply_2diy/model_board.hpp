// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"
#include "device/haply_2diy/pantograph.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace tp {

/// The handle of a 2diy and the hand that may hold it.
struct HaplyPlant {
    double mass = 0.1;           ///< kg
    double damping = 0.15;       ///< N·s/m
    double coulomb = 0.03;       ///< N, dry friction
    double hand_stiffness = 0.0; ///< N/mm between handle and hand; 0: released
    double hand_damping = 0.0;   ///< N·s/m
};

/// A Haply board with a pantograph on it, without hardware: byte for byte what its published firmware does
/// with what comes over the line, and a body for a handle. It has no watchdog: what was last asked for is
/// pulled for ever. What the firmware does with a byte that begins no frame is not published; here it is
/// dropped.
class ModelBoard {
public:
    explicit ModelBoard(HaplyGeneration generation, const HaplyPlant& plant = {});

    void receive(std::uint8_t byte);
    /// What it has answered and nobody has taken.
    std::deque<std::uint8_t>& sent() { return sent_; }
    /// A millisecond.
    void step();
    /// As after a cable was pulled that powers it too.
    void power_off();

    /// Puts the handle there, at rest, mm; the hand follows. Where the arms do not reach it stays.
    void place_handle(Vec2 place);
    void move_hand(Vec2 place) { hand_ = place; }
    Vec2 handle() const { return place_; }
    /// N, what the motors do to the handle in truth.
    Vec2 force() const;
    /// N·m, by arm, as the motors turn them.
    std::array<double, 2> torques() const;
    bool set_up() const { return !set_up_.encoders.empty(); }

private:
    struct Port {
        std::size_t port = 0;
        haply::Turn turn = haply::Turn::clockwise;
        float offset_deg = 0;
        float counts_per_turn = 0;
        long counted_from = 0; ///< the true count at the set-up
    };
    struct Held {
        std::vector<Port> motors;
        std::vector<Port> encoders;
        std::size_t sensor_pins = 0;
        std::size_t output_pins = 0;
    };
    std::optional<std::size_t> frame_length() const;
    void obey();
    void take_set_up();
    void answer();
    long true_count(const Port& encoder) const;
    /// The arm that hangs at a port, 1 or −1 by how it is turned against the generation's own set-up.
    double sense(std::size_t port, haply::Turn turn, bool motor) const;

    Pantograph arms_;
    haply::SetUp wiring_; ///< what turns how in truth
    HaplyPlant plant_;
    std::vector<std::uint8_t> frame_;
    std::deque<std::uint8_t> sent_;
    Held set_up_;
    std::array<double, haply::port_count> pulled_{}; ///< N·m by port, in the arms' sense
    Vec2 place_;
    Vec2 velocity_{0.0}; ///< mm/s
    Vec2 hand_;
};

} // namespace tp
