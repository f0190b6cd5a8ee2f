// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/simulated/simulated_trial.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace tp {

/// A device by name, as far as a simulated person meets it: "pad", "stick", "falcon", "2diy", or "mouse", where the finger is drawn.
struct SimulatedKind {
    std::string_view name;
    double rate_hz = 1000.0;
    double delay_s = 0.0; ///< between a force and its acting
    SimulatedBody body;
};

/// Rates, delays, forces, masses, friction and steps are those of the back ends of `device`, and of the models behind which they are
/// tested; none was measured on hardware. How far a device reaches is left out: each reaches all of the surface.
const std::vector<SimulatedKind>& simulated_kinds();
std::optional<SimulatedKind> simulated_kind(std::string_view name);

} // namespace tp
