// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/haptic_scene.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace tp {

/// One experiment: a handle that is held across a straight line until the whole force is let in, and then let go.
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
    double hand_damping = 0.0; ///< N·s/m, of a hand that rests on the handle; no device tells of it
    double stretch = 1.0;      ///< mm of the surface in a mm of the device, by the calibration
    std::optional<std::size_t> told_delay; ///< ticks, what the device tells; nothing: the truth
    std::optional<double> told_damping;    ///< N·s/m; likewise
    std::size_t jitter = 0;                ///< ticks by which each write acts later yet, at random
    double start_share = 1.0;              ///< of the range, where it is held

    /// The damping below which a sampled, delayed spring swings, K (T/2 + nT) in N·s/m, as the device feels K: a
    /// stretch acts twice (Colgate & Schenkel 1997).
    double bound() const {
        return 1e3 * stretch * stretch * stiffness * period * (0.5 + static_cast<double>(delay));
    }
};

struct HandleResult {
    double amplitude_mm = 0.0; ///< largest distance from the line in the last second
    double frequency_hz = 0.0; ///< of the swing that is left; 0 where it has settled
    bool settled = false;      ///< on the line to 0.1 mm in the last second, or moving less than that
    double start_mm = 0.0;     ///< from the line, where it was let go
    double farthest_mm = 0.0;  ///< from the line, from then on
    bool swings = false;       ///< not settled, and no nearer to it than two seconds before: no slow decay
};

/// Lets the handle go and watches it for `seconds` of simulated time, through the whole servo loop and its safety chain.
/// Millimetres are the surface's. The plant is exact (PlantMotion).
HandleResult release_handle(const HandleCase& handle, double seconds = 12.0);

/// What a device with a fifth more damping than the bound K (T/2 + nT) has to hold: 216 handles, which start at the
/// range d, the strongest pull: K 0.1, 0.2, 0.5 N/mm, d 2, 4, 8 mm, m 0.05, 0.1, 0.2 kg, delays of 0, 1, 2 and 4 ms at
/// 1 ms, of 0 and 4 ms at 0.25 and 4 ms.
std::vector<HandleCase> bounded_handles();
/// The same at 1 ms and d 2, 4, 10 mm with a hand on it, dry friction, a stretched calibration, coarser steps, a delay or a
/// damping told wrongly, a delay that jitters, let go elsewhere.
std::vector<HandleCase> troubled_handles();

/// The grid of the report: K × T × n × b × m, observer and damping off and on, both laws where `quick` is not
/// set; bounded_handles; and, where `quick` is not set, troubled_handles.
std::vector<HandleCase> handle_grid(bool quick);

} // namespace tp
