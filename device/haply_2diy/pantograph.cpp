// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/pantograph.hpp"

#include "device/force_pad/firmware/five_bar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tp {

namespace {

constexpr double proximal_mm = 70.0;
constexpr double distal_mm = 90.0;
constexpr double rad_per_deg = std::numbers::pi / 180.0;
/// Sine of the angle between the distal links; below it a newton asks for more than the motors have anyway.
constexpr double least_spread = 0.1;

using haply::Turn;

pad::FiveBarPose<double> five_bar_pose(double base, const std::array<double, 2>& angles_deg) {
    const double angles[2] = {rad_per_deg * angles_deg[0], rad_per_deg * angles_deg[1]};
    return pad::locate(pad::FiveBar<double>{proximal_mm, distal_mm, base}, angles);
}

/// Largest over smallest singular value.
double condition_of(Vec2 a, Vec2 b) {
    const double squares = glm::dot(a, a) + glm::dot(b, b);
    const double area = std::abs(cross(a, b));
    const double root = std::sqrt(std::max(0.0, squares * squares - 4.0 * area * area));
    return area > 0.0 ? (squares + root) / (2.0 * area) : std::numeric_limits<double>::infinity();
}

} // namespace

Pantograph::Pantograph(HaplyGeneration generation)
    : base_(generation == HaplyGeneration::first ? 0.0 : 38.0),
      arms_(generation == HaplyGeneration::first
                ? std::array<Arm, 2>{Arm{Turn::counter_clockwise, Turn::counter_clockwise, 241.0, 10752.0, 1},
                                     Arm{Turn::clockwise, Turn::counter_clockwise, -61.0, 10752.0, 0}}
                : std::array<Arm, 2>{Arm{Turn::counter_clockwise, Turn::counter_clockwise, 97.23,
                                         2048 * 2.5 * 1.0194 * 1.0154, 1},
                                     Arm{Turn::counter_clockwise, Turn::counter_clockwise, 82.77,
                                         2048 * 2.5 * 1.0194, 0}}) {}

haply::SetUp Pantograph::set_up(const std::array<double, 2>& angles_deg) const {
    haply::SetUp made;
    for (std::size_t i = 0; i < 2; ++i) {
        const Arm& arm = arms_[i];
        made.motors[arm.port] = arm.motor;
        made.encoders[arm.port] = haply::EncoderSetUp{arm.encoder, static_cast<float>(angles_deg[i]),
                                                      static_cast<float>(arm.counts_per_turn)};
    }
    return made;
}

std::array<double, 2> Pantograph::reference_deg() const {
    return {arms_[0].reference_deg, arms_[1].reference_deg};
}

std::array<double, 2> Pantograph::angles_of(const haply::Reply& reply) const {
    return {static_cast<double>(reply.angle_deg[arms_[0].port]),
            static_cast<double>(reply.angle_deg[arms_[1].port])};
}

haply::Reply Pantograph::reply_of(const std::array<double, 2>& angles_deg) const {
    haply::Reply made;
    for (std::size_t i = 0; i < 2; ++i)
        made.angle_deg[arms_[i].port] = static_cast<float>(angles_deg[i]);
    return made;
}

std::optional<Pantograph::Pose> Pantograph::pose_at(const std::array<double, 2>& angles_deg) const {
    const pad::FiveBarPose<double> found = five_bar_pose(base_, angles_deg);
    if (!found.reachable)
        return std::nullopt;
    Pose pose;
    pose.place = {found.place.x, found.place.y};
    // From (P − A)·(Ṗ − Ȧ) = (P − B)·(Ṗ − Ḃ) = 0: the handle turns about one elbow while the other arm moves.
    const double area = pad::cross(found.link[0], found.link[1]);
    for (std::size_t i = 0; i < 2; ++i) {
        const pad::Vec<double> other = found.link[1 - i];
        const double lever = (i == 0 ? 1.0 : -1.0) * pad::dot(found.link[i], found.swing[i]) / area;
        pose.column[i] = lever * Vec2(other.y, -other.x);
    }
    pose.condition = is_finite(pose.column[0]) && is_finite(pose.column[1])
                         ? condition_of(pose.column[0], pose.column[1])
                         : std::numeric_limits<double>::infinity();
    return pose;
}

std::optional<std::array<double, 2>> Pantograph::angles_at(Vec2 place) const {
    std::array<double, 2> angles{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec2 from = place - Vec2(i == 1 ? base_ : 0.0, 0.0);
        const double reach = length(from);
        const double cosine =
            (proximal_mm * proximal_mm + reach * reach - distal_mm * distal_mm) / (2.0 * proximal_mm * reach);
        if (!(std::abs(cosine) <= 1.0))
            return std::nullopt;
        // The first arm's angle rises past 180°, the second's falls below 0: seen from +y, so that neither
        // jumps.
        const double towards = std::atan2(-from.x, from.y) / rad_per_deg + 90.0;
        angles[i] = towards + (i == 0 ? 1.0 : -1.0) * std::acos(cosine) / rad_per_deg;
    }
    return angles;
}

std::array<double, 2> Pantograph::torques(const std::array<double, 2>& angles_deg, Vec2 force) const {
    if (!is_finite(force))
        return {};
    constexpr double newton_mm = 1e-3; // in N·m
    const pad::Torques<double> found = pad::torques(five_bar_pose(base_, angles_deg), {force.x, force.y},
                                                    greatest_torque / newton_mm, least_spread);
    return {newton_mm * found.newton_mm[0], newton_mm * found.newton_mm[1]};
}

haply::Command Pantograph::command_of(const std::array<double, 2>& torques) const {
    haply::Command made;
    for (std::size_t i = 0; i < 2; ++i)
        made.torque[arms_[i].port] = haply::sendable(torques[i]);
    return made;
}

std::array<double, 2> Pantograph::torques_of(const haply::Command& command) const {
    return {static_cast<double>(command.torque[arms_[0].port]),
            static_cast<double>(command.torque[arms_[1].port])};
}

Vec2 Pantograph::middle() const { return {0.5 * base_, 100.0}; }

std::vector<Vec2> Pantograph::workspace() const {
    constexpr int corners = 120;
    constexpr double nearest_y = 15.0; // mm; the motors themselves stand there
    const auto fits = [this](Vec2 place) {
        const auto angles = angles_at(place);
        const auto pose = angles ? pose_at(*angles) : std::nullopt;
        return pose && pose->condition < greatest_condition && place.y >= nearest_y;
    };
    std::vector<Vec2> outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        const Vec2 way(std::cos(angle), std::sin(angle));
        double reach = 0.0;
        for (double stride = 2.0; stride > 0.1; stride *= 0.5) // mm
            while (fits(middle() + (reach + stride) * way))
                reach += stride;
        outline.push_back(middle() + reach * way);
    }
    return outline;
}

double Pantograph::force_in_the_middle() const {
    const auto pose = pose_at(angles_at(middle()).value_or(reference_deg()));
    return pose ? greatest_torque * 1e3 / std::max(length(pose->column[0]), length(pose->column[1])) : 0.0;
}

double Pantograph::resolution() const {
    const auto pose = pose_at(angles_at(middle()).value_or(reference_deg()));
    const double turn = 2.0 * std::numbers::pi;
    return pose ? std::max(turn / arms_[0].counts_per_turn * length(pose->column[0]),
                           turn / arms_[1].counts_per_turn * length(pose->column[1]))
                : 0.0;
}

} // namespace tp
