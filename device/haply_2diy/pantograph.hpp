// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"
#include "device/haply_2diy/protocol/board_frames.hpp"

#include <array>
#include <optional>
#include <vector>

namespace tp {

/// The two kinds of 2diy that are about; nothing on the line tells one from the other.
enum class HaplyGeneration { first, third };

/// The 2diy's arms: two motors at (0, 0) and (base, 0), y away from them, mm; angles in degrees from the x
/// axis, counter clockwise, first arm first. Geometry, ports and reference pose of Haply's own examples for
/// each generation.
class Pantograph {
public:
    explicit Pantograph(HaplyGeneration generation);

    /// The board's set-up for arms that stand at these angles now.
    haply::SetUp set_up(const std::array<double, 2>& angles_deg) const;
    /// Where the arms stand when a person has put them on their marks.
    std::array<double, 2> reference_deg() const;
    /// The angles in a reply, whose order is that of the ports, and back.
    std::array<double, 2> angles_of(const haply::Reply& reply) const;
    haply::Reply reply_of(const std::array<double, 2>& angles_deg) const;

    struct Pose {
        Vec2 place{0.0};            ///< mm
        std::array<Vec2, 2> column; ///< mm/rad, how the handle moves by each arm: the Jacobian's columns
        double condition = 0.0;     ///< of the Jacobian; infinite in a singular pose
    };
    /// None where the elbows are too far apart, in one place, or an angle is not a number.
    std::optional<Pose> pose_at(const std::array<double, 2>& angles_deg) const;
    /// Angles with the handle there, elbows outwards; none where it cannot be.
    std::optional<std::array<double, 2>> angles_at(Vec2 place) const;

    /// τ = JᵀF in N·m for a force in N, both made smaller together where one is above the board's limit, so
    /// that the force keeps its direction; none at all near a singular pose or for what is not a number.
    std::array<double, 2> torques(const std::array<double, 2>& angles_deg, Vec2 force) const;
    /// The command that asks for them.
    haply::Command command_of(const std::array<double, 2>& torques) const;
    std::array<double, 2> torques_of(const haply::Command& command) const;

    /// The places where the Jacobian's condition is below 4, as seen from the middle, mm.
    std::vector<Vec2> workspace() const;
    Vec2 middle() const;
    /// N that can be made in every direction in the middle.
    double force_in_the_middle() const;
    /// mm that the handle moves in the middle by a step of the coarser encoder.
    double resolution() const;

    static constexpr double greatest_torque = 0.123; ///< N·m; the board holds it too
    static constexpr double greatest_condition = 4.0;

private:
    struct Arm {
        haply::Turn motor;
        haply::Turn encoder;
        double reference_deg;
        double counts_per_turn;
        std::size_t port; ///< 0-based
    };
    double base_;
    std::array<Arm, 2> arms_;
};

} // namespace tp
