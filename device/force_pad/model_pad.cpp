// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/model_pad.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace tp {

namespace {

Vec2 mark_of(const pad::PadConfig& config) {
    if (config.kind == pad::PadKind::cables)
        return {config.mark.x, config.mark.y};
    const pad::FiveBarPose<float> pose = pad::locate(config.bars, config.mark_angles);
    return {pose.place.x, pose.place.y};
}

/// Angles of a pantograph's motors with its knob at `place`, rad, elbows outwards: by the law of cosines.
std::array<double, 2> angles_at(const pad::PadConfig& config, Vec2 place) {
    std::array<double, 2> angles{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec2 from = place - Vec2(i == 1 ? config.bars.base : 0.0f, 0.0);
        const double reach = length(from);
        const double proximal = config.bars.proximal;
        const double distal = config.bars.distal;
        const double cosine =
            (proximal * proximal + reach * reach - distal * distal) / (2.0 * proximal * reach);
        angles[i] =
            std::atan2(from.y, from.x) + (i == 0 ? 1.0 : -1.0) * std::acos(std::clamp(cosine, -1.0, 1.0));
    }
    return angles;
}

} // namespace

ModelPad::ModelPad(const pad::PadConfig& config, const PadPlant& plant)
    : config_(config), plant_(plant), firmware_(config) {
    knob_.put(mark_of(config));
    // As a pad that was homed when it was switched on.
    firmware_.step(sensors());
    firmware_.receive(pad::encode(pad::CalibrateFrame{}));
    pad::Frame answer;
    firmware_.answer(answer);
}

pad::Sensors ModelPad::sensors() {
    pad::Sensors seen;
    seen.time_us = time_us_;
    const double counts = static_cast<double>(config_.counts_per_turn) / (2.0 * std::numbers::pi);
    if (config_.kind == pad::PadKind::cables) {
        for (int i = 0; i < pad::cable_count; ++i) {
            const pad::Vec<float> exit = config_.cables.exits[i];
            const Vec2 at(exit.x, exit.y);
            const double mm = length(at - knob_.place) - length(at - mark_of(config_)) +
                              troubles.slip_mm[static_cast<std::size_t>(i)];
            seen.counts[i] = static_cast<std::int32_t>(
                std::lround(counts * mm / static_cast<double>(config_.drum_radius)));
        }
    } else {
        const std::array<double, 2> angles = angles_at(config_, knob_.place);
        for (std::size_t i = 0; i < 2; ++i)
            seen.counts[i] = static_cast<std::int32_t>(
                std::lround(counts * (angles[i] - static_cast<double>(config_.mark_angles[i]))));
    }
    seen.celsius = troubles.celsius;
    for (std::uint16_t& current : seen.current_ma)
        current = troubles.current_ma;
    return seen;
}

Vec2 ModelPad::force_of(const pad::Drive& drive, Vec2 place) const {
    Vec2 force(0.0);
    if (!drive.powered)
        return force;
    if (config_.kind == pad::PadKind::cables) {
        for (int i = 0; i < pad::cable_count; ++i) {
            const pad::Vec<float> exit = config_.cables.exits[i];
            const Vec2 way = Vec2(exit.x, exit.y) - place;
            const double distance = length(way);
            if (distance > 0.0)
                force +=
                    (1e-3 * drive.torque_unm[i] / static_cast<double>(config_.drum_radius) / distance) * way;
        }
        return force;
    }
    const std::array<double, 2> angles = angles_at(config_, place);
    for (std::size_t i = 0; i < 2; ++i) {
        const double proximal = config_.bars.proximal;
        const Vec2 elbow(proximal * std::cos(angles[i]) +
                             (i == 1 ? static_cast<double>(config_.bars.base) : 0.0),
                         proximal * std::sin(angles[i]));
        const Vec2 link = place - elbow;
        const Vec2 swing(-proximal * std::sin(angles[i]), proximal * std::cos(angles[i]));
        const double lever = glm::dot(link, swing);
        if (std::abs(lever) > 1e-6)
            force += (1e-3 * drive.torque_unm[i] / lever) * link;
    }
    return force;
}

void ModelPad::step() {
    time_us_ += 1000;
    const pad::Drive drive = firmware_.step(sensors());
    state_due_ = true;
    force_ = knob_.step(plant_, [&](Vec2 place) { return force_of(drive, place); });
}

bool ModelPad::report(pad::Frame& frame) {
    if (firmware_.answer(frame))
        return true;
    if (!state_due_)
        return false;
    state_due_ = false;
    frame = firmware_.state();
    return true;
}

} // namespace tp
