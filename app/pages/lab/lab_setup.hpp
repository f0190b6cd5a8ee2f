// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/guidance/haptic_scene.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/simulated/simulated_device.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// Everything that the lab's page lets one turn.
struct LabParameters {
    // The law.
    LawKind law = LawKind::exact;
    double stiffness = 0.2;      ///< K, N/mm
    double range = 4.0;          ///< d, mm
    double hold = 0.0;           ///< mm, hysteresis; exact law only, and not with blend
    double blend = 0.0;          ///< mm, radius; exact law only, and not with hold
    bool corner_cue = false;     ///< exact law only
    double vertex_spacing = 1.0; ///< mm; published law only

    // The servo.
    double max_force = 1.5;      ///< N
    double line_damping = 0.1;   ///< ratio, see ServoSettings
    bool energy_observer = true;
    bool strict_limits = false;  ///< the simulated device is switched off as a real one would be

    // The simulated device and the hand that holds it.
    double mass = 0.1;            ///< kg
    double damping = 0.3;         ///< N·s/m
    double friction = 0.0;        ///< N
    double quantum = 0.0;         ///< mm
    double delay = 0.0;           ///< whole ticks
    double hand_stiffness = 0.12; ///< N/mm
    double hand_damping = 5.0;    ///< N·s/m

    // What goes wrong with it.
    double drop = 0.0; ///< share of readings that do not come
    bool silent = false;
    bool refuses = false; ///< takes no force
    bool motors_off = false;
    bool unplugged = false;

    bool operator==(const LabParameters&) const = default;
};

/// What must be done for a changed parameter to be felt.
enum class LabEffect {
    scene, ///< another scene is handed to the loop
    loop,  ///< device and loop are made anew
    live,  ///< told to what runs
};

/// A parameter that is a number, by its name in pages and files.
struct LabNumber {
    const char* key;
    double LabParameters::*member;
    double lowest, highest, step;
    LabEffect effect;
};
/// A parameter that is on or off.
struct LabSwitch {
    const char* key;
    bool LabParameters::*member;
    LabEffect effect;
};
const std::vector<LabNumber>& lab_numbers();
const std::vector<LabSwitch>& lab_switches();
/// Null where there is none of that name.
const LabNumber* lab_number(std::string_view key);
const LabSwitch* lab_switch(std::string_view key);

/// What the servo renders: under the published law the lines as vertices of that spacing. An error as of
/// make_haptic_scene.
Result<std::unique_ptr<HapticScene>> felt_scene(const FlatScene& flat, const LabParameters& parameters);
SimulatedPlant plant_of(const LabParameters& parameters);
/// For a device of that rate, Hz. A drawn finger hurts nobody, and an ordinary desktop is late by times at which a real
/// device must be switched off: its limits are wide unless `strict_limits` or `real`.
ServoSettings servo_settings(const LabParameters& parameters, double rate, bool real);

/// A session's parameters and what was felt in it: enough to compute it again.
struct LabSetup {
    LabParameters parameters;
    std::string scene_name;
    FlatScene scene; ///< as it was before any vertex spacing
    bool real_device = false;
};

/// As JSON, for people and other programs; numbers read back as the same double.
std::string setup_json(const LabSetup& setup);
/// Any bytes. What is missing is as in LabParameters; an error, the end of a sentence, where something is outside of its
/// bounds or is no setup at all.
Result<LabSetup> parse_setup(std::string_view json);

} // namespace tp
