// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/haptic_scene.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace tp {

/// One experiment: a handle that nobody holds is let go beside a straight line.
struct HandleCase {
    LawKind law = LawKind::exact;
    double stiffness = 0.2; ///< N/mm
    double range = 4.0;     ///< mm
    double period = 0.001;  ///< s
    std::size_t delay = 0;  ///< ticks between a write and its acting
    double mass = 0.1;      ///< kg
    double damping = 0.1;   ///< N·s/m, of the device
    double coulomb = 0.0;   ///< N
    double quantum = 0.02;  ///< mm
    bool observer = true;
    bool line_damping = true;

    /// The damping below which a sampled, delayed spring swings, K (T/2 + nT) in N·s/m (Colgate & Schenkel
    /// 1997).
    double bound() const { return 1e3 * stiffness * period * (0.5 + static_cast<double>(delay)); }
};

struct HandleResult {
    double amplitude_mm = 0.0; ///< largest distance from the line in the last second
    double frequency_hz = 0.0; ///< of the swing that is left; 0 where it has settled
    bool settled = false;      ///< amplitude below 0.1 mm
};

/// Releases the handle from the worst of several places within the band and watches it for `seconds` of
/// simulated time, through the whole servo loop and its safety chain.
HandleResult release_handle(const HandleCase& handle, double seconds = 6.0);

/// The grid of the report: K × T × n × b × m, observer and damping off and on, both laws where `quick` is not
/// set.
std::vector<HandleCase> handle_grid(bool quick);

} // namespace tp
