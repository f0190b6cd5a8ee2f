// SPDX-License-Identifier: Apache-2.0
#include "app/figures/simulated/simulated_kinds.hpp"

#include "device/falcon/falcon.hpp"
#include "device/falcon/model_falcon.hpp"
#include "device/force_pad/firmware/pad_firmware.hpp"
#include "device/handle_body.hpp"
#include "device/haply_2diy/model_board.hpp"
#include "device/haply_2diy/pantograph.hpp"
#include "device/simulated/simulated_device.hpp"

#include <algorithm>

namespace tp {
namespace {

template <typename Plant>
SimulatedBody body_of(const Plant& plant) {
    SimulatedBody body;
    body.mass_kg = plant.mass;
    body.damping_n_s_per_m = plant.damping;
    body.coulomb_n = plant.coulomb;
    return body;
}

/// The pantograph that the firmware can be built for.
SimulatedKind pad_kind() {
    const pad::PadConfig config = pad::pantograph_pad();
    SimulatedKind kind{"pad", static_cast<double>(config.rate_hz), 1e-6 * config.delay_us,
                       body_of(HandlePlant{})};
    kind.body.max_force_n = static_cast<double>(config.max_force);
    kind.body.continuous_force_n = static_cast<double>(config.continuous_force);
    kind.body.quantum_mm = 1e-3 * config.resolution_um;
    return kind;
}

/// Unmeasured, as the back end takes it (device/hid_pid/pid_joystick.cpp): 2 N, two reports each way; 16 bits over ±60 mm.
SimulatedKind joystick_kind() {
    SimulatedKind kind{"stick", 1000.0, 0.004, body_of(HandlePlant{})};
    kind.body.max_force_n = kind.body.continuous_force_n = 2.0;
    kind.body.quantum_mm = 120.0 / 65535.0;
    return kind;
}

/// Delay and steps as device/falcon/falcon.cpp takes them.
SimulatedKind falcon_kind() {
    SimulatedKind kind{"falcon", 1000.0, 0.002, body_of(FalconPlant{})};
    kind.body.max_force_n = kind.body.continuous_force_n = Falcon::max_force;
    kind.body.quantum_mm = 0.05;
    return kind;
}

/// Delay and the share of its force that it has for ever as device/haply_2diy/haply_2diy.cpp takes them.
SimulatedKind haply_kind() {
    const Pantograph arms(HaplyGeneration::third);
    SimulatedKind kind{"2diy", 1000.0, 0.002, body_of(HaplyPlant{})};
    kind.body.max_force_n = arms.force_in_the_middle();
    kind.body.continuous_force_n = 0.47 * kind.body.max_force_n;
    kind.body.quantum_mm = arms.resolution();
    return kind;
}

SimulatedKind mouse_kind() {
    SimulatedKind kind{"mouse", 1000.0, 0.0, body_of(SimulatedPlant{})};
    kind.body.drawn = true;
    return kind;
}

} // namespace

const std::vector<SimulatedKind>& simulated_kinds() {
    static const std::vector<SimulatedKind> kinds{pad_kind(), joystick_kind(), falcon_kind(), haply_kind(),
                                                  mouse_kind()};
    return kinds;
}

std::optional<SimulatedKind> simulated_kind(std::string_view name) {
    const auto found = std::ranges::find(simulated_kinds(), name, &SimulatedKind::name);
    return found == simulated_kinds().end() ? std::nullopt : std::optional(*found);
}

} // namespace tp
