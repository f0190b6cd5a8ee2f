// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/haptic_scene.hpp"

#include <memory>

namespace tp {

/// How differently two force fields feel, over places 0.5 mm apart where at least one of them pulls.
struct FieldDifference {
    double mean_n = 0.0; ///< of |F_after − F_before|
    double p99_n = 0.0;
    double max_n = 0.0;
    double felt_share = 0.0; ///< of the surface, where the difference is above `noticed_n`

    /// The smallest force that a finger notices, as the simulated participant has it (ExplorerManner::felt).
    static constexpr double noticed_n = 0.06;
};
FieldDifference difference_between(const GuidanceLaw& before, const GuidanceLaw& after,
                                   const Rect& surface_mm);

/// The force of one field less that of another, as a field of its own to be drawn. Both must outlive it.
std::unique_ptr<const GuidanceLaw> difference_law(const GuidanceLaw& before, const GuidanceLaw& after);

} // namespace tp
