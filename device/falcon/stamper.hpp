// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <optional>

/// A Falcon's three arms: where the grip is for which angles of the motors' arms.
///
/// Names and equations of Stamper (thesis ISR PhD 97-4), dimensions of libnifalcon at f7c727a. Metres and
/// radians; x right, y up, z out of the base towards the person. Each arm reaches from its motor over thigh
/// `a` and shin `b` to the grip; in its own frame u points from the axis of the base through the motor, v
/// along the motor's axis and w out.
namespace tp::falcon {

using Place = glm::dvec3;  ///< of the grip, m
using Angles = glm::dvec3; ///< θ1 of each arm, rad

/// Angles that put the grip there; nothing where an arm does not reach it.
std::optional<Angles> angles_at(const Place& place);

/// Where the grip is, by Newton's method from `near`, a place it was at a moment ago. Exact to 1e-9 m within
/// the workspace. Nothing where the arms cannot meet, the method does not end within `most_steps`, or ends in
/// a way in which the Falcon cannot be assembled.
std::optional<Place> place_of(const Angles& angles, const Place& near);
inline constexpr int most_steps = 16;

/// Where to begin when nothing is known: the middle of the workspace.
inline constexpr Place middle{0.0, 0.0, 0.125};

/// Columns ∂place/∂θ of each arm, m/rad; nothing at a singular pose.
std::optional<glm::dmat3> jacobian(const Place& place, const Angles& angles);

/// Torques of the arms that push the grip with `force` (N): τ = Jᵀ·F, N·m.
glm::dvec3 torques(const glm::dmat3& jacobian, const glm::dvec3& force);

/// An encoder of 320 slots, four counts each, on a capstan of 14.25 mm that turns a drum of 110 mm; at no
/// count an arm stands at 35°.
double angle_of(double counts);
double counts_of(double angle);

} // namespace tp::falcon
